#include "tests/reasoner/sparql/w3c_cases.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::sparql::testing {
namespace {

using rdf::Document;
using rdf::Statement;

constexpr std::string_view kManifest = "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
constexpr std::string_view kQuery = "http://www.w3.org/2001/sw/DataAccess/tests/test-query#";

Document ReadFrom(const std::filesystem::path& file, const std::string& base) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  options.base_iri = base + file.filename().string();
  const std::string text = ReadFile(file);
  return rdf::ReadRdf(text, rdf::GuessFormat("", options.source, text), options);
}

class Manifest {
 public:
  Manifest(const std::filesystem::path& file, const std::string& base)
      : base_(base), document_(ReadFrom(file, base)) {
    for (const Statement& s : document_.statements) {
      const std::string& predicate = document_.terms[s.predicate].value;
      rows_[s.subject][predicate].push_back(s.object);
      if (predicate == std::string(rdf::kRdf) + "first") listed_.insert(s.object);
    }
  }

  std::vector<Case> Cases() const {
    std::vector<Case> cases;
    for (const auto& [subject, row] : rows_) {
      const auto kinds = All(subject, rdf::kRdf, "type");
      const auto actions = All(subject, kManifest, "action");
      if (kinds.empty() || actions.empty() || listed_.count(subject) == 0) continue;
      const std::string kind = document_.terms[kinds[0]].value.substr(kManifest.size());
      const std::string id = document_.terms[subject].value;
      Case test{id.substr(id.find('#') + 1), kind, "", "", {}, {}};
      const auto queries = All(actions[0], kQuery, "query");
      test.query = Local(queries.empty() ? actions[0] : queries[0]);
      for (const std::uint32_t file : All(actions[0], kQuery, "data")) {
        test.data.push_back(Local(file));
      }
      for (const std::uint32_t file : All(actions[0], kQuery, "graphData")) {
        test.graphs.push_back(Local(file));
      }
      for (const std::uint32_t file : All(subject, kManifest, "result")) test.result = Local(file);
      cases.push_back(std::move(test));
    }
    return cases;
  }

 private:
  std::vector<std::uint32_t> All(std::uint32_t subject, std::string_view space,
                                 std::string_view name) const {
    const auto row = rows_.find(subject);
    if (row == rows_.end()) return {};
    const auto value = row->second.find(std::string(space) + std::string(name));
    return value == row->second.end() ? std::vector<std::uint32_t>{} : value->second;
  }
  std::string Local(std::uint32_t term) const {
    const std::string& iri = document_.terms[term].value;
    return iri.starts_with(base_) ? iri.substr(base_.size()) : iri;
  }

  std::string base_;
  Document document_;
  std::set<std::uint32_t> listed_;  // in mf:entries
  std::map<std::uint32_t, std::map<std::string, std::vector<std::uint32_t>>> rows_;
};

// The graphs of one case.
class Graphs {
 public:
  Graphs(const std::filesystem::path& folder, std::string base)
      : folder_(folder), base_(std::move(base)) {}

  std::shared_ptr<rdf::Graph> Read(const std::vector<std::string>& files) {
    auto graph = std::make_shared<rdf::Graph>();
    for (const std::string& file : files) {
      rdf::Graph one = rdf::MakeGraph(ReadFrom(folder_ / file, base_),
                                      "g" + std::to_string(++count_), {}, *dictionary_);
      graph->triples.insert(graph->triples.end(), one.triples.begin(), one.triples.end());
    }
    std::sort(graph->triples.begin(), graph->triples.end());
    graph->triples.erase(std::unique(graph->triples.begin(), graph->triples.end()),
                         graph->triples.end());
    return graph;
  }

  Dataset Make(const Case& test, const std::vector<std::string>& from_clauses) {
    std::vector<rdf::Graph> graphs{*Read(test.data)};
    const auto layer = std::make_shared<const rdf::Layer>(
        std::move(graphs), std::vector<rdf::Triple>(), std::vector<rdf::Clash>());
    Dataset dataset{rdf::View(dictionary_).With(layer), {}};
    std::vector<std::string> names = test.graphs;
    for (const std::string& iri : from_clauses) {
      if (iri.starts_with(base_)) names.push_back(iri.substr(base_.size()));
    }
    std::map<std::string, bool> known;
    for (const std::string& name : names) {
      if (!known.emplace(name, true).second) continue;
      auto graph = Read({name});
      dataset.named.push_back({base_ + name, graph->triples, graph});
    }
    return dataset;
  }

 private:
  std::filesystem::path folder_;
  std::string base_;
  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  int count_ = 0;
};

std::vector<std::string> FromClauses(const std::string& text, const std::string& base) {
  std::vector<std::string> iris;
  for (std::size_t at = text.find("FROM"); at != std::string::npos;
       at = text.find("FROM", at + 4)) {
    const std::size_t begin = text.find('<', at);
    const std::size_t end = text.find('>', at);
    if (begin == std::string::npos || end == std::string::npos || begin > end) break;
    iris.push_back(base + text.substr(begin + 1, end - begin - 1));
  }
  return iris;
}

}  // namespace

Unpacked::Unpacked(const std::filesystem::path& archive) {
  std::string pattern = (std::filesystem::temp_directory_path() / "lares-sparql-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) return;
  folder_ = pattern;
  const std::string command = "tar -xzf '" + archive.string() + "' -C '" + pattern + "'";
  is_ready_ = std::system(command.c_str()) == 0;
}

Unpacked::~Unpacked() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

std::string BaseOf(const std::string& folder_name) {
  return "https://w3c.github.io/rdf-tests/sparql/" + folder_name + "/";
}

std::vector<Case> ReadManifest(const std::filesystem::path& folder, const std::string& base) {
  return Manifest(folder / "manifest.ttl", base).Cases();
}

Dataset ReadDataset(const Case& test, const std::filesystem::path& folder, const std::string& base,
                    const std::string& text) {
  return Graphs(folder, base).Make(test, FromClauses(text, base));
}

}  // namespace lares::sparql::testing
