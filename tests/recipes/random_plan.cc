#include "tests/recipes/random_plan.h"

#include <algorithm>

#include "recipes/plan/shape.h"

namespace lares::testing {
namespace {

using recipes::Plan;
using recipes::State;

int Below(std::mt19937& random, int limit) {
  return std::uniform_int_distribution<int>(0, limit - 1)(random);
}

State SkillState(std::mt19937& random, int index) {
  State state;
  state.id = "step-" + std::to_string(index);
  state.label = "step <" + std::to_string(index) + "> & \"more\"";
  state.skill = "Skill" + std::to_string(Below(random, 3));
  state.skill_template = "https://example.org/template";
  state.step = {"https://example.org/" + state.id, state.label, "https://example.org/" + state.id};
  state.action = {"https://example.org/Action", "Action", "https://example.org/Action"};
  const std::vector<std::vector<std::string>> outcomes = {
      {"succeeded", "failed"}, {"true", "false", "failed"}, {"succeeded", "exhausted", "failed"}};
  state.outcomes = outcomes[static_cast<std::size_t>(Below(random, 3))];
  state.inputs.push_back({"thing", "string", "", "a <b> & 'c' \"d\"", "", "", {}, {}});
  return state;
}

State End(const std::string& id, bool success) {
  State state;
  state.id = state.label = id;
  state.kind = State::Kind::kEnd;
  state.success = success;
  return state;
}

// Drops what cannot be reached.
void Prune(Plan& plan) {
  const auto reached = recipes::ReachableFrom(recipes::WaysOf(plan), plan.start);
  const auto gone = [&](const std::string& id) { return reached.count(id) == 0; };
  plan.states.erase(std::remove_if(plan.states.begin(), plan.states.end(),
                                   [&](const State& state) { return gone(state.id); }),
                    plan.states.end());
  plan.transitions.erase(
      std::remove_if(plan.transitions.begin(), plan.transitions.end(),
                     [&](const recipes::Transition& way) { return gone(way.from); }),
      plan.transitions.end());
}

Plan AnyPlan(std::mt19937& random, int max_states) {
  Plan plan;
  plan.task = {"https://example.org/task#Do-It", "do it", "https://example.org/task#Do-It"};
  plan.robot = {"https://example.org/robot", "robot", "https://example.org/robot"};
  const int count = 1 + Below(random, max_states);
  for (int i = 0; i < count; ++i) plan.states.push_back(SkillState(random, i));
  plan.states.push_back(End("succeeded", true));
  plan.states.push_back(End("failed", false));
  plan.start = "step-0";
  for (int i = 0; i < count; ++i) {
    const State& state = plan.states[static_cast<std::size_t>(i)];
    for (const std::string& outcome : state.outcomes) {
      // Failing always ends, so that an end can be reached from everywhere.
      const int to =
          outcome == "failed" && Below(random, 2) == 0 ? count + 1 : Below(random, count + 2);
      plan.transitions.push_back(
          {state.id, outcome, plan.states[static_cast<std::size_t>(to)].id, false, ""});
    }
  }
  Prune(plan);
  return plan;
}

}  // namespace

Plan RandomPlan(std::mt19937& random, int max_states) {
  for (;;) {
    Plan plan = AnyPlan(random, max_states);
    if (recipes::CheckPlan(plan).empty()) return plan;
  }
}

}  // namespace lares::testing
