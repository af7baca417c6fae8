#include "server/knowledge/model_description.h"

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "mapping/objects/extents.h"
#include "mapping/semantic/most_specific_class.h"
#include "mapping/semantic/names.h"
#include "mapping/semantic/values.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::server {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxModels = 1000;  // of one description
constexpr std::size_t kMaxAbove = 256;    // classes that one is put under

json ToJson(const recipes::Resource& resource) {
  return {{"iri", resource.iri}, {"label", resource.label}, {"as_written", resource.as_written}};
}

class Describer {
 public:
  Describer(const CatalogueState& catalogue, const rdf::View& view, const rdf::Graph& graph)
      : catalogue_(catalogue), view_(view), graph_(graph), names_(view.dictionary()) {}

  json Run() {
    FindModels();
    json described{{"models", Models()}, {"kinds", Kinds()},    {"algorithms", Algorithms()},
                   {"makers", Makers()}, {"object_ids", Ids()}, {"links", Links()}};
    for (const rdf::TermId model : models_) {
      for (const rdf::TermId time : Stated(model, Lares("creationDateTime"))) {
        described["created"] = Text(time);
      }
    }
    const json size = StatedSize();
    if (!size.is_null()) described["stated_size_m"] = size;
    return described;
  }

 private:
  rdf::TermId Iri(std::string_view space, std::string_view name) const {
    return view_.dictionary().InternIri(std::string(space) + std::string(name));
  }
  rdf::TermId Lares(std::string_view name) const { return Iri(rdf::kLares, name); }
  std::string Text(rdf::TermId term) const {
    return std::string(view_.dictionary().Get(term).value);
  }
  bool IsLiteral(rdf::TermId term) const {
    return view_.dictionary().Kind(term) == rdf::TermKind::kLiteral;
  }

  // What the document itself states, in no order to rely on.
  std::vector<rdf::TermId> Stated(rdf::TermId subject, rdf::TermId predicate) const {
    std::vector<rdf::TermId> objects;
    const rdf::Triple first{subject, predicate, rdf::TermId{}};
    for (auto triple = std::lower_bound(graph_.triples.begin(), graph_.triples.end(), first);
         triple != graph_.triples.end() && triple->subject == subject &&
         triple->predicate == predicate;
         ++triple) {
      objects.push_back(triple->object);
    }
    return objects;
  }

  void FindModels() {
    const rdf::TermId provides = Lares("providesModelFor");
    for (const rdf::Triple& triple : graph_.triples) {
      if (triple.predicate != provides) continue;
      if (IsLiteral(triple.object)) {
        throw Error(Code::kInvalid, semantic::Quoted(view_, triple.subject) +
                                        " provides a model for a text, not for a class: '" +
                                        Text(triple.object) + "'");
      }
      provided_.push_back(triple);
      if (models_.empty() || models_.back() != triple.subject) models_.push_back(triple.subject);
    }
    if (provided_.size() > kMaxModels) {
      throw Error(Code::kInvalid, "describes more than " + std::to_string(kMaxModels) +
                                      " models: put each as a document of its own");
    }
    if (provided_.empty()) {
      throw Error(Code::kInvalid, "describes no object model: nothing has providesModelFor");
    }
  }

  json Models() const {
    json models = json::array();
    for (const rdf::Triple& triple : provided_) {
      models.push_back({{"model", ToJson(Describe(view_, triple.subject))},
                        {"class", ToJson(Describe(view_, triple.object))},
                        {"above", Above(triple.object)}});
    }
    return models;
  }

  // The classes that the document itself puts `kind` under, through its own, nearest first. A
  // single thing stands under its types.
  json Above(rdf::TermId kind) const {
    std::set<rdf::TermId> seen{kind};
    std::deque<rdf::TermId> open{kind};
    json above = json::array();
    while (!open.empty() && above.size() < kMaxAbove) {
      const rdf::TermId at = open.front();
      open.pop_front();
      for (const rdf::TermId up :
           {names_.sub_class_of, Iri(rdf::kOwl, "equivalentClass"), names_.type}) {
        if (up == names_.type && at != kind) continue;
        for (const rdf::TermId super : Stated(at, up)) {
          if (view_.dictionary().Kind(super) != rdf::TermKind::kIri || IsOfOwl(super)) continue;
          if (!seen.insert(super).second) continue;
          above.push_back(Text(super));
          open.push_back(super);
        }
      }
    }
    return above;
  }

  bool IsOfOwl(rdf::TermId term) const { return Text(term).starts_with(rdf::kOwl); }

  json Kinds() const {
    json kinds = json::array();
    std::set<rdf::TermId> seen;
    for (const rdf::TermId model : models_) {
      for (const rdf::TermId kind : Stated(model, names_.type)) {
        const bool is_class = view_.dictionary().Kind(kind) == rdf::TermKind::kIri;
        if (is_class && !IsOfOwl(kind) && seen.insert(kind).second) {
          kinds.push_back(ToJson(Describe(view_, kind)));
        }
      }
    }
    return kinds;
  }

  json Algorithms() const {
    json algorithms = json::array();
    std::set<rdf::TermId> seen;
    const auto add = [&](rdf::TermId term) {
      if (!seen.insert(term).second) return;
      json algorithm = ToJson(Describe(view_, term));
      algorithm["classes"] = ComponentsOf(term);
      algorithms.push_back(algorithm);
    };
    for (const rdf::TermId model : models_) {
      for (const rdf::TermId term : Stated(model, Lares("createdByAlgorithm"))) {
        IsLiteral(term) ? AddNamed(Text(term), algorithms) : add(term);
      }
      for (const rdf::TermId term : Stated(model, Lares("forAlgorithm"))) {
        IsLiteral(term) ? AddNamed(Text(term), algorithms) : add(term);
      }
    }
    return algorithms;
  }

  // An algorithm named in words: the kind of program of that name, where there is one.
  void AddNamed(const std::string& name, json& algorithms) const {
    const auto named = catalogue_.classes_by_name.find(ToLower(name));
    if (named != catalogue_.classes_by_name.end() && named->second.size() == 1 &&
        view_.Contains({named->second.front(), names_.sub_class_of, Lares("SoftwareComponent")})) {
      json algorithm = ToJson(Describe(view_, named->second.front()));
      algorithm["classes"] = {Text(named->second.front())};
      algorithms.push_back(algorithm);
      return;
    }
    algorithms.push_back({{"iri", ""}, {"label", name}, {"as_written", name}});
  }

  json ComponentsOf(rdf::TermId term) const {
    const bool is_class = view_.Contains({term, names_.type, names_.owl_class}) ||
                          view_.Estimate({term, names_.sub_class_of, rdf::kAnyTerm}) > 0;
    if (is_class) return {Text(term)};
    const auto type = semantic::MostSpecificClass(view_, names_, term);
    return type ? json{Text(*type)} : json::array();
  }

  json Makers() const {
    json makers = json::array();
    std::set<rdf::TermId> seen;
    for (const rdf::TermId model : models_) {
      for (const rdf::TermId property :
           {Lares("createdBy"), Iri("http://purl.org/dc/terms/", "creator"),
            Iri("http://purl.org/dc/elements/1.1/", "creator")}) {
        for (const rdf::TermId maker : Stated(model, property)) {
          if (!seen.insert(maker).second) continue;
          makers.push_back(IsLiteral(maker)
                               ? json{{"iri", ""}, {"label", Text(maker)}, {"as_written", ""}}
                               : ToJson(Describe(view_, maker)));
        }
      }
    }
    return makers;
  }

  json Ids() const {
    json ids = json::array();
    for (const rdf::TermId model : models_) {
      for (const char* property : {"objectID", "roboearthObjID"}) {
        for (const rdf::TermId id : Stated(model, Lares(property))) ids.push_back(Text(id));
      }
    }
    return ids;
  }

  // Addresses are kept as they are: nothing is ever fetched.
  json Links() const {
    json links = json::array();
    for (const rdf::TermId model : models_) {
      for (const char* property : {"linkToRecognitionModel", "linkToImageData", "linkToCADModel",
                                   "pathToCadModel", "linkToImageFile", "hyperlinkTo"}) {
        for (const rdf::TermId to : Stated(model, Lares(property))) {
          links.push_back({{"kind", property}, {"to", Text(to)}});
        }
      }
    }
    return links;
  }

  // Of a model, or of a thing of the class in the same document.
  json StatedSize() const {
    std::vector<rdf::TermId> subjects = models_;
    std::set<rdf::TermId> modelled;
    for (const rdf::Triple& provided : provided_) {
      if (modelled.insert(provided.object).second) subjects.push_back(provided.object);
    }
    for (const rdf::Triple& triple : graph_.triples) {
      if (triple.predicate == names_.type && modelled.contains(triple.object)) {
        subjects.push_back(triple.subject);
      }
    }
    for (const rdf::TermId subject : subjects) {
      const auto width_m = Side(subject, names_.width, "widthOfObject");
      const auto height_m = Side(subject, names_.height, "heightOfObject");
      const auto depth_m = Side(subject, names_.depth, "depthOfObject");
      if (width_m && height_m && depth_m) return {*width_m, *height_m, *depth_m};
    }
    return nullptr;
  }

  std::optional<double> Side(rdf::TermId subject, rdf::TermId property, const char* name) const {
    const auto side_m = semantic::FindNumber(view_, {subject}, property, name);
    if (side_m && *side_m < 0) {
      throw Error(Code::kInvalid,
                  semantic::Quoted(view_, subject) + ": " + name + " is less than nothing");
    }
    return side_m;
  }

  const CatalogueState& catalogue_;
  const rdf::View& view_;
  const rdf::Graph& graph_;
  semantic::Names names_;
  std::vector<rdf::Triple> provided_;
  std::vector<rdf::TermId> models_;
};

json MetaToJson(const objects::ModelMeta& meta) {
  json value{{"name", meta.name}, {"kind", meta.kind}, {"faces", meta.faces}};
  if (meta.size) {
    value["size_m"] = {meta.size->width_m, meta.size->height_m, meta.size->depth_m};
  }
  if (meta.scale) value["scale"] = *meta.scale;
  return value;
}

objects::ModelFileFacts FactsOf(const json& file) {
  objects::ModelFileFacts facts;
  if (file.contains("bounds")) facts.bounds = file["bounds"].get<std::array<double, 6>>();
  if (file.contains("meta")) {
    facts.meta.emplace();
    const json& meta = file["meta"];
    if (meta.contains("size_m")) {
      facts.meta->size = {meta["size_m"][0], meta["size_m"][1], meta["size_m"][2]};
    }
    if (meta.contains("scale")) facts.meta->scale = meta["scale"].get<double>();
  }
  return facts;
}

}  // namespace

json DescribeModels(const CatalogueState& catalogue, const rdf::View& view,
                    const rdf::Graph& graph) {
  return Describer(catalogue, view, graph).Run();
}

json DescribeModelFiles(const store::Store& store, const std::vector<AttachedFile>& files) {
  json described = json::array();
  for (const AttachedFile& file : files) {
    const objects::ModelFileFacts facts =
        objects::ReadModelFile(store.BlobPath(file.blob.sha256), file.file_name);
    json one{{"file_name", file.file_name},
             {"media_type", file.media_type},
             {"sha256", file.blob.sha256},
             {"size", file.blob.size}};
    if (facts.points) one["points"] = *facts.points;
    if (facts.bounds) one["bounds"] = *facts.bounds;
    if (facts.meta) one["meta"] = MetaToJson(*facts.meta);
    described.push_back(std::move(one));
  }
  return described;
}

json ExtentsOf(const json& description, const json& files) {
  if (description.contains("stated_size_m")) {
    return {{"size_m", description["stated_size_m"]},
            {"axes_known", true},
            {"from", "its description"}};
  }
  std::vector<objects::NamedFacts> named;
  for (const json& file : files) named.push_back({file.at("file_name"), FactsOf(file)});
  const auto extents = objects::FindExtents(named);
  if (!extents) return nullptr;
  return {
      {"size_m", extents->size_m}, {"axes_known", extents->axes_known}, {"from", extents->from}};
}

}  // namespace lares::server
