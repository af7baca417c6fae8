#include "server/knowledge/knowledge.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/aside.h"
#include "base/file.h"
#include "base/search_path.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"
#include "server/knowledge/derived.h"
#include "server/knowledge/state.h"

namespace lares::server {

std::string GraphName(store::DocumentKind kind, const std::string& id) {
  return std::string(store::ToString(kind)) + ":" + id;
}

std::string EnvironmentGraphName(const std::string& environment) {
  return "environment:" + environment;
}

rdf::ReadOptions OptionsFor(const std::string& graph_name, const std::string& source,
                            const rdf::AliasTable& aliases) {
  rdf::ReadOptions options;
  options.source = source;
  // What relative IRIs mean in a document that states no base of its own.
  std::string path = graph_name;
  std::replace(path.begin(), path.end(), ':', '/');
  options.base_iri = "https://w3id.org/lares/documents/" + path;
  constexpr std::string_view kFile = ".owl#";
  for (const rdf::Alias& row : aliases.aliases()) {
    if (!row.is_namespace || !row.alias.ends_with(kFile)) continue;
    const std::size_t slash = row.alias.rfind('/');
    std::string stem = row.alias.substr(slash + 1, row.alias.size() - kFile.size() - slash - 1);
    options.known_namespaces.emplace(stem, row.alias);
    std::erase(stem, '-');  // srdl2-comp is written &srdl2comp; too
    options.known_namespaces.emplace(stem, row.alias);
  }
  return options;
}

rdf::Document ReadStored(const store::Store& store, const rdf::AliasTable& aliases,
                         const std::string& graph_name, const store::Blob& blob,
                         const std::string& media_type, const std::string& file_name) {
  const std::string bytes = store.ReadBlob(blob.sha256);
  rdf::ReadOptions options = OptionsFor(graph_name, file_name, aliases);
  const rdf::Format format = rdf::GuessFormat(media_type, file_name, bytes);
  try {
    return rdf::ReadRdf(bytes, format, options);
  } catch (const Error&) {
    if (format != rdf::Format::kRdfXml) throw;
    options.recover = true;
    return rdf::ReadRdf(bytes, format, options);
  }
}

Knowledge::Knowledge(store::Store& store, prolog::EnginePool& engines)
    : state_(std::make_unique<State>(store, engines)) {
  const std::filesystem::path aliases = FindShared("ontology/aliases.tsv");
  state_->aliases = rdf::AliasTable::FromTsv(ReadFile(aliases), aliases.filename().string());
  state_->own =
      CloseOwnModules(state_->dictionary, LoadOwnModules(state_->aliases, *state_->dictionary));
  state_->authority.SetOwn(state_->own);
  state_->TakeOverCatalogue();
}

Knowledge::~Knowledge() = default;

OverlaySource Knowledge::State::SourceOf(const std::string& graph_name,
                                         const store::DocumentInfo& document) {
  return {graph_name + "@" + document.blob.sha256, [this, graph_name, document] {
            const rdf::Document content = ReadStored(store, aliases, graph_name, document.blob,
                                                     document.media_type, document.file_name);
            return rdf::MakeGraph(content, graph_name, aliases, *dictionary);
          }};
}

void Knowledge::State::CheckAuthority(const CatalogueState& base, const rdf::Graph& graph,
                                      const Sent& sent, const authority::JudgeOptions& options) {
  RefuseTrespasses(base.view, graph,
                   authority::FindTrespasses(base.view, graph, *authority.owners(), options), sent);
}

std::optional<Contradiction> Knowledge::State::Convict(const CatalogueState& base,
                                                       const rdf::View& view,
                                                       const rdf::Graph& graph) {
  if (view.layers().back()->clash_count() == 0) return std::nullopt;
  std::vector<FirmCatalogue::Stored> stored;
  const auto& layers = base.view.layers();
  for (std::size_t i = own.layers().size(); i < layers.size(); ++i) {
    for (const rdf::Graph& other : layers[i]->graphs()) {
      stored.push_back({&other, authority.IsByEditor(other.name)});
    }
  }
  const rdf::View below = firm.For(base.generation, own, *authority.own(), stored);
  return FindContradiction(below.With(Aside([&] { return owl::Materialise(below, {graph}); })));
}

std::vector<store::DocumentInfo> Knowledge::State::NestedIn(
    const store::DocumentInfo& recipe) const {
  std::map<std::string, store::DocumentInfo> nested;
  std::vector<store::DocumentInfo> open{recipe};
  while (!open.empty()) {
    const store::DocumentInfo next = std::move(open.back());
    open.pop_back();
    // Few recipes nest others, and details can be long.
    if (next.details_json.find("\"nests\"") == std::string::npos) continue;
    const auto details = nlohmann::json::parse(next.details_json);
    for (const std::string id : details.value("nests", nlohmann::json::array())) {
      if (id == recipe.id || nested.count(id) > 0) continue;
      const auto found = store.FindDocument(store::DocumentKind::kRecipe, id);
      if (!found) continue;  // removed since: planning names the step that it leaves unknown
      nested.emplace(id, *found);
      open.push_back(*found);
    }
  }
  std::vector<store::DocumentInfo> documents;
  for (auto& [id, document] : nested) documents.push_back(std::move(document));
  return documents;
}

std::vector<store::DocumentInfo> Knowledge::State::NestedIn(const rdf::Graph& graph,
                                                            const std::string& id) const {
  std::set<std::string> iris;
  for (const rdf::Triple& triple : graph.triples) {
    const rdf::TermView object = dictionary->Get(triple.object);
    if (object.kind == rdf::TermKind::kIri) iris.emplace(object.value);
  }
  std::map<std::string, store::DocumentInfo> nested;
  for (const std::string& iri : iris) {
    for (auto& [document, name] : store.FindByName(store::DocumentKind::kRecipe, iri)) {
      if (document.id == id || name.kind != "iri") continue;
      nested.emplace(document.id, document);
      for (store::DocumentInfo& inner : NestedIn(document)) {
        if (inner.id != id) nested.emplace(inner.id, std::move(inner));
      }
    }
  }
  std::vector<store::DocumentInfo> documents;
  for (auto& [nested_id, document] : nested) documents.push_back(std::move(document));
  return documents;
}

rdf::View Knowledge::State::ViewOf(const Stack& stack, const rdf::Graph* environment_graph) {
  const std::shared_ptr<const CatalogueState> base = catalogue();
  std::vector<OverlaySource> sources;
  // The robot is the largest and changes least, so it lies below what is asked about it.
  std::vector<store::DocumentInfo> documents;
  if (stack.robot != nullptr) documents.push_back(*stack.robot);
  if (stack.recipe != nullptr) {
    for (store::DocumentInfo& nested : NestedIn(*stack.recipe)) documents.push_back(nested);
    documents.push_back(*stack.recipe);
  }
  for (const store::DocumentInfo& document : documents) {
    sources.push_back(SourceOf(GraphName(document.kind, document.id), document));
  }
  if (stack.environment != nullptr) {
    for (const store::LayerInfo& layer : stack.environment->layers) {
      if (layer.name != "semantic") continue;
      store::DocumentInfo document;
      document.blob = layer.blob;
      document.media_type = layer.media_type;
      document.file_name = layer.file_name;
      OverlaySource source =
          SourceOf(EnvironmentGraphName(stack.environment->environment), document);
      source.complete = [](const rdf::View& map) {
        return WithDerived(map, SpatialRelationsOf(map));
      };
      sources.push_back(std::move(source));
    }
  }
  return overlays.Get({base->view, base->generation}, sources, environment_graph).view;
}

store::Store& Knowledge::store() const { return state_->store; }

const rdf::AliasTable& Knowledge::aliases() const { return state_->aliases; }

std::vector<Knowledge::Module> Knowledge::Modules() const {
  std::vector<Module> modules = state_->catalogue()->modules;
  const std::shared_lock lock(state_->catalogue_mutex);
  modules.insert(modules.end(), state_->set_aside.begin(), state_->set_aside.end());
  return modules;
}

void Knowledge::WaitForOverlays() { state_->overlays.Wait(); }

rdf::View Knowledge::Catalogue() const { return state_->catalogue()->view; }

Changes& Knowledge::changes() { return state_->changes; }

Knowledge::Counts Knowledge::counts() const {
  const auto catalogue = state_->catalogue();
  Counts counts;
  counts.terms = state_->dictionary->size();
  counts.views_cached = state_->overlays.size();
  counts.inferred = catalogue->inferred;
  for (const auto& layer : catalogue->view.layers()) {
    counts.asserted += layer->asserted_size();
    counts.clashes += layer->clash_count();
  }
  return counts;
}

}  // namespace lares::server
