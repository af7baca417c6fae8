// Environments: a semantic layer is understood before its version is acknowledged.
#include <algorithm>
#include <utility>

#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/writer.h"
#include "server/knowledge/derived.h"
#include "server/knowledge/environment_keys.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/quarantine.h"
#include "server/knowledge/refusal.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

const store::LayerInfo* SemanticLayer(const std::vector<store::LayerInfo>& layers) {
  const auto layer = std::find_if(layers.begin(), layers.end(),
                                  [](const auto& other) { return other.name == "semantic"; });
  return layer == layers.end() ? nullptr : &*layer;
}

std::string PlaceType(Knowledge& knowledge, const CatalogueState& catalogue,
                      const std::string& name) {
  const recipes::Resource type = knowledge.ResolveClass(name);
  const auto term = catalogue.view.dictionary().FindIri(type.iri);
  if (!term || !IsPlace(catalogue, *term)) {
    throw Error(Code::kInvalid, "'" + type.label + "' is no kind of place")
        .WithHint("a type is a class of places, such as Kitchen, HospitalRoom or Home");
  }
  return type.iri;
}

// Whether anything of the top layer is a map, a place or a perception of one.
bool DescribesPlace(const rdf::View& view, const CatalogueState& catalogue) {
  const rdf::TermId type = view.dictionary().InternIri(std::string(rdf::kRdf) + "type");
  std::vector<rdf::TermId> kinds;
  for (const char* kind : {"Map", "SemanticEnvironmentMap", "SemanticMapPerception"}) {
    kinds.push_back(view.dictionary().InternIri(std::string(rdf::kLares) + kind));
  }
  for (const rdf::Triple& triple : view.layers().back()->Range({{}, type, {}})) {
    const bool is_map = std::find(kinds.begin(), kinds.end(), triple.object) != kinds.end();
    if (is_map || IsPlace(catalogue, triple.object)) return true;
  }
  return false;
}

// Nothing but the semantic layer changes in it, and what is said of the version.
bool IsSemanticOnly(const store::NewVersion& version) {
  return version.layers.size() == 1 && version.removed_layers.empty();
}

[[noreturn]] void RefuseVersion(const Contradiction& found, const std::string& source,
                                bool wants_quarantine) {
  Refusal refusal = ToRefusal(found, source);
  if (wants_quarantine) {
    refusal.WithHint(
        "only a semantic layer can be kept aside: put the other layers as a version of their own, "
        "then the semantic layer with --quarantine");
  } else {
    refusal.WithHint("mend it, or send the semantic layer with --quarantine to keep it aside");
  }
  throw refusal;
}

}  // namespace

Knowledge::VersionAnswer Knowledge::PutVersion(const store::NewVersion& original,
                                               const VersionRights& rights) {
  store::NewVersion version = original;
  VersionAnswer answer;
  if (!version.type_iri.empty())
    version.type_iri = PlaceType(*this, *state_->catalogue(), version.type_iri);
  if (const store::LayerInfo* layer = SemanticLayer(version.layers)) {
    // Understood as the version it would become; the view stays in the cache for the first
    // question.
    store::EnvironmentVersion draft;
    draft.environment = version.environment;
    draft.layers = {*layer};
    const std::string name = EnvironmentGraphName(version.environment);
    rdf::Document content = ReadStored(state_->store, state_->aliases, name, layer->blob,
                                       layer->media_type, layer->file_name);
    const rdf::Graph graph = rdf::MakeGraph(content, name, state_->aliases, *state_->dictionary);
    answer.remarks = std::move(content.remarks);
    const rdf::View view = WithoutDerived(state_->ViewOf({nullptr, nullptr, &draft}, &graph));
    answer.objects = semantic::ReadMapObjects(view);
    if (answer.objects.empty() && !DescribesPlace(view, *state_->catalogue())) {
      throw Error(Code::kInvalid, "is no semantic map: it describes no map, place or object",
                  {layer->file_name, 0, 0});
    }
    const auto base = state_->catalogue();
    if (!rights.editor) {
      state_->CheckAuthority(*base, graph,
                             {state_->store.ReadBlob(layer->blob.sha256), layer->file_name});
    }
    if (const auto found = state_->Convict(*base, view, graph)) {
      if (!rights.quarantine || !IsSemanticOnly(version)) {
        RefuseVersion(*found, layer->file_name, rights.quarantine);
      }
      answer.quarantined = found->message;
      answer.aside = KeepAside(state_->store, version, *layer, rights.editor, found->message);
      return answer;
    }
    answer.warnings = DescribeClashes(view);
    for (const semantic::MapObject& object : answer.objects) {
      for (const auto& remark : object.remarks) answer.warnings.push_back(remark);
    }
    if (answer.objects.empty()) answer.warnings.push_back("the map holds no object");
    for (store::LayerInfo& stored : version.layers) {
      if (stored.name == "semantic") {
        stored.facts["objects"] = std::to_string(answer.objects.size());
        if (rights.editor) stored.facts["editor"] = "true";
      }
    }
    version.keys = KeysOf(view, answer.objects);
  }
  if (!version.keys) version.keys = state_->KeysOfCarried(version);
  answer.version = state_->store.PutVersion(version);
  if (SemanticLayer(version.layers) != nullptr) {
    ForgetKeptAside(state_->store, QuarantineIdOfEnvironment(version.environment));
  }
  state_->changes.Notify();
  return answer;
}

Knowledge::VersionAnswer Knowledge::ReleaseVersion(const std::string& quarantine_id, bool editor) {
  const VersionAside aside = VersionKeptAside(state_->store, quarantine_id);
  return PutVersion(aside.version, {aside.editor || editor, false});
}

std::string Knowledge::RenderSemantic(const std::string& environment, int version,
                                      rdf::Format format) {
  const store::EnvironmentVersion stored = state_->store.GetVersion(environment, version);
  const store::LayerInfo* layer = SemanticLayer(stored.layers);
  if (layer == nullptr) {
    throw Error(Code::kNotFound, "version " + std::to_string(stored.number) + " of '" +
                                     environment + "' has no semantic layer");
  }
  return rdf::WriteRdf(ReadSemantic(environment, *layer), format);
}

rdf::Document Knowledge::ReadSemantic(const std::string& environment,
                                      const store::LayerInfo& layer) {
  return ReadStored(state_->store, state_->aliases, EnvironmentGraphName(environment), layer.blob,
                    layer.media_type, layer.file_name);
}

std::vector<semantic::MapObject> Knowledge::MapObjects(const std::string& environment,
                                                       int version) {
  const store::EnvironmentVersion stored = state_->store.GetVersion(environment, version);
  if (SemanticLayer(stored.layers) == nullptr) return {};
  return semantic::ReadMapObjects(WithoutDerived(state_->ViewOf({nullptr, nullptr, &stored})));
}

}  // namespace lares::server
