#include "tests/recipes/plan_maker.h"

namespace lares::testing {

recipes::PlanResult MakePlanOf(const std::string& recipe, const recipes::PlanOptions& options,
                               const std::string& robot, const std::string& more) {
  World world = Catalogue();
  if (!more.empty()) world.Put("more", more);
  world.Put("robot", robot).Put("recipe", recipe);
  return recipes::MakePlan(Engines(), world.view(), Example("Task"), Example("robot"), options);
}

const recipes::State& StateOf(const recipes::Plan& plan, const std::string& id) {
  static const recipes::State kNone;
  for (const recipes::State& state : plan.states) {
    if (state.id == id) return state;
  }
  ADD_FAILURE() << "no state " << id;
  return kNone;
}

const recipes::Parameter& Input(const recipes::Plan& plan, const std::string& state_id,
                                const std::string& name) {
  static const recipes::Parameter kNone;
  for (const recipes::Parameter& input : StateOf(plan, state_id).inputs) {
    if (input.name == name) return input;
  }
  ADD_FAILURE() << state_id << " has no input " << name;
  return kNone;
}

std::vector<std::string> Ids(const recipes::Plan& plan) {
  std::vector<std::string> ids;
  for (const recipes::State& state : plan.states) ids.push_back(state.id);
  return ids;
}

}  // namespace lares::testing
