// Plans: the three documents become one view, and the rules answer over it.
#include <utility>

#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
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
  const Asked asked = Understand(request);
  const recipes::MatchReport match = MatchTask(asked);
  recipes::PlanOptions options;
  options.match = &match;
  options.reading = &asked.task->reading;
  options.strict = request.strict;
  options.offers = asked.options.offers;
  for (const auto& [step, chosen] : request.templates) {
    options.templates[state_->aliases.Canonical(step)] = state_->aliases.Canonical(chosen);
  }
  for (const auto& [name, value] : request.set) {
    options.set[name] = state_->aliases.Canonical(value);
  }
  options.sequential = request.sequential;
  options.from = request.from;
  options.done = request.done;
  State::Stack stack{&asked.robot.document, &asked.recipe.document, nullptr};
  if (asked.environment) {
    stack.environment = &*asked.environment;
    options.environment = asked.environment->environment;
    options.environment_version = asked.environment->number;
    const auto info = state_->store.FindEnvironment(request.environment);
    if (info) options.environment_iri = info->type_iri;
    for (const store::LayerInfo& layer : asked.environment->layers) {
      options.layers.push_back(layer.name);
    }
  }
  PlanAnswer answer;
  answer.result = recipes::MakePlan(state_->engines, state_->ViewOf(stack), asked.recipe.target_iri,
                                    asked.robot.target_iri, options);
  if (!answer.result.match.feasible) AddOtherRobots(asked, answer);
  return answer;
}

// Who else could, and who nearly.
void Knowledge::AddOtherRobots(const Asked& asked, PlanAnswer& answer) {
  constexpr std::size_t kNearest = 3;
  const RobotsAnswer all = RankRobots(asked);
  for (const RobotRank& robot : all.robots) {
    if (robot.ranked.feasible) {
      answer.capable_robots.push_back(robot.ranked.robot);
      answer.capable_robots.back().label = robot.document;
    } else if (robot.document == asked.robot.document.id) {
      continue;  // what it lacks is the answer itself
    } else if (robot.ranked.cost && answer.nearest_robots.size() < kNearest) {
      answer.nearest_robots.push_back(robot);
    }
  }
}

}  // namespace lares::server
