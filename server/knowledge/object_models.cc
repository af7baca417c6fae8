// Object models: what is known of them, and found by it.
#include "server/knowledge/object_models.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

using nlohmann::json;
using recipes::Resource;
using Fit = ObjectModelInfo::Fit;

Resource ToResource(const json& value) {
  return {value.value("iri", ""), value.value("label", ""), value.value("as_written", "")};
}

json ListOf(const json& details, const char* name) {
  const auto found = details.find(name);
  return found != details.end() && found->is_array() ? *found : json::array();
}

// Whether `below` is `above` or under it.
class Hierarchy {
 public:
  explicit Hierarchy(const rdf::View& view)
      : view_(view),
        sub_class_(view.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf")) {}

  bool IsUnder(const std::string& below, const std::string& above) const {
    if (below == above) return true;
    const auto low = view_.dictionary().FindIri(below);
    const auto high = view_.dictionary().FindIri(above);
    return low && high && view_.Contains({*low, sub_class_, *high});
  }
  bool AnyIsUnder(const std::vector<std::string>& classes, const std::string& above) const {
    return std::any_of(classes.begin(), classes.end(),
                       [&](const std::string& one) { return IsUnder(one, above); });
  }

 private:
  const rdf::View& view_;
  rdf::TermId sub_class_;
};

// The best that any class of the model does for `wanted`; nothing when none does.
std::optional<Fit> FitOf(const Hierarchy& hierarchy, const ObjectModelInfo& info,
                         const std::string& wanted) {
  std::optional<Fit> best;
  for (std::size_t i = 0; i < info.classes.size(); ++i) {
    const std::string& of = info.classes[i].iri;
    std::optional<Fit> fit;
    if (of == wanted) {
      fit = Fit::kSame;
    } else if (hierarchy.IsUnder(of, wanted) || hierarchy.AnyIsUnder(info.above[i], wanted)) {
      fit = Fit::kKindOf;
    } else if (hierarchy.IsUnder(wanted, of)) {
      fit = Fit::kMoreGeneral;
    }
    if (fit && (!best || *fit < *best)) best = fit;
  }
  return best;
}

bool IsMadeBy(const ObjectModelInfo& info, const std::string& maker, const std::string& iri) {
  const std::string wanted = ToLower(maker);
  return std::any_of(info.makers.begin(), info.makers.end(), [&](const Resource& one) {
    return one.iri == iri || one.as_written == maker ||
           (!one.iri.empty() && ToLower(LocalName(one.iri)) == wanted) ||
           ToLower(one.label).find(wanted) != std::string::npos;
  });
}

bool UsesAlgorithm(const Hierarchy& hierarchy, const ObjectModelInfo& info,
                   const std::string& wanted) {
  return std::any_of(info.algorithms.begin(), info.algorithms.end(), [&](const auto& algorithm) {
    return algorithm.what.iri == wanted || hierarchy.AnyIsUnder(algorithm.classes, wanted);
  });
}

std::vector<std::string> Iris(const std::vector<Resource>& resources) {
  std::vector<std::string> iris;
  for (const Resource& resource : resources) iris.push_back(resource.iri);
  return iris;
}

}  // namespace

ObjectModelInfo ReadObjectModel(store::DocumentInfo document) {
  ObjectModelInfo info;
  const json details = json::parse(document.details_json);
  for (const json& model : ListOf(details, "models")) {
    info.classes.push_back(ToResource(model.at("class")));
    info.above.push_back(model.value("above", std::vector<std::string>{}));
  }
  for (const json& kind : ListOf(details, "kinds")) info.kinds.push_back(ToResource(kind));
  for (const json& algorithm : ListOf(details, "algorithms")) {
    info.algorithms.push_back(
        {ToResource(algorithm), algorithm.value("classes", std::vector<std::string>{})});
  }
  for (const json& maker : ListOf(details, "makers")) info.makers.push_back(ToResource(maker));
  info.created = details.value("created", "");
  if (details.contains("extents")) {
    const json& extents = details["extents"];
    info.extents = {extents.at("size_m").get<std::array<double, 3>>(),
                    extents.at("axes_known").get<bool>(), extents.at("from").get<std::string>()};
  }
  info.size_bytes = document.blob.size;
  for (const json& file : ListOf(details, "files")) {
    info.files.push_back({file.at("file_name"),
                          file.at("media_type"),
                          {file.at("sha256"), file.at("size").get<std::uint64_t>()}});
    info.size_bytes += info.files.back().blob.size;
  }
  info.document = std::move(document);
  return info;
}

std::vector<ObjectModelInfo> StoredObjectModels(const store::Store& store) {
  std::vector<ObjectModelInfo> stored;
  for (auto& document : store.ListDocuments(store::DocumentKind::kObjectModel)) {
    stored.push_back(ReadObjectModel(std::move(document)));
  }
  return stored;
}

models::Candidate ToCandidate(const ObjectModelInfo& info) {
  models::Candidate candidate;
  candidate.id = info.document.id;
  candidate.size_bytes = info.size_bytes;
  for (std::size_t i = 0; i < info.classes.size(); ++i) {
    candidate.kinds.push_back({info.classes[i].iri, info.above[i]});
  }
  for (const auto& algorithm : info.algorithms) {
    // One that is only named in words cannot be looked for in a robot.
    if (!algorithm.what.iri.empty()) {
      candidate.algorithms.push_back({algorithm.what.iri, algorithm.classes});
    }
  }
  return candidate;
}

std::vector<ObjectModelInfo> Knowledge::ObjectModels(const ObjectModelQuery& query) {
  const auto resolved = [&](const std::string& name) {
    return name.empty() ? "" : ResolveClass(name).iri;
  };
  const std::string of = resolved(query.class_name);
  const std::string algorithm = resolved(query.algorithm);
  const std::string kind = resolved(query.kind);
  const auto catalogue = state_->catalogue();
  const Hierarchy hierarchy(catalogue->view);
  std::map<std::string, models::Choice> typical;
  if (!query.room.empty()) {
    TypicalRequest request;
    request.room = query.room;
    request.min_probability = 0;
    for (auto& model : TypicalModels(request).loaded) {
      typical.emplace(model.info.document.id, std::move(model.choice));
    }
  }
  std::vector<ObjectModelInfo> found;
  for (ObjectModelInfo& info : StoredObjectModels(state_->store)) {
    if (!of.empty()) {
      const auto fit = FitOf(hierarchy, info, of);
      if (!fit) continue;
      info.fit = *fit;
    }
    if (!query.room.empty()) {
      const auto choice = typical.find(info.document.id);
      if (choice == typical.end()) continue;
      info.probability = choice->second.probability;
      info.why = choice->second.why;
    }
    if (!query.maker.empty() &&
        !IsMadeBy(info, query.maker, state_->aliases.Canonical(query.maker))) {
      continue;
    }
    if (!algorithm.empty() && !UsesAlgorithm(hierarchy, info, algorithm)) continue;
    if (!kind.empty() && !hierarchy.AnyIsUnder(Iris(info.kinds), kind)) continue;
    found.push_back(std::move(info));
  }
  return found;
}

}  // namespace lares::server
