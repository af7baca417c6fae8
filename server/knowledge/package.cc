// The task package: models, grid and layers that a plan needs on board.
#include "server/knowledge/package.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/hash.h"
#include "mapping/grid/inflate.h"
#include "mapping/grid/map_files.h"
#include "mapping/grid/read_grid.h"
#include "mapping/volume/cut.h"
#include "ontology/rdf/vocabulary.h"
#include "robots/body/robot_body.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/object_models.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

std::string Metres(double length_m) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g m", length_m);
  return text;
}

const store::LayerInfo* FindLayer(const store::EnvironmentVersion& version,
                                  const std::string& name) {
  const auto found = std::find_if(version.layers.begin(), version.layers.end(),
                                  [&](const auto& layer) { return layer.name == name; });
  return found == version.layers.end() ? nullptr : &*found;
}

// --- The grid --------------------------------------------------------------------------------

RobotGrid WriteGrid(const grid::Grid& plain, const robots::Clearance& body,
                    const store::LayerInfo& layer, std::vector<std::string> reasons) {
  const grid::Grid grid = body.radius_m > 0 ? grid::Inflate(plain, body.radius_m) : plain;
  RobotGrid made;
  made.yaml = grid::ToMapYaml(grid, kGridImageFile);
  made.pgm = grid::ToPgm(grid);
  made.yaml_sha256 = Sha256Hex(made.yaml);
  made.pgm_sha256 = Sha256Hex(made.pgm);
  made.layer = layer.name;
  made.layer_sha256 = layer.blob.sha256;
  made.radius_m = body.radius_m;
  made.resolution_m = grid.resolution_m;
  made.width = grid.width;
  made.height = grid.height;
  made.bounds_m = grid::BoundsOf_m(grid);
  made.cells = grid::Count(grid);
  made.reasons = std::move(reasons);
  return made;
}

RobotGrid FromOctomap(const store::Store& store, const store::LayerInfo& layer,
                      const robots::Clearance& body) {
  volume::CutOptions options;
  options.heights = {body.low_m, body.high_m};
  const std::filesystem::path file = store.BlobPath(layer.blob.sha256);
  const volume::GridCut cut = volume::CutOctomap(
      [&] { return environment::ByteReader::OfFile(file, layer.file_name); }, options);
  RobotGrid made = WriteGrid(
      cut.grid, body, layer,
      {"the grid is the octomap layer cut between " + Metres(body.low_m) + " and " +
       Metres(body.high_m) + " above z = 0 of the map, which are the whole layers of " +
       Metres(cut.voxel_m) + " voxels from " + Metres(cut.layers.low_m) + " to " +
       Metres(cut.layers.high_m) + "; a cell is free where every one of them is known to be"});
  made.heights_m = {cut.layers.low_m, cut.layers.high_m};
  return made;
}

RobotGrid FromGrid(const store::Store& store, const store::LayerInfo& layer,
                   const robots::Clearance& body, const std::string& why) {
  const std::filesystem::path file = store.BlobPath(layer.blob.sha256);
  const grid::Grid grid = grid::ReadGrid(
      [&] { return environment::TarReader::OfFile(file, layer.file_name); }, layer.file_name);
  return WriteGrid(grid, body, layer,
                   {"the grid is the environment's own grid layer, for " + why +
                    ": at which heights it was made is not known"});
}

// What the same layer and body give the same grid for.
std::string KeyOf(const store::LayerInfo& layer, const robots::Clearance& body) {
  char text[96];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g", body.radius_m, body.low_m, body.high_m);
  return layer.blob.sha256 + " " + text;
}

// What is wrong with the layer itself, and will be again; all else is a fault of the moment.
bool IsOfTheLayer(const Error& error) {
  return error.code() == Code::kInvalid || error.code() == Code::kTooLarge;
}

bool HasMap(const store::EnvironmentVersion& version) {
  return FindLayer(version, "octomap") != nullptr || FindLayer(version, "grid") != nullptr;
}

// The version has one of the two layers.
RobotGrid MakeGrid(const store::Store& store, const store::EnvironmentVersion& version,
                   const robots::Clearance& body) {
  const store::LayerInfo* octomap = FindLayer(version, "octomap");
  const store::LayerInfo* grid = FindLayer(version, "grid");
  if (octomap == nullptr) return FromGrid(store, *grid, body, "there is no octomap layer");
  try {
    return FromOctomap(store, *octomap, body);
  } catch (const Error& error) {
    if (grid == nullptr || !IsOfTheLayer(error)) throw;
    return FromGrid(store, *grid, body,
                    "the octomap layer cannot be cut (" + error.FullMessage() + ")");
  }
}

std::string KeyOf(const store::EnvironmentVersion& version, const robots::Clearance& body) {
  std::string key;
  for (const char* name : {"octomap", "grid"}) {
    if (const store::LayerInfo* layer = FindLayer(version, name)) {
      key += std::string(name) + " " + KeyOf(*layer, body) + "\n";
    }
  }
  return key;
}

std::string WithoutMap(const store::EnvironmentVersion& version) {
  return "version " + std::to_string(version.number) + " of '" + version.environment +
         "' has neither an octomap nor a grid layer";
}

// Throws kNotFound when the version has neither layer, or as making the grid does.
std::shared_ptr<const RobotGrid> GridFor(RobotGrids& grids, const store::Store& store,
                                         const store::EnvironmentVersion& version,
                                         const robots::Clearance& body) {
  if (!HasMap(version)) throw Error(Code::kNotFound, WithoutMap(version));
  return grids.Get(KeyOf(version, body), [&] { return MakeGrid(store, version, body); });
}

// --- The models ------------------------------------------------------------------------------

// A class of things that the robot has to recognise, or of places whose things it has to.
struct Wanted {
  rdf::TermId kind{};
  bool is_place = false;
  std::string why;  // "the step 'look for cup' needs its object_class"
};

std::vector<rdf::TermId> ClassesOf(const rdf::View& view, rdf::TermId term) {
  const auto iri = [&](std::string_view space, const char* name) {
    return view.dictionary().InternIri(std::string(space) + name);
  };
  const rdf::TermId type = iri(rdf::kRdf, "type");
  if (view.Contains({term, type, iri(rdf::kOwl, "Class")})) return {term};
  std::vector<rdf::TermId> classes;
  view.ForEach(
      {term, type, {}},
      [&](const rdf::Triple& triple) {
        const auto kind = view.dictionary().Get(triple.object);
        if (kind.kind == rdf::TermKind::kIri && !kind.value.starts_with(rdf::kOwl)) {
          classes.push_back(triple.object);
        }
        return true;
      },
      rdf::Origin::kAsserted);
  return classes;
}

// From what the steps act on, in their order, each class once.
std::vector<Wanted> FindWanted(const rdf::View& view, const CatalogueState& catalogue,
                               const recipes::Plan& plan) {
  std::vector<Wanted> wanted;
  std::set<rdf::TermId> seen;
  for (const recipes::State& state : plan.states) {
    for (const recipes::Parameter& input : state.inputs) {
      const bool names_things = input.type == "class" || input.type == "designator";
      const bool is_known = input.source != recipes::Parameter::Source::kRobot &&
                            input.source != recipes::Parameter::Source::kStep;
      const auto term = view.dictionary().FindIri(input.value);
      if (!names_things || !is_known || !term) continue;
      for (const rdf::TermId kind : ClassesOf(view, *term)) {
        if (!seen.insert(kind).second) continue;
        wanted.push_back({kind, IsPlace(catalogue, kind),
                          "the step '" + state.label + "' needs it (" + input.name + ")"});
      }
    }
  }
  return wanted;
}

class ModelChooser {
 public:
  ModelChooser(const rdf::View& view, std::vector<ObjectModelInfo> stored)
      : view_(view),
        sub_class_(view.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf")),
        stored_(std::move(stored)) {}

  void ChooseForClass(const Wanted& wanted) {
    const bool found = Choose(wanted.kind, wanted.why);
    if (!found) {
      reasons_.push_back("no object model is stored for " + view_.Label(wanted.kind) + ": " +
                         wanted.why);
    }
  }

  void ChooseForPlace(const Wanted& wanted, const models::TypicalChoice& choice,
                      const std::string& table_title) {
    const std::string place = view_.Label(wanted.kind);
    const std::string why =
        "; it is typical of " + place + " (" + table_title + "), and " + wanted.why;
    for (const models::Choice& one : choice.loaded) {
      Take(one.id, "object model " + one.id + " is " + one.why + why);
    }
    for (const models::Choice& one : choice.left_out) {
      if (one.verdict != models::Verdict::kRobotLacks) continue;
      reasons_.push_back("object model " + one.id + " is left out: it is " + one.why);
    }
    if (choice.loaded.empty()) {
      reasons_.push_back(
          (choice.places.empty()
               ? "nothing is known to be typical of "
               : "no object model is stored, for this robot, of what is typical of ") +
          place + ": " + wanted.why);
    }
  }

  std::vector<PackageModel> models() const {
    std::vector<PackageModel> models;
    for (const auto& [id, model] : chosen_) models.push_back(model);
    return models;
  }
  const std::vector<std::string>& reasons() const { return reasons_; }

 private:
  bool Choose(rdf::TermId wanted, const std::string& why) {
    bool found = false;
    for (const ObjectModelInfo& info : stored_) {
      for (const recipes::Resource& of : info.classes) {
        const auto kind = view_.dictionary().FindIri(of.iri);
        if (!kind) continue;
        const bool is_same = *kind == wanted;
        if (!is_same && !view_.Contains({*kind, sub_class_, wanted})) continue;
        found = true;
        const std::string sentence =
            "object model " + info.document.id + " is of " + of.label +
            (is_same ? "" : ", which is a kind of " + view_.Label(wanted)) + ": " + why;
        Take(info.document.id, sentence);
        break;
      }
    }
    return found;
  }

  void Take(const std::string& id, const std::string& sentence) {
    reasons_.push_back(sentence);
    PackageModel& model = chosen_[id];
    model.reasons.push_back(sentence);
    if (!model.document.id.empty()) return;
    const auto info = std::find_if(stored_.begin(), stored_.end(),
                                   [&](const auto& one) { return one.document.id == id; });
    model.document = info->document;
    model.classes = info->classes;
    model.files = info->files;
  }

  const rdf::View& view_;
  rdf::TermId sub_class_;
  std::vector<ObjectModelInfo> stored_;
  std::map<std::string, PackageModel> chosen_;
  std::vector<std::string> reasons_;
};

// The document's id where it describes one robot, else the robot's IRI.
std::string RouteNameOf(const Knowledge::Resolved& robot) {
  std::set<std::string> described;
  for (const store::DocumentName& name : robot.document.names) {
    if (name.kind == "id") described.insert(name.target);
  }
  return described.size() == 1 ? robot.document.id : robot.target_iri;
}

void Append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

std::shared_ptr<const RobotGrid> Knowledge::MakeRobotGrid(const std::string& robot,
                                                          const std::string& environment,
                                                          int environment_version) {
  const Resolved resolved = Resolve(store::DocumentKind::kRobot, robot);
  const store::EnvironmentVersion version = state_->store.GetVersion(
      environment, state_->VersionFor(resolved.document.id, environment, environment_version));
  const rdf::View view = state_->ViewOf({&resolved.document, nullptr, nullptr});
  const robots::Clearance body =
      robots::ClearanceOf(robots::ReadRobotBody(view, resolved.target_iri));
  return GridFor(state_->robot_grids, state_->store, version, body);
}

TaskPackage Knowledge::MakePackage(const PlanRequest& request, const recipes::Plan& plan) {
  const Resolved recipe = Resolve(store::DocumentKind::kRecipe, request.task);
  const Resolved robot = Resolve(store::DocumentKind::kRobot, request.robot);
  State::Stack stack{&robot.document, &recipe.document, nullptr};
  std::optional<store::EnvironmentVersion> version;
  if (!plan.environment.empty()) {
    version = state_->store.GetVersion(plan.environment, plan.environment_version);
    stack.environment = &*version;
  }
  const rdf::View view = state_->ViewOf(stack);
  const auto catalogue = state_->catalogue();
  TaskPackage package;
  package.robot = RouteNameOf(robot);

  std::vector<ObjectModelInfo> stored = StoredObjectModels(state_->store);
  std::vector<models::Candidate> candidates;
  for (const ObjectModelInfo& info : stored) candidates.push_back(ToCandidate(info));
  ModelChooser chooser(view, std::move(stored));
  for (const Wanted& wanted : FindWanted(view, *catalogue, plan)) {
    if (!wanted.is_place) {
      chooser.ChooseForClass(wanted);
      continue;
    }
    const auto tables = FindPrior("lares");
    models::TypicalOptions options;
    options.room_iri = view.dictionary().Get(wanted.kind).value;
    options.robot_iri = robot.target_iri;
    chooser.ChooseForPlace(
        wanted, models::ChooseTypical(state_->engines, view, tables->rooms, candidates, options),
        tables->title);
  }
  package.models = chooser.models();
  package.reasons = chooser.reasons();

  const auto without_grid = [&](const std::string& why) {
    package.no_grid = why;
    package.reasons.push_back("there is no grid: " + why);
    return package;
  };
  if (!version) return without_grid("the plan was made for no environment");
  package.environment = version->environment;
  package.environment_version = version->number;
  package.layers = version->layers;
  if (!HasMap(*version)) return without_grid(WithoutMap(*version));
  const robots::Clearance body = robots::ClearanceOf(robots::ReadRobotBody(view, robot.target_iri));
  try {
    package.grid = GridFor(state_->robot_grids, state_->store, *version, body);
    Append(package.reasons, package.grid->reasons);
    Append(package.reasons, body.reasons);
  } catch (const Error& error) {
    if (!IsOfTheLayer(error)) throw;
    return without_grid(error.FullMessage());
  }
  return package;
}

}  // namespace lares::server
