#include "tests/server/store_ledger.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"

namespace lares::store::testing {
namespace {

constexpr DocumentKind kKind = DocumentKind::kRecipe;

std::map<std::string, std::string> LayersOf(const EnvironmentVersion& version) {
  std::map<std::string, std::string> layers;
  for (const LayerInfo& layer : version.layers) layers[layer.name] = layer.blob.sha256;
  return layers;
}

class Comparison {
 public:
  Comparison(const Store& store, const Ledger& ledger, std::set<std::string> under_way)
      : store_(store), ledger_(ledger), under_way_(std::move(under_way)) {}

  std::vector<std::string> Run() {
    for (const auto& [sha256, bytes] : ledger_.blobs) CompareBlob(sha256, bytes);
    for (const auto& [id, versions] : ledger_.documents) CompareDocument(id, versions);
    for (const auto& [id, versions] : ledger_.environments) CompareEnvironment(id, versions);
    for (const DocumentInfo& info : store_.ListDocuments(kKind)) {
      Expect(ledger_.documents.count(info.id) != 0 || IsKnown(info.id),
             info.id + " is listed, but was never put");
    }
    for (const EnvironmentInfo& info : store_.ListEnvironments()) {
      Expect(ledger_.environments.count(info.id) != 0 || IsKnown(info.id),
             info.id + " is listed, but was never put");
    }
    return missing_;
  }

 private:
  bool IsKnown(const std::string& id) const {
    return under_way_.count(id) != 0 || ledger_.of_others.count(id) != 0;
  }
  bool IsUnderWay(const std::string& id) const { return under_way_.count(id) != 0; }
  void Expect(bool holds, const std::string& otherwise) {
    if (!holds) missing_.push_back(otherwise);
  }
  void ExpectCount(const std::string& id, std::size_t count, std::size_t acknowledged) {
    Expect(count == acknowledged || (IsUnderWay(id) && count == acknowledged + 1),
           id + " has " + std::to_string(count) + " versions, acknowledged were " +
               std::to_string(acknowledged));
  }

  void CompareBlob(const std::string& sha256, const std::string& bytes) {
    try {
      Expect(store_.ReadBlob(sha256) == bytes, "blob " + sha256 + " has other bytes");
    } catch (const Error& error) {
      missing_.push_back(error.what());
    }
  }

  void CompareDocument(const std::string& id, const std::vector<std::string>& versions) {
    try {
      ExpectCount(id, store_.DocumentLog(kKind, id).size(), versions.size());
      for (std::size_t i = 0; i < versions.size(); ++i) {
        const DocumentInfo info = store_.GetDocument(kKind, id, static_cast<int>(i) + 1);
        Expect(store_.ReadBlob(info.blob.sha256) == versions[i],
               id + " version " + std::to_string(i + 1) + " has other bytes");
      }
    } catch (const Error& error) {
      missing_.push_back(error.what());
    }
    if (IsUnderWay(id)) return;
    const auto deleted = ledger_.deleted.find(id);
    const bool present = deleted == ledger_.deleted.end() || !deleted->second;
    Expect(store_.FindDocument(kKind, id).has_value() == present,
           id + (present ? " was not deleted, but is absent" : " was deleted, but is there"));
  }

  void CompareEnvironment(const std::string& id,
                          const std::vector<std::map<std::string, std::string>>& versions) {
    try {
      ExpectCount(id, store_.Log(id).size(), versions.size());
      for (std::size_t i = 0; i < versions.size(); ++i) {
        Expect(LayersOf(store_.GetVersion(id, static_cast<int>(i) + 1)) == versions[i],
               id + " version " + std::to_string(i + 1) + " has other layers");
      }
    } catch (const Error& error) {
      missing_.push_back(error.what());
    }
  }

  const Store& store_;
  const Ledger& ledger_;
  std::set<std::string> under_way_;
  std::vector<std::string> missing_;
};

}  // namespace

std::vector<std::string> Missing(const Store& store, const Ledger& ledger,
                                 const std::set<std::string>& under_way) {
  return Comparison(store, ledger, under_way).Run();
}

void Absorb(const Store& store, const std::set<std::string>& under_way, Ledger& ledger) {
  for (const std::string& id : under_way) {
    const auto document = store.FindDocument(kKind, id);
    if (document) {
      auto& versions = ledger.documents[id];
      versions.resize(static_cast<std::size_t>(document->version));
      versions.back() = store.ReadBlob(document->blob.sha256);
    }
    if (ledger.documents.count(id) != 0) ledger.deleted[id] = !document;
    if (const auto environment = store.FindEnvironment(id)) {
      auto& versions = ledger.environments[id];
      versions.resize(static_cast<std::size_t>(environment->latest));
      versions.back() = LayersOf(store.GetVersion(id, 0));
    }
  }
}

}  // namespace lares::store::testing
