// Every stored robot against one task.
#include "server/knowledge/ranking.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/aside.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/offers.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

using store::DocumentKind;

std::string KeyOf(const CatalogueState& catalogue, const std::string& source_key,
                  const std::string& target) {
  return source_key + "|" + target + "|" + std::to_string(catalogue.generation);
}

// The documents over exactly this catalogue; not among the overlays, where a hundred robots would
// push out all others.
rdf::View ViewOver(const CatalogueState& catalogue, const std::vector<OverlaySource>& sources) {
  rdf::View view = catalogue.view;
  for (const OverlaySource& source : sources) {
    const rdf::Graph graph = source.read();
    view = view.With(Aside([&] { return owl::Materialise(view, {graph}); }));
  }
  return view;
}

void RequireTarget(const Knowledge::Resolved& resolved) {
  if (!resolved.target_iri.empty()) return;
  throw Error(Code::kNotFound, "'" + resolved.document.id + "' describes nothing to use");
}

// The classes of things that a plan request gives as values: of the parameters that the recipe
// declares as classes, and of inputs that are classes in some skill template.
class ObjectsAskedFor {
 public:
  ObjectsAskedFor(const CatalogueState& catalogue, const store::DocumentInfo& recipe,
                  const rdf::AliasTable& aliases)
      : catalogue_(catalogue), aliases_(aliases) {
    const auto details = nlohmann::json::parse(recipe.details_json, nullptr, false);
    if (!details.is_object()) return;
    for (const auto& task : details.value("tasks", nlohmann::json::array())) {
      for (const auto& parameter : task.value("parameters", nlohmann::json::array())) {
        types_[parameter.value("name", "")] = parameter.value("type", "");
      }
    }
  }

  // What is no class, or one of several, is left out: planning says so where it matters.
  void Add(const std::string& name, const std::string& value,
           std::vector<recipes::Resource>& classes) const {
    if (!IsClass(name)) return;
    for (const std::string& part : Split(value, ',')) AddClass(std::string(Trim(part)), classes);
  }

 private:
  bool IsClass(const std::string& name) const {
    const auto declared = types_.find(name);
    if (declared != types_.end()) {
      return declared->second == "class" || declared->second == "class_list";
    }
    return IsClassInput(name.substr(name.rfind('.') + 1));  // npos + 1 is 0
  }
  bool IsClassInput(const std::string& name) const {
    const rdf::View& view = catalogue_.view;
    const rdf::Dictionary& dictionary = view.dictionary();
    const auto named = dictionary.FindIri(std::string(rdf::kLares) + "parameterName");
    const auto typed = dictionary.FindIri(std::string(rdf::kLares) + "parameterType");
    if (!named || !typed) return false;
    bool found = false;
    view.ForEach({rdf::kAnyTerm, *named, rdf::kAnyTerm}, [&](const rdf::Triple& triple) {
      if (dictionary.Get(triple.object).value != name) return true;
      for (const rdf::TermId type : view.Objects(triple.subject, *typed)) {
        found = found || dictionary.Get(type).value == "class";
      }
      return !found;
    });
    return found;
  }
  void AddClass(const std::string& name, std::vector<recipes::Resource>& classes) const {
    const rdf::View& view = catalogue_.view;
    const rdf::Dictionary& dictionary = view.dictionary();
    const auto sub_class = dictionary.FindIri(std::string(rdf::kRdfs) + "subClassOf");
    const auto object = dictionary.FindIri(std::string(rdf::kLares) + "PhysicalObject");
    auto term = dictionary.FindIri(aliases_.Canonical(name));
    const auto named = catalogue_.classes_by_name.find(ToLower(name));
    if (named != catalogue_.classes_by_name.end() && named->second.size() == 1) {
      term = named->second.front();
    }
    if (term && sub_class && object && view.Contains({*term, *sub_class, *object})) {
      classes.push_back(Describe(view, *term));
    }
  }

  const CatalogueState& catalogue_;
  const rdf::AliasTable& aliases_;
  std::map<std::string, std::string> types_;  // of the parameters that the recipe declares
};

}  // namespace

std::shared_ptr<const TaskKnowledge> Knowledge::State::TaskOf(
    const std::shared_ptr<const CatalogueState>& base, const store::DocumentInfo& recipe,
    const std::string& task_iri) {
  std::vector<OverlaySource> sources;
  for (const store::DocumentInfo& nested : NestedIn(recipe)) {
    sources.push_back(SourceOf(GraphName(nested.kind, nested.id), nested));
  }
  sources.push_back(SourceOf(GraphName(recipe.kind, recipe.id), recipe));
  std::string key;
  for (const OverlaySource& source : sources) key += source.key + "|";
  return match_memory.tasks.Get(KeyOf(*base, key, task_iri), [&]() -> TaskKnowledge {
    const rdf::View view = ViewOver(*base, sources);
    return {recipes::FindNeeds(engines, view, task_iri),
            recipes::ReadRecipe(engines, view, task_iri)};
  });
}

std::shared_ptr<const recipes::RobotProfile> Knowledge::State::ProfileOf(
    const std::shared_ptr<const CatalogueState>& base, const store::DocumentInfo& robot,
    const std::string& robot_iri) {
  const OverlaySource source = SourceOf(GraphName(robot.kind, robot.id), robot);
  return match_memory.profiles.Get(KeyOf(*base, source.key, robot_iri), [&] {
    return recipes::DescribeRobot(engines, ViewOver(*base, {source}), robot_iri);
  });
}

std::vector<recipes::Offer> Knowledge::State::OffersFor(
    const CatalogueState& base, std::vector<recipes::Resource> sought,
    const store::EnvironmentVersion* environment) {
  std::vector<recipes::Offer> offers = ModelOffers(store, base.view, sought);
  if (environment == nullptr) return offers;
  std::vector<recipes::Offer> maps = MapOffers(*environment);
  std::move(maps.begin(), maps.end(), std::back_inserter(offers));
  return offers;
}

Knowledge::Asked Knowledge::UnderstandTask(const PlanRequest& request) {
  Asked asked;
  asked.recipe = Resolve(DocumentKind::kRecipe, request.task);
  RequireTarget(asked.recipe);
  if (!request.environment.empty()) {
    asked.environment = state_->store.GetVersion(request.environment, request.environment_version);
  }
  asked.base = state_->catalogue();
  asked.task = state_->TaskOf(asked.base, asked.recipe.document, asked.recipe.target_iri);
  std::vector<recipes::Resource> sought = asked.task->needs.sought;
  ObjectsAskedFor given(*asked.base, asked.recipe.document, state_->aliases);
  for (const auto& [name, value] : request.set) given.Add(name, value, sought);
  asked.options.strict = request.strict;
  asked.options.offers = state_->OffersFor(*asked.base, std::move(sought),
                                           asked.environment ? &*asked.environment : nullptr);
  return asked;
}

Knowledge::Asked Knowledge::Understand(const PlanRequest& request) {
  const Resolved robot = Resolve(DocumentKind::kRobot, request.robot);
  PlanRequest pinned = request;
  pinned.environment_version =
      state_->VersionFor(robot.document.id, request.environment, request.environment_version);
  Asked asked = UnderstandTask(pinned);
  asked.robot = robot;
  RequireTarget(asked.robot);
  return asked;
}

recipes::MatchReport Knowledge::MatchTask(const Asked& asked) {
  const auto profile = state_->ProfileOf(asked.base, asked.robot.document, asked.robot.target_iri);
  return recipes::Match(asked.task->needs, *profile, asked.options);
}

recipes::MatchReport Knowledge::MatchTask(const PlanRequest& request) {
  return MatchTask(Understand(request));
}

RobotsAnswer Knowledge::RankRobots(const RobotsRequest& request) {
  PlanRequest task;
  task.task = request.task;
  task.environment = request.environment;
  task.environment_version = request.environment_version;
  task.strict = request.strict;
  return RankRobots(UnderstandTask(task));
}

RobotsAnswer Knowledge::RankRobots(const Asked& asked) {
  RobotsAnswer answer;
  answer.task = asked.task->needs.task;
  for (const store::DocumentInfo& document : state_->store.ListDocuments(DocumentKind::kRobot)) {
    for (const store::DocumentName& name : document.names) {
      if (name.kind != "id") continue;
      const auto profile = state_->ProfileOf(asked.base, document, name.target);
      answer.robots.push_back(
          {document.id, recipes::Rank(asked.task->needs, *profile, asked.options)});
    }
  }
  std::sort(answer.robots.begin(), answer.robots.end(),
            [](const auto& a, const auto& b) { return recipes::RanksBefore(a.ranked, b.ranked); });
  return answer;
}

}  // namespace lares::server
