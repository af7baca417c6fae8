#include "tests/server/api/fake_knowledge.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "ontology/rdf/reader.h"
#include "recipes/plan/diff.h"
#include "recipes/plan/export.h"

namespace lares {
namespace testing {

FakeAnswers& Answers() {
  static FakeAnswers answers;
  return answers;
}

rdf::View ViewOfTurtle(const std::string& turtle) {
  static const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::Document document = rdf::ReadRdf(turtle, rdf::Format::kTurtle, {});
  std::vector<rdf::Graph> graphs;
  graphs.push_back(rdf::MakeGraph(document, "recipe:demo", rdf::AliasTable{}, *dictionary));
  return rdf::View(dictionary)
      .With(std::make_shared<rdf::Layer>(std::move(graphs), rdf::Inference{}));
}

}  // namespace testing

namespace prolog {

struct EnginePool::State {};
EnginePool::EnginePool(const Options&) {}
EnginePool::~EnginePool() = default;

}  // namespace prolog

namespace server {

struct Knowledge::State {
  store::Store& store;
  Changes changes;
  rdf::AliasTable aliases{{{"http://old#", "https://w3id.org/lares#", "the old one", true}}};
};

Knowledge::Knowledge(store::Store& store, prolog::EnginePool&) : state_(new State{store}) {}
Knowledge::~Knowledge() = default;

PutAnswer Knowledge::Put(const PutRequest& request) {
  if (testing::Answers().put) return testing::Answers().put(request, state_->store);
  if (request.bytes.find("malformed") != std::string::npos && !request.recover) {
    throw Error(Code::kInvalid, "malformed comment", Place{request.file_name, 715, 6})
        .WithHint("--recover repairs this and lists what it did");
  }
  nlohmann::json details = nlohmann::json::object();
  for (const AttachedFile& file : request.files) {
    details["files"].push_back({{"file_name", file.file_name},
                                {"media_type", file.media_type},
                                {"sha256", file.blob.sha256},
                                {"size", file.blob.size}});
  }
  PutAnswer answer;
  answer.document =
      state_->store.PutDocument({request.kind,
                                 request.id,
                                 request.media_type.empty() ? "text/turtle" : request.media_type,
                                 request.file_name,
                                 request.bytes,
                                 details.dump(),
                                 {{"Label of " + request.id, "label", "urn:x"}},
                                 request.if_match});
  answer.statements = request.bytes.size();
  if (request.recover) {
    answer.remarks.push_back(
        {rdf::Remark::Kind::kRepair, Place{request.file_name, 715, 6}, "comment mended"});
  }
  answer.warnings.push_back("'urn:absent' is not in the catalogue");
  answer.tasks.push_back({{"urn:x", "FindBottle", "urn:x"}, true, true, {{"urn:s", "s", ""}}});
  answer.robots.push_back({"urn:r", "Pioneer", "urn:old-r"});
  return answer;
}

CheckAnswer Knowledge::Check(const CheckRequest& request) {
  CheckAnswer answer;
  answer.statements = request.bytes.size();
  if (request.bytes.find("bad") == std::string::npos) return answer;
  answer.report.is_clean = answer.report.is_owl2_rl = false;
  answer.report.findings = {
      {profile::Kind::kProfile,
       "owl:unionOf on the side of the superclass",
       7,
       {{request.file_name, 3, 5}, {request.file_name, 9, 1}},
       {"Cup", "Mug"}},
      {profile::Kind::kRemark, "punning", 1, {{request.file_name, 4, 1}}, {"A"}}};
  answer.warnings = {"imports <urn:x>, which is absent"};
  return answer;
}

void Knowledge::Remove(store::DocumentKind kind, const std::string& id) {
  state_->store.DeleteDocument(kind, id);
}

PutAnswer Knowledge::Release(const std::string& quarantine_id, bool editor) {
  PutRequest request;
  request.id = quarantine_id;
  request.editor = editor;
  return Put(request);
}

Knowledge::VersionAnswer Knowledge::PutVersion(const store::NewVersion& version,
                                               const VersionRights&) {
  VersionAnswer answer;
  answer.version = state_->store.PutVersion(version);
  answer.warnings = {"a warning"};
  return answer;
}

Knowledge::VersionAnswer Knowledge::ReleaseVersion(const std::string& quarantine_id, bool) {
  throw Error(Code::kNotFound, "no document '" + quarantine_id + "' is kept aside");
}

std::string Knowledge::RenderSemantic(const std::string& environment, int version,
                                      rdf::Format format) {
  return environment + "/" + std::to_string(version) + " as " + std::string(rdf::MediaType(format));
}

store::Store& Knowledge::store() const { return state_->store; }

bool Knowledge::Refresh() { return false; }

void Knowledge::IndexEnvironments() {}

rdf::Document Knowledge::ReadSemantic(const std::string&, const store::LayerInfo& layer) {
  return rdf::ReadRdf(state_->store.ReadBlob(layer.blob.sha256), rdf::Format::kTurtle, {});
}

// By words and layers only.
std::vector<store::EnvironmentInfo> Knowledge::SearchEnvironments(const EnvironmentQuery& query) {
  store::EnvironmentSearch search;
  if (!query.text.empty()) search.all_of.push_back({"word", {query.text}, false});
  for (const std::string& layer : query.layers) search.all_of.push_back({"layer", {layer}, false});
  search.changed_from = query.changed_from;
  search.after = query.after;
  search.limit = query.limit;
  return state_->store.SearchEnvironments(search);
}

std::vector<semantic::MapObject> Knowledge::MapObjects(const std::string&, int) {
  semantic::MapObject bottle;
  bottle.iri = "urn:bottle1";
  bottle.label = "bottle1";
  bottle.class_iri = "https://w3id.org/lares#Bottle";
  bottle.map_from_object = RigidTransform{};
  bottle.map_from_object->translation_m = {1, 2, 3};
  bottle.existence = 0.9;
  bottle.last_seen = Now();
  return {bottle};
}

PlanAnswer Knowledge::MakePlan(const PlanRequest& request) {
  if (testing::Answers().plan) return testing::Answers().plan(request);
  PlanAnswer answer;
  answer.result.match.feasible = true;
  recipes::Plan plan;
  plan.task = {"urn:" + request.task, request.task, ""};
  plan.robot = {"urn:" + request.robot, request.robot, ""};
  answer.result.plan = plan;
  return answer;
}

TaskPackage Knowledge::MakePackage(const PlanRequest& request, const recipes::Plan&) {
  TaskPackage package;
  package.robot = request.robot;
  package.no_grid = "the plan was made for no environment";
  if (request.environment.empty()) return package;
  package.environment = request.environment;
  const store::EnvironmentVersion version =
      state_->store.GetVersion(request.environment, request.environment_version);
  package.environment_version = version.number;
  package.layers = version.layers;
  package.grid = MakeRobotGrid(request.robot, request.environment, version.number);
  for (const ObjectModelInfo& info : ObjectModels({})) {
    PackageModel model{info.document, info.classes, {}, {"because"}};
    const auto details = nlohmann::json::parse(info.document.details_json);
    for (const auto& file : details.value("files", nlohmann::json::array())) {
      model.files.push_back(
          {file["file_name"], file["media_type"], {file["sha256"], file["size"]}});
    }
    package.models.push_back(model);
  }
  package.reasons = {"because"};
  return package;
}

std::shared_ptr<const RobotGrid> Knowledge::MakeRobotGrid(const std::string& robot,
                                                          const std::string& environment, int) {
  if (robot == "nobody") throw Error(Code::kNotFound, "no robot is called 'nobody'");
  auto grid = std::make_shared<RobotGrid>();
  grid->yaml = "image: map.pgm\n# of " + robot + " in " + environment + "\n";
  grid->pgm = "P5\n2 1\n255\nab";
  grid->yaml_sha256 = Sha256Hex(grid->yaml);
  grid->pgm_sha256 = Sha256Hex(grid->pgm);
  grid->layer = "octomap";
  grid->heights_m = {0.1, 1.4};
  grid->width = 2;
  grid->height = 1;
  return grid;
}

std::vector<recipes::SkillTemplate> Knowledge::SkillTemplates() {
  recipes::SkillTemplate wave;
  wave.iri = {"urn:WaveTemplate", "wave", ""};
  wave.skill = "Wave";
  return {wave};
}

recipes::CapabilityReport Knowledge::Capabilities(const std::string& robot, bool strict) {
  if (robot == "nobody") throw Error(Code::kNotFound, "there is no robot 'nobody'");
  recipes::CapabilityReport report;
  report.robot = {"urn:" + robot, robot, ""};
  recipes::Finding finding;
  finding.what = {"urn:Grasping", strict ? "strict grasping" : "grasping", ""};
  report.capabilities.push_back(finding);
  return report;
}

recipes::MatchReport Knowledge::MatchTask(const PlanRequest& request) {
  return MakePlan(request).result.match;
}

RobotsAnswer Knowledge::RankRobots(const RobotsRequest& request) {
  RobotsAnswer answer;
  answer.task = {"urn:" + request.task, request.task, ""};
  recipes::RankedRobot able;
  able.robot = {"urn:rover", "Rover", ""};
  able.feasible = true;
  able.cost = request.environment.empty() ? 0 : 0.1;
  if (!request.environment.empty()) able.downloads = {{"urn:map", "map", ""}};
  recipes::RankedRobot unable;
  unable.robot = {"urn:statue", "Statue", ""};
  unable.cost = 200;
  recipes::Measure speed;
  speed.quantity = {"urn:speed", "max speed", ""};
  speed.unit = "m/s";
  speed.at_least = 0.5;
  unable.repair = {{{{"urn:Base", "base", ""}, {speed}, 200, "base with a max speed"}}, 200};
  recipes::RankedRobot hopeless;
  hopeless.robot = {"urn:stone", "Stone", ""};
  hopeless.repair_is_smallest = !request.strict;
  answer.robots = {{"rover", able}, {"statue", unable}, {"stone", hopeless}};
  return answer;
}

WhereAnswer Knowledge::Where(const WhereRequest& request) {
  if (testing::Answers().where) return testing::Answers().where(request);
  WhereAnswer answer;
  answer.object = {"https://w3id.org/lares#" + request.object, request.object, ""};
  answer.prior = request.prior.empty() ? "lares" : request.prior;
  answer.prior_title = "Where things are";
  answer.rooms = {{{"urn:Kitchen", "Kitchen", ""}, 0.72834, 41},
                  {{"urn:Office", "Office", ""}, 0.1608, 9}};
  if (!request.environment.empty()) {
    answer.seen.push_back({request.environment, 1, MapObjects(request.environment, 1).front()});
  }
  return answer;
}

std::vector<ObjectModelInfo> Knowledge::ObjectModels(const ObjectModelQuery& query) {
  std::vector<ObjectModelInfo> models;
  for (auto& document : state_->store.ListDocuments(store::DocumentKind::kObjectModel)) {
    ObjectModelInfo info;
    info.document = document;
    info.classes = {{"urn:Cabinet", "Cabinet", ""}};
    info.above = {{}};
    info.makers = {{"", query.maker, ""}};
    info.extents = {{0.4, 0.8, 0.6}, true, "meta.xml"};
    if (!query.class_name.empty()) info.fit = ObjectModelInfo::Fit::kSame;
    if (!query.room.empty()) info.probability = 0.25;
    const auto details = nlohmann::json::parse(document.details_json);
    for (const auto& file : details.value("files", nlohmann::json::array())) {
      info.files.push_back({file["file_name"], file["media_type"], {file["sha256"], file["size"]}});
    }
    models.push_back(std::move(info));
  }
  if (!query.class_name.empty() && query.class_name != "Cabinet") models.clear();
  return models;
}

// Loads all but those that `max_models` leaves out.
TypicalAnswer Knowledge::TypicalModels(const TypicalRequest& request) {
  if (request.robot == "nobody") throw Error(Code::kNotFound, "there is no robot 'nobody'");
  TypicalAnswer answer;
  answer.room = {"urn:" + request.room, request.room, ""};
  if (!request.robot.empty()) answer.robot = {"urn:" + request.robot, request.robot, ""};
  answer.prior = request.prior.empty() ? "lares" : request.prior;
  for (ObjectModelInfo& info : ObjectModels({})) {
    models::Choice choice;
    choice.id = info.document.id;
    choice.probability = request.strict ? 0.5 : 0.25;
    choice.why = "because";
    const bool fits = answer.loaded.size() < request.max_models.value_or(1000);
    choice.verdict = fits ? models::Verdict::kLoaded : models::Verdict::kTooMany;
    auto& list = fits ? answer.loaded : answer.left_out;
    list.push_back({info, info.classes.front(), choice});
  }
  return answer;
}

recipes::Resource Knowledge::ResolveClass(const std::string& name) {
  if (name == "Nonsense") {
    throw Error(Code::kNotFound, "there is no class 'Nonsense'").WithCandidates({"Nonce"});
  }
  return {"https://w3id.org/lares#" + name, name, ""};
}

recipes::Resource Knowledge::ResolveComponent(const std::string& name) {
  return ResolveClass(name);
}

Knowledge::Resolved Knowledge::Resolve(store::DocumentKind kind, const std::string& name) {
  if (const auto document = state_->store.FindDocument(kind, name)) return {*document, "urn:r"};
  throw Error(Code::kNotFound, "there is no robot '" + name + "'");
}

const rdf::AliasTable& Knowledge::aliases() const { return state_->aliases; }
std::vector<Knowledge::Module> Knowledge::Modules() const {
  return {{"core", "built-in", 100}, {"knowrob", "stored", 2000}};
}
Changes& Knowledge::changes() { return state_->changes; }
rdf::View Knowledge::ViewFor(const ViewRequest& request) {
  if (testing::Answers().view) return testing::Answers().view(request);
  if (!request.environment.empty()) {
    throw Error(Code::kNotFound, "no environment '" + request.environment + "'");
  }
  return Catalogue();
}
rdf::View Knowledge::Catalogue() const { return rdf::View(std::make_shared<rdf::Dictionary>()); }
Knowledge::Counts Knowledge::counts() const { return {10, 20, 30, 1, 0}; }

}  // namespace server

namespace recipes {

nlohmann::json ToJson(const MatchReport& report) {
  return {{"feasible", report.feasible}, {"task", report.task.label}};
}
nlohmann::json ToJson(const Plan& plan) {
  return {{"task", plan.task.label}, {"robot", plan.robot.label}};
}
nlohmann::json ToJson(const PlanResult& result) {
  return {{"match", ToJson(result.match)}, {"problems", result.problems}};
}
std::string ToBehaviorTreeXml(const Plan& plan) {
  return "<root task=\"" + plan.task.label + "\"/>";
}
std::string ToPddlDomain(const Plan&) { return "(define (domain d))\n"; }
std::string ToPddlProblem(const Plan&) { return "(define (problem p))\n"; }
Plan PlanFromJson(const nlohmann::json& json) {
  if (!json.contains("task")) throw Error(Code::kInvalid, "/ lacks \"task\"");
  Plan plan;
  plan.task.label = json.at("task");
  return plan;
}
PlanDiff DiffPlans(const Plan& a, const Plan& b) {
  PlanDiff diff{a.task.label, b.task.label, {}};
  if (diff.a != diff.b) diff.differences.emplace_back();
  return diff;
}
nlohmann::json ToJson(const PlanDiff& diff) { return {{"a", diff.a}, {"b", diff.b}}; }
std::string ToText(const PlanDiff& diff) { return diff.a + " against " + diff.b + "\n"; }
std::string ToDot(const Plan&) { return "digraph {}\n"; }
std::string ToText(const Plan& plan) { return "plan of " + plan.task.label + "\n"; }
std::string ToText(const MatchReport& report) { return report.task.label + " needs more\n"; }

}  // namespace recipes
}  // namespace lares
