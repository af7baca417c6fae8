// What the service holds, shared by its files.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <vector>

#include "ontology/rdf/reader.h"
#include "server/knowledge/authority.h"
#include "server/knowledge/catalogue.h"
#include "server/knowledge/consistency.h"
#include "server/knowledge/overlays.h"
#include "server/knowledge/ranking.h"
#include "server/knowledge/robot_grids.h"

namespace lares::server {

// A prior table split into what is ranked together.
struct PlaceTables {
  std::string title;
  places::PriorTable rooms;
  places::PriorTable furniture;
};

struct Knowledge::State {
  State(store::Store& store_in, prolog::EnginePool& engines_in)
      : store(store_in), engines(engines_in) {}

  store::Store& store;
  prolog::EnginePool& engines;
  std::shared_ptr<rdf::Dictionary> dictionary = std::make_shared<rdf::Dictionary>();
  rdf::AliasTable aliases;
  rdf::View own{dictionary};  // the layer of our own modules

  // Stored documents of the catalogue that could not be read; under catalogue_mutex.
  std::vector<Module> set_aside;
  void SetAside(const std::string& id, const Error& error);
  void Restore(const std::string& id);

  std::mutex ontology_mutex;  // one change of the catalogue at a time
  // Stored ontology modules and skill templates by the names of their graphs; under ontology_mutex.
  std::map<std::string, rdf::Graph> stored_graphs;
  mutable std::shared_mutex catalogue_mutex;  // of the pointer and of set_aside
  std::shared_ptr<const CatalogueState> catalogue_now;

  Changes changes;
  Authority authority;
  FirmCatalogue firm;

  std::mutex priors_mutex;
  std::map<std::string, std::shared_ptr<const PlaceTables>> priors;  // by name@version#generation

  RobotGrids robot_grids;

  std::shared_ptr<const CatalogueState> catalogue() const {
    const std::shared_lock lock(catalogue_mutex);
    return catalogue_now;
  }
  // For readers who come now; overlays follow.
  void Publish(std::shared_ptr<const CatalogueState> next) {
    const Snapshot snapshot{next->view, next->generation};
    {
      const std::unique_lock lock(catalogue_mutex);
      catalogue_now = std::move(next);
    }
    overlays.Renew(snapshot);
  }

  // Throws a Refusal when `graph`, a document over the catalogue `base`, adds to terms of others.
  void CheckAuthority(const CatalogueState& base, const rdf::Graph& graph, const Sent& sent,
                      const authority::JudgeOptions& options = {});
  // What of a contradiction in the top layer of `view`, which is `graph` over `base`, the document
  // must answer for; nothing when the catalogue takes no side.
  std::optional<Contradiction> Convict(const CatalogueState& base, const rdf::View& view,
                                       const rdf::Graph& graph);
  // The stored recipes whose tasks the document behind `graph` nests, and those that they nest; by
  // id, itself left out.
  std::vector<store::DocumentInfo> NestedIn(const rdf::Graph& graph, const std::string& id) const;
  std::vector<store::DocumentInfo> NestedIn(const store::DocumentInfo& recipe) const;
  // Catalogue + robot + recipe (above those that it nests) + environment, each where given.
  struct Stack {
    const store::DocumentInfo* robot = nullptr;
    const store::DocumentInfo* recipe = nullptr;
    const store::EnvironmentVersion* environment = nullptr;
  };
  // `environment_graph`: the environment's semantic layer, where it was read already.
  rdf::View ViewOf(const Stack& stack, const rdf::Graph* environment_graph = nullptr);
  OverlaySource SourceOf(const std::string& graph_name, const store::DocumentInfo& document);

  // Of documents over the catalogue `base`, kept from question to question.
  std::shared_ptr<const TaskKnowledge> TaskOf(const std::shared_ptr<const CatalogueState>& base,
                                              const store::DocumentInfo& recipe,
                                              const std::string& task_iri);
  std::shared_ptr<const recipes::RobotProfile> ProfileOf(
      const std::shared_ptr<const CatalogueState>& base, const store::DocumentInfo& robot,
      const std::string& robot_iri);
  // What the store can give a robot: models of what is `sought`, and maps of `environment` (null
  // for none).
  std::vector<recipes::Offer> OffersFor(const CatalogueState& base,
                                        std::vector<recipes::Resource> sought,
                                        const store::EnvironmentVersion* environment);
  MatchMemory match_memory;

  // The version that a robot is to use: the one that is asked for; when none is (0), the one that
  // it is pinned to; else 0, the head.
  int VersionFor(const std::string& robot_id, const std::string& environment, int asked) const {
    if (asked != 0 || environment.empty()) return asked;
    const std::optional<store::Pin> pin = store.FindPin(robot_id, environment);
    return pin ? pin->number : 0;
  }

  // What a version is found by when its semantic layer is not among those that come with it: that
  // of a version that is restored, nothing when the layer is taken out. Nothing when it stays as it
  // is.
  std::optional<std::vector<store::SearchKey>> KeysOfCarried(const store::NewVersion& version);
  // As its semantic layer says.
  std::vector<store::SearchKey> KeysOfVersion(const store::EnvironmentVersion& version);

  // Takes over what the store has of the catalogue and this process does not, and publishes it;
  // true when that was anything. Under ontology_mutex.
  bool TakeOverCatalogue();
  std::map<std::string, int> taken_over;  // graph → version of its document; under ontology_mutex

  Overlays overlays{64, [this] { changes.Notify(); }};  // last: its thread uses what stands above
};

// Documents and environment that a plan request names, and what the store offers for it.
struct Knowledge::Asked {
  Resolved recipe;
  Resolved robot;
  std::optional<store::EnvironmentVersion> environment;
  std::shared_ptr<const CatalogueState> base;
  std::shared_ptr<const TaskKnowledge> task;
  recipes::MatchOptions options;
};

// Name of a document's graph in every view: "recipe:find-bottle".
std::string GraphName(store::DocumentKind kind, const std::string& id);
std::string EnvironmentGraphName(const std::string& environment);

// What a document of this graph is read with: its base, and the namespaces that Lares knows.
rdf::ReadOptions OptionsFor(const std::string& graph_name, const std::string& source,
                            const rdf::AliasTable& aliases);

// The imports that neither our modules nor stored documents answer: nothing is ever fetched. One
// sentence for each.
std::vector<std::string> AbsentImports(const rdf::Document& document,
                                       const std::vector<Knowledge::Module>& modules,
                                       const rdf::AliasTable& aliases);

// The document behind a graph, read as it was when it was accepted: plainly, or repaired where that
// was asked for then.
rdf::Document ReadStored(const store::Store& store, const rdf::AliasTable& aliases,
                         const std::string& graph_name, const store::Blob& blob,
                         const std::string& media_type, const std::string& file_name);

}  // namespace lares::server
