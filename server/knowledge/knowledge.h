// The knowledge service: documents of the store become views, views answer questions.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "mapping/objects/extents.h"
#include "mapping/semantic/map_object.h"
#include "ontology/rdf/aliases.h"
#include "ontology/rdf/document.h"
#include "ontology/triples/view.h"
#include "reasoner/models/typical_models.h"
#include "reasoner/places/prior.h"
#include "reasoner/profile/finding.h"
#include "reasoner/prolog/engine_pool.h"
#include "recipes/match/capabilities.h"
#include "recipes/match/match.h"
#include "recipes/match/rank.h"
#include "recipes/plan/plan.h"
#include "recipes/skill/skill_template.h"
#include "server/knowledge/changes.h"
#include "server/knowledge/package.h"
#include "server/store/store.h"

namespace lares::server {

// A file that belongs to a document: its blob is committed already.
struct AttachedFile {
  std::string file_name;
  std::string media_type;
  store::Blob blob;
};

struct PutRequest {
  store::DocumentKind kind = store::DocumentKind::kOntology;
  std::string id;          // empty: the file name's stem
  std::string media_type;  // may be empty: guessed
  std::string file_name;
  std::string bytes;
  bool recover = false;
  // The sender may add axioms about terms of others; kept with the version.
  bool editor = false;
  // Keep aside, instead of refusing, what contradicts what is known.
  bool quarantine = false;
  std::string prior_format;  // priors: "omics" or "tsv"
  std::string if_match;
  // Object models and robots: kept as details_json's "files": [{file_name, media_type, sha256,
  // size}]. Empty keeps those of the version before for object models, and none for robots.
  std::vector<AttachedFile> files;
};

struct PutAnswer {
  store::DocumentInfo document;
  std::vector<rdf::Remark> remarks;       // repairs and warnings with places
  std::vector<recipes::Task> tasks;       // recipes
  std::vector<recipes::Resource> robots;  // robots
  std::vector<recipes::Resource> skill_templates;
  std::vector<std::string> warnings;  // without a place: absent imports, contradictions, …
  std::size_t statements = 0;
  std::size_t inferred = 0;
  // Why it is kept aside; empty when it was taken. `document` is then of kQuarantined.
  std::string quarantined;
};

struct PlanRequest {
  std::string task;             // document id, IRI, label or local name
  std::string robot;            // likewise
  std::string environment;      // id; empty for none
  int environment_version = 0;  // 0: newest
  bool strict = false;
  std::map<std::string, std::string> templates;  // answers to choices: step → template
  std::map<std::string, std::string> set;        // parameters and inputs: name → value as written
  bool sequential = false;                       // nothing side by side
  std::string from;                              // made anew: the step to go on with
  std::vector<std::string> done;                 // made anew: the steps that are done
};

// One of the stored robots, as it stands to a task.
struct RobotRank {
  std::string document;  // id
  recipes::RankedRobot ranked;
};

struct RobotsRequest {
  std::string task;             // document id, IRI, label or local name
  std::string environment;      // id; empty for none: no maps are on offer then
  int environment_version = 0;  // 0: newest
  bool strict = false;
};

struct RobotsAnswer {
  recipes::Resource task;
  std::vector<RobotRank> robots;  // able ones first, then by the cost of the smallest change
};

struct PlanAnswer {
  recipes::PlanResult result;
  // When the match is not feasible: every stored robot that could, by id.
  std::vector<recipes::Resource> capable_robots;
  // And those that could after the smallest changes, at most three.
  std::vector<RobotRank> nearest_robots;
};

// What a question is asked about, beside the catalogue. Each empty for none.
struct ViewRequest {
  std::string recipe;  // document id, IRI, label or local name
  std::string robot;   // likewise
  std::string environment;
  int environment_version = 0;  // 0: newest
};

// Environments that are all of it; what is empty does not narrow.
struct EnvironmentQuery {
  std::string room_number, street, building, level;
  std::string type;                 // a class of places, by any of its names; its subclasses too
  std::vector<std::string> holds;   // classes of objects, each of which is there
  std::vector<std::string> layers;  // names
  std::string text;                 // words that are all there; `cof*` stands for a beginning
  std::optional<Time> changed_from, changed_until;
  std::string after;  // ids beyond this one only
  std::size_t limit = 100;
};

struct SeenObject {
  std::string environment;
  int version = 0;
  semantic::MapObject object;
};

struct WhereRequest {
  std::string object;       // IRI, local name or label of a class
  std::string prior;        // name of a table; empty: our own
  std::string environment;  // id; empty for none
  int environment_version = 0;
};

struct WhereAnswer {
  recipes::Resource object;
  std::string prior;  // name of the table that answered
  std::string prior_title;
  std::vector<SeenObject> seen;  // mapped instances of the class or a subclass, newest first
  struct Place {
    recipes::Resource place;
    double probability = 0;
    double support = 0;
  };
  std::vector<Place> rooms;      // ranked
  std::vector<Place> furniture;  // ranked; empty when the table has none
};

struct CheckRequest {
  std::string media_type;  // may be empty: guessed
  std::string file_name;
  std::string bytes;
  bool recover = false;
};

struct CheckAnswer {
  profile::Report report;
  std::vector<rdf::Remark> remarks;   // of reading
  std::vector<std::string> warnings;  // absent imports
  std::size_t statements = 0;
};

// An object model, as its description and its files say.
struct ObjectModelInfo {
  store::DocumentInfo document;
  std::vector<recipes::Resource> classes;  // what it is a model of
  // Of each of `classes`, those that the description itself puts it under.
  std::vector<std::vector<std::string>> above;
  std::vector<recipes::Resource> kinds;  // what kind of model: PlanarObjectModel, …
  struct Algorithm {
    recipes::Resource what;            // without an IRI when the description names it in words only
    std::vector<std::string> classes;  // kinds of component that it is
  };
  std::vector<Algorithm> algorithms;      // made it, and can use it
  std::vector<recipes::Resource> makers;  // without an IRI where named in words
  std::string created;                    // as stated; may be empty
  std::optional<objects::Extents> extents;
  std::vector<PackageFile> files;
  std::uint64_t size_bytes = 0;  // of description and files
  // How it answers to a class that was asked for.
  enum class Fit { kAny, kSame, kKindOf, kMoreGeneral };
  Fit fit = Fit::kAny;
  // In a kind of room that was asked for: P(class | room), and the sentence why.
  std::optional<double> probability;
  std::string why;
};

// Each empty for any. Classes by IRI, local name or label.
struct ObjectModelQuery {
  std::string class_name;  // also models of what is below it, and more general models of it
  std::string room;        // what is typical of such a room
  std::string maker;       // IRI, local name, or a part of the label
  std::string algorithm;   // this kind of program, or one below it
  std::string kind;        // of model, or one below it
};

struct TypicalRequest {
  std::string room;   // class of a room: IRI, local name or label
  std::string robot;  // any of its names; empty for any robot
  std::string prior;  // name of a table; empty: our own
  bool strict = false;
  std::optional<double> min_probability;
  std::optional<std::size_t> max_models;
  std::optional<std::uint64_t> max_bytes;
};

struct TypicalAnswer {
  struct Model {
    ObjectModelInfo info;
    recipes::Resource of;  // the class that the choice rests on
    models::Choice choice;
  };
  recipes::Resource room;
  std::optional<recipes::Resource> robot;
  std::string prior;  // name of the table that answered
  std::string prior_title;
  std::vector<recipes::Resource> places;  // kinds of rooms whose rows were looked at
  bool places_above = false;              // one above the room that was asked for
  std::vector<Model> loaded;              // best first
  std::vector<Model> left_out;
  std::uint64_t size_bytes = 0;  // of those loaded
};

struct PlaceTables;

// All members are thread-safe. Readers never wait for a writer: they use the views that stood when
// they began. Faults are Errors.
class Knowledge {
 public:
  // Loads the modules of the search path and the stored ontology documents. Recipes, robots and
  // environments load when asked for.
  Knowledge(store::Store& store, prolog::EnginePool& engines);
  ~Knowledge();

  // Validates whole, stores, and only then makes it visible. Throws a Refusal (refusal.h), and
  // changes nothing, for axioms about terms of others and for contradictions.
  // Returns once the next plan is made with what was put of skill templates.
  PutAnswer Put(const PutRequest& request);
  void Remove(store::DocumentKind kind, const std::string& id);
  // Puts again what is kept aside under this id of kQuarantined; `editor` adds to the rights that
  // it was sent with. Throws as Put, leaving it where it is.
  PutAnswer Release(const std::string& quarantine_id, bool editor);
  // What is wrong with an ontology document beside the catalogue; nothing is kept. Throws as Put
  // for what cannot be read, kTooLarge, kTimeout.
  CheckAnswer Check(const CheckRequest& request);

  // As Store::PutVersion, after the semantic layer (when it changes) was read, closed and its map
  // objects checked. Warnings: contradictions, absent imports.
  struct VersionAnswer {
    store::EnvironmentVersion version;
    std::vector<rdf::Remark> remarks;
    std::vector<std::string> warnings;
    std::vector<semantic::MapObject> objects;
    // Why the semantic layer is kept aside, and as what; the environment is then as it was, and
    // `version` is empty. Empty when the version was taken.
    std::string quarantined;
    store::DocumentInfo aside;
  };
  struct VersionRights {
    bool editor = false;  // as in PutRequest; a fact of the semantic layer from then on
    // Keep the semantic layer aside, instead of refusing it, when it contradicts what is known. A
    // version with other layers is refused all the same: they would get lost.
    bool quarantine = false;
  };
  VersionAnswer PutVersion(const store::NewVersion& version, const VersionRights& rights);
  VersionAnswer PutVersion(const store::NewVersion& version) { return PutVersion(version, {}); }
  // As Release, for a semantic layer: it becomes that of a new version, with the other layers of
  // the newest one.
  VersionAnswer ReleaseVersion(const std::string& quarantine_id, bool editor);
  // The semantic layer's document in another format.
  std::string RenderSemantic(const std::string& environment, int version, rdf::Format format);
  std::vector<semantic::MapObject> MapObjects(const std::string& environment, int version);
  // The document of a semantic layer of that environment, read as it was when it was accepted.
  rdf::Document ReadSemantic(const std::string& environment, const store::LayerInfo& layer);
  // By id. Throws kInvalid, kNotFound and kAmbiguous for a class that is none.
  std::vector<store::EnvironmentInfo> SearchEnvironments(const EnvironmentQuery& query);
  // Gives keys to environments that an older program put: afterwards they are found by what they
  // hold. Those whose semantic layer cannot be read any more are left out.
  void IndexEnvironments();

  // The skill templates that plans are made of, stored ones included.
  std::vector<recipes::SkillTemplate> SkillTemplates();
  PlanAnswer MakePlan(const PlanRequest& request);
  // What the robot takes along for `plan`, which MakePlan made of `request`. Without a grid where
  // none can be made; the reason is in it.
  TaskPackage MakePackage(const PlanRequest& request, const recipes::Plan& plan);
  // The grid of an environment's version (0: newest) for a robot's body; from the octomap layer
  // where it can be cut, else from the grid layer. Throws kNotFound without either layer, and as
  // volume::CutOctomap and grid::ReadGrid.
  std::shared_ptr<const RobotGrid> MakeRobotGrid(const std::string& robot,
                                                 const std::string& environment,
                                                 int environment_version);
  // Everything that a stored robot (by any of its names) can do, and what keeps it from the rest.
  recipes::CapabilityReport Capabilities(const std::string& robot, bool strict);
  // What a plan's robot has of what its task needs; no plan is made.
  recipes::MatchReport MatchTask(const PlanRequest& request);
  // Every stored robot, with what it lacks for a task.
  RobotsAnswer RankRobots(const RobotsRequest& request);
  WhereAnswer Where(const WhereRequest& request);
  std::vector<ObjectModelInfo> ObjectModels(const ObjectModelQuery& query);  // by id
  // load-typical-object-models. Throws kNotFound for a room, robot or table that is not known,
  // kInvalid for a class that is no kind of place and for numbers out of bounds.
  TypicalAnswer TypicalModels(const TypicalRequest& request);

  // Resolves a name against stored documents: id, then IRI, then local name, then label. Throws
  // kNotFound with similar names, kAmbiguous listing the matches.
  struct Resolved {
    store::DocumentInfo document;
    std::string target_iri;
  };
  Resolved Resolve(store::DocumentKind kind, const std::string& name);
  // A class of the catalogue by IRI, prefixed name, local name or label.
  recipes::Resource ResolveClass(const std::string& name);
  // Likewise, a class of components of robots. Throws kNotFound with similar components, kInvalid
  // for a class that is none.
  recipes::Resource ResolveComponent(const std::string& name);

  store::Store& store() const;
  // Takes over what other servers of the store have put and removed of the catalogue; true when
  // that was anything. The server asks for it now and then, and every put of the catalogue does.
  bool Refresh();
  const rdf::AliasTable& aliases() const;
  struct Module {
    std::string id;
    std::string origin;  // "built-in" or "stored"
    std::size_t statements = 0;
  };
  std::vector<Module> Modules() const;
  rdf::View Catalogue() const;
  // The catalogue with the overlays of `request` above it, closed. Shortly after a change of the
  // catalogue it may be the view that stood before the change, whole, until the overlays are
  // closed anew in the background; it never mixes the two.
  rdf::View ViewFor(const ViewRequest& request);
  // Until every overlay that is kept lies over the catalogue of now.
  void WaitForOverlays();
  // Told after each put and removal, once questions see it.
  Changes& changes();
  struct Counts {
    std::size_t terms = 0, asserted = 0, inferred = 0, views_cached = 0, clashes = 0;
  };
  Counts counts() const;

 private:
  struct State;
  struct Asked;  // a plan request, understood

  PutAnswer PutOntology(const PutRequest& request, const rdf::Graph& graph,
                        const rdf::Document& content);
  RobotsAnswer RankRobots(const Asked& asked);
  void AddOtherRobots(const Asked& asked, PlanAnswer& answer);
  void RemoveFromCatalogue(store::DocumentKind kind, const std::string& id);
  Asked UnderstandTask(const PlanRequest& request);  // all of it but the robot
  Asked Understand(const PlanRequest& request);
  recipes::MatchReport MatchTask(const Asked& asked);
  std::shared_ptr<const PlaceTables> FindPrior(const std::string& name);

  std::unique_ptr<State> state_;
};

}  // namespace lares::server
