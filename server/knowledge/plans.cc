// Plans: the three documents become one view, and the rules answer over it.
#include <utility>

#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

std::string OneTarget(const Knowledge::Resolved& resolved) {
  if (resolved.target_iri.empty()) {
    throw Error(Code::kNotFound, "'" + resolved.document.id + "' describes nothing to use");
  }
  return resolved.target_iri;
}

}  // namespace

rdf::View Knowledge::ViewFor(const ViewRequest& request) {
  State::Stack stack;
  std::optional<store::DocumentInfo> robot, recipe;
  std::optional<store::EnvironmentVersion> environment;
  if (!request.robot.empty()) {
    robot = Resolve(store::DocumentKind::kRobot, request.robot).document;
    stack.robot = &*robot;
  }
  if (!request.recipe.empty()) {
    recipe = Resolve(store::DocumentKind::kRecipe, request.recipe).document;
    stack.recipe = &*recipe;
  }
  if (!request.environment.empty()) {
    environment = state_->store.GetVersion(request.environment, request.environment_version);
    stack.environment = &*environment;
  }
  return state_->ViewOf(stack);
}

std::vector<recipes::SkillTemplate> Knowledge::SkillTemplates() {
  return recipes::FindTemplates(state_->engines, Catalogue());
}

PlanAnswer Knowledge::MakePlan(const PlanRequest& request) {
  const Resolved recipe = Resolve(store::DocumentKind::kRecipe, request.task);
  const Resolved robot = Resolve(store::DocumentKind::kRobot, request.robot);
  recipes::PlanOptions options;
  options.strict = request.strict;
  for (const auto& [step, chosen] : request.templates) {
    options.templates[state_->aliases.Canonical(step)] = state_->aliases.Canonical(chosen);
  }
  for (const auto& [name, value] : request.set) {
    options.set[name] = state_->aliases.Canonical(value);
  }
  options.sequential = request.sequential;
  options.from = request.from;
  options.done = request.done;
  State::Stack stack{&robot.document, &recipe.document, nullptr};
  std::optional<store::EnvironmentVersion> environment;
  if (!request.environment.empty()) {
    const auto info = state_->store.FindEnvironment(request.environment);
    environment = state_->store.GetVersion(request.environment, request.environment_version);
    stack.environment = &*environment;
    options.environment = environment->environment;
    options.environment_version = environment->number;
    if (info) options.environment_iri = info->type_iri;
    for (const store::LayerInfo& layer : environment->layers) options.layers.push_back(layer.name);
  }
  options.offers = state_->OffersFor(recipe.document, OneTarget(recipe), stack.environment,
                                     ObjectsAskedFor(request));
  const recipes::MatchReport match = MatchTask(request);
  options.match = &match;
  PlanAnswer answer;
  answer.result = recipes::MakePlan(state_->engines, state_->ViewOf(stack), OneTarget(recipe),
                                    OneTarget(robot), options);
  if (!answer.result.match.feasible) AddOtherRobots(request, answer);
  return answer;
}

// Who else could, and who nearly.
void Knowledge::AddOtherRobots(const PlanRequest& request, PlanAnswer& answer) {
  constexpr std::size_t kNearest = 3;
  const std::string asked = Resolve(store::DocumentKind::kRobot, request.robot).document.id;
  const RobotsAnswer all =
      RankRobots({request.task, request.environment, request.environment_version, request.strict});
  for (const RobotRank& robot : all.robots) {
    if (robot.ranked.feasible) {
      answer.capable_robots.push_back(robot.ranked.robot);
      answer.capable_robots.back().label = robot.document;
    } else if (robot.document == asked) {
      continue;  // what it lacks is the answer itself
    } else if (robot.ranked.cost && answer.nearest_robots.size() < kNearest) {
      answer.nearest_robots.push_back(robot);
    }
  }
}

}  // namespace lares::server
