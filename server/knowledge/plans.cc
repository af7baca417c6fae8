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
  PlanAnswer answer;
  answer.result = recipes::MakePlan(state_->engines, state_->ViewOf(stack), OneTarget(recipe),
                                    OneTarget(robot), options);
  if (!answer.result.match.feasible) {
    answer.capable_robots = CapableRobots(request.task, request.strict);
  }
  return answer;
}

std::vector<recipes::Resource> Knowledge::CapableRobots(const std::string& task, bool strict) {
  const Resolved recipe = Resolve(store::DocumentKind::kRecipe, task);
  const std::string task_iri = OneTarget(recipe);
  recipes::MatchOptions options;
  options.strict = strict;
  std::vector<recipes::Resource> capable;
  for (const store::DocumentInfo& document :
       state_->store.ListDocuments(store::DocumentKind::kRobot)) {
    for (const store::DocumentName& name : document.names) {
      if (name.kind != "id") continue;
      const rdf::View view = state_->ViewOf({&document, &recipe.document, nullptr});
      if (recipes::Match(state_->engines, view, task_iri, name.target, options).feasible) {
        recipes::Resource robot = Describe(view, name.target);
        robot.label = document.id;
        capable.push_back(std::move(robot));
      }
    }
  }
  return capable;
}

}  // namespace lares::server
