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

recipes::Resource Thing(const std::string& name) {
  return {"https://example.org/thing#" + name, name, "https://example.org/thing#" + name};
}

recipes::Fluent RandomFluent(std::mt19937& random) {
  static const std::vector<recipes::Fluent> kFluents = {
      {"holding", "https://example.org/thing#cup", true},
      {"holding", "https://other.example.org/Cup", true},
      {"holding", "*", false},
      {"hand_empty", "", true},
      {"at", "{next_pose}", true}};
  recipes::Fluent fluent = kFluents[static_cast<std::size_t>(Below(random, 5))];
  if (fluent.argument != "*") fluent.holds = Below(random, 3) > 0;
  return fluent;
}

void DecorateSkill(std::mt19937& random, State& state) {
  static const std::vector<std::string> kFragments = {
      "<RetryUntilSuccessful num_attempts=\"2\"><Delay delay_msec=\"25\"><Skill/></Delay>"
      "</RetryUntilSuccessful>",
      "<Timeout msec=\"300\"><RetryUntilSuccessful num_attempts=\"5\"><Timeout msec=\"90\">"
      "<Skill/></Timeout></RetryUntilSuccessful></Timeout>",
      "<Delay delay_msec=\"40\">\n  <Timeout msec='120'><Skill></Skill></Timeout>\n</Delay>",
      "<Timeout msec=\"95\"><Delay delay_msec=\"40\"><Skill/></Delay></Timeout>"};
  static const std::vector<double> kLimits_s = {0, 0, 0.03, 0.1, 0.205};
  state.retries = Below(random, 3);
  state.time_limit_s = kLimits_s[static_cast<std::size_t>(Below(random, 5))];
  if (Below(random, 5) == 0) {
    state.tree_fragment = kFragments[static_cast<std::size_t>(Below(random, 4))];
  }
  if (Below(random, 3) == 0) state.claims.push_back(Thing("Base"));
  if (Below(random, 3) == 0) state.preconditions.push_back(RandomFluent(random));
  for (int count = Below(random, 3); count > 0; --count) {
    const auto outcome =
        static_cast<std::size_t>(Below(random, static_cast<int>(state.outcomes.size())));
    state.effects.push_back({state.outcomes[outcome], RandomFluent(random)});
  }
  if (Below(random, 4) == 0)
    state.outputs.emplace("found", Below(random, 2) == 0 ? "state" : "next_pose");
  if (Below(random, 3) == 0) {
    state.inputs.push_back({"pose", "pose", "m", "1 2 0 0 0 0 1", "map", "at the table",
                            recipes::Parameter::Source::kRobot, Thing("camera")});
  }
}

// A state that can succeed and fail only becomes one that runs two or three skills.
void MakeParallel(std::mt19937& random, Plan& plan, std::size_t at) {
  State parallel;
  parallel.id = plan.states[at].id;
  parallel.label = "side by side";
  parallel.kind = State::Kind::kParallel;
  parallel.outcomes = plan.states[at].outcomes;
  std::vector<State> members;
  for (int i = 2 + Below(random, 2); i > 0; --i) {
    State member = plan.states[at];
    member.id += "-member-" + std::to_string(i);
    member.parallel = parallel.id;
    parallel.members.push_back(member.id);
    members.push_back(std::move(member));
  }
  plan.states[at] = std::move(parallel);
  plan.states.insert(plan.states.begin() + static_cast<std::ptrdiff_t>(at) + 1, members.begin(),
                     members.end());
}

recipes::MatchReport RandomMatch(std::mt19937& random, const Plan& plan) {
  recipes::MatchReport match;
  match.task = plan.task;
  match.robot = plan.robot;
  match.feasible = true;
  match.needs.push_back({Thing("Step"), Thing("Moving"), {Thing("Step"), Thing("Navigating")}});
  recipes::Finding component;
  component.kind = recipes::Finding::Kind::kComponent;
  component.what = Thing("Laser");
  component.provided_by = {Thing("laser1")};
  recipes::Finding capability;
  capability.what = Thing("Moving");
  capability.asserted = Below(random, 2) == 0;
  capability.availability = capability.asserted ? recipes::Availability::kOnMakersWord
                                                : recipes::Availability::kAvailable;
  capability.dependencies.push_back(component);
  capability.explanation = "the robot has it";
  recipes::Measure measure;
  measure.quantity = Thing("max range");
  measure.unit = "m";
  measure.at_least = 0.1 * Below(random, 50);
  if (Below(random, 2) == 0) measure.actual = 5.5;
  measure.verdict =
      measure.actual ? recipes::Measure::Verdict::kMet : recipes::Measure::Verdict::kUnknown;
  measure.stated_by = Thing("Looking");
  const recipes::Offer offer{"https://example.org/thing#Model",
                             "cup",
                             "object-model:cup",
                             "model.ply",
                             "/v1/object-models/cup",
                             std::string(64, 'a'),
                             static_cast<std::uint64_t>(1000 + Below(random, 3))};
  if (Below(random, 2) == 0) {
    component.measures.push_back(measure);
    match.requirements.push_back({{Thing("Step")}, component});
  }
  if (Below(random, 2) == 0) {
    component.downloads.push_back(offer);
    component.availability = recipes::Availability::kDownloadable;
    capability.dependencies.push_back(component);
    match.downloads.push_back({Thing("Cup"), offer});
  }
  if (Below(random, 4) == 0) {
    match.repairs.push_back({{{Thing("Arm"), {measure}, 2.5, "an arm"}}, 2.5});
    match.repairs.back().add[0].bounds[0] = {};
    match.repairs.back().add[0].bounds[0].quantity = Thing("payload");
    match.repairs.back().add[0].bounds[0].unit = "kg";
    match.repairs.back().add[0].bounds[0].at_most = 2;
    match.repair_is_smallest = false;
  }
  match.capabilities.push_back(capability);
  if (capability.asserted) match.warnings.emplace_back("on the maker's word");
  return match;
}

void DecoratePlan(std::mt19937& random, Plan& plan) {
  if (Below(random, 2) == 0) {
    plan.environment = "flat";
    plan.environment_version = Below(random, 3);
  }
  if (Below(random, 2) == 0) plan.unordered.push_back({"one", "two"});
  if (Below(random, 2) == 0) plan.notes.emplace_back("a note with \"quotes\"");
  if (Below(random, 2) == 0) {
    plan.settings.push_back(
        {"object", "class", "", "https://example.org/Cup", "Cup", false, "Mug"});
    plan.settings.push_back({"speed", "number", "m/s", "0.5", "", true, ""});
  }
  for (int count = Below(random, 3); count > 0; --count) {
    plan.assumptions.push_back(RandomFluent(random));
  }
  if (Below(random, 4) == 0) plan.done.emplace_back("step-before");
  if (Below(random, 4) == 0) plan.given.emplace_back("next_pose");
  plan.match = RandomMatch(random, plan);
}

}  // namespace

Plan RandomFullPlan(std::mt19937& random, int max_states) {
  Plan plan = RandomPlan(random, max_states);
  for (std::size_t at = 0; at < plan.states.size(); ++at) {
    const State& state = plan.states[at];
    const bool plain = state.outcomes == std::vector<std::string>{"succeeded", "failed"};
    if (plain && state.parallel.empty() && Below(random, 2) == 0) MakeParallel(random, plan, at);
  }
  for (State& state : plan.states) {
    if (state.kind == State::Kind::kSkill) DecorateSkill(random, state);
  }
  DecoratePlan(random, plan);
  return plan;
}

Plan RandomPlan(std::mt19937& random, int max_states) {
  for (;;) {
    Plan plan = AnyPlan(random, max_states);
    if (recipes::CheckPlan(plan).empty()) return plan;
  }
}

}  // namespace lares::testing
