#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "base/file.h"
#include "recipes/plan/diff.h"
#include "recipes/plan/export.h"
#include "tests/recipes/json_schema.h"
#include "tests/recipes/random_plan.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Difference;
using recipes::DiffPlans;
using recipes::Plan;
using recipes::State;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Kind = Difference::Kind;

class PlanDiffs : public ::testing::Test {
 protected:
  PlanDiffs() {
    std::mt19937 random(1);
    plan_ = RandomPlan(random, 5);
    plan_.states[0].outcomes = {"succeeded", "failed"};
    changed_ = plan_;
  }
  Difference TheOnly() const {
    const auto diff = DiffPlans(plan_, changed_);
    EXPECT_EQ(diff.differences.size(), 1u) << recipes::ToText(diff);
    return diff.differences.empty() ? Difference{} : diff.differences.front();
  }
  State& First() { return changed_.states[0]; }

  Plan plan_;
  Plan changed_;
};

TEST_F(PlanDiffs, EqualPlansHaveNone) {
  std::mt19937 random(17);
  for (int i = 0; i < 100; ++i) {
    const Plan plan = RandomFullPlan(random, 6);
    EXPECT_THAT(DiffPlans(plan, plan).differences, IsEmpty());
  }
  EXPECT_THAT(recipes::ToText(DiffPlans(plan_, plan_)), HasSubstr("The plans are equal."));
}

TEST_F(PlanDiffs, DifferentPlansHaveSomeAndTheOtherWayRoundAsMany) {
  std::mt19937 random(18);
  int different = 0;
  for (int i = 0; i < 200; ++i) {
    const Plan a = RandomFullPlan(random, 6);
    const Plan b = RandomFullPlan(random, 6);
    const bool equal = recipes::ToJson(a) == recipes::ToJson(b);
    const auto there = DiffPlans(a, b);
    const auto back = DiffPlans(b, a);
    EXPECT_EQ(there.differences.empty(), equal);
    EXPECT_EQ(there.differences.size(), back.differences.size());
    different += !equal;
  }
  EXPECT_GT(different, 150);
}

TEST_F(PlanDiffs, AnythingThatIsChangedIsOne) {
  std::mt19937 random(19);
  const std::vector<std::function<void(Plan&)>> changes = {
      [](Plan& plan) { plan.robot.iri += "x"; },
      [](Plan& plan) { plan.task.label += "x"; },
      [](Plan& plan) { plan.environment += "x"; },
      [](Plan& plan) { plan.start = plan.states.back().id; },
      [](Plan& plan) { plan.states[0].label += "x"; },
      [](Plan& plan) { plan.states[0].id += "x"; },
      [](Plan& plan) { plan.states.back().success = !plan.states.back().success; },
      [](Plan& plan) { plan.states[0].outcomes.emplace_back("other"); },
      [](Plan& plan) { plan.transitions[0].to += "x"; },
      [](Plan& plan) { plan.transitions[0].added = !plan.transitions[0].added; },
      [](Plan& plan) { plan.transitions.pop_back(); },
      [](Plan& plan) { plan.notes.emplace_back("new"); },
      [](Plan& plan) { plan.done.emplace_back("new"); },
      [](Plan& plan) { plan.given.emplace_back("new"); },
      [](Plan& plan) {
        plan.unordered.push_back({"a", "new"});
      },
      [](Plan& plan) {
        plan.assumptions.push_back({"new", "", true});
      },
      [](Plan& plan) {
        plan.settings.push_back({"new", "class", "", "v", "", true, ""});
      },
      [](Plan& plan) { plan.match.needs.pop_back(); },
      [](Plan& plan) { plan.match.capabilities[0].explanation += "x"; },
      [](Plan& plan) { plan.match.capabilities[0].dependencies.clear(); },
      [](Plan& plan) {
        plan.match.downloads.push_back({{"urn:x", "x", "urn:x"}, {}});
      },
      [](Plan& plan) {
        plan.match.requirements.push_back({{}, plan.match.capabilities[0]});
      },
      [](Plan& plan) { plan.match.capabilities[0].dependencies[0].measures.emplace_back(); }};
  for (std::size_t change = 0; change < changes.size(); ++change) {
    const Plan plan = RandomFullPlan(random, 6);
    Plan other = plan;
    changes[change](other);
    EXPECT_FALSE(DiffPlans(plan, other).differences.empty()) << change;
  }
}

TEST_F(PlanDiffs, AParameterIsToldWithWhereItComesFrom) {
  recipes::Parameter& input = First().inputs[0];
  input.value = "0 0 1 0 0 0 1";
  input.type = "pose";
  input.frame = "base_footprint";
  input.source = recipes::Parameter::Source::kRobot;
  input.origin = {"https://example.org/r#camera_link", "camera_link",
                  "https://example.org/r#camera_link"};
  const Difference found = TheOnly();
  EXPECT_EQ(found.kind, Kind::kParameter);
  EXPECT_EQ(found.step, "step-0");
  EXPECT_EQ(found.name, "thing");
  EXPECT_EQ(found.a.why, "recipe");
  EXPECT_EQ(found.b.value, "0 0 1 0 0 0 1");
  EXPECT_EQ(found.b.why, "robot: camera_link on base_footprint");
}

TEST_F(PlanDiffs, AnotherTemplateIsToldWithItsDistance) {
  First().skill_template = "https://example.org/other";
  First().skill = "Other";
  First().rada_distance = 2;
  const auto diff = DiffPlans(plan_, changed_);
  ASSERT_EQ(diff.differences.size(), 2u);
  EXPECT_EQ(diff.differences[0].kind, Kind::kSkill);
  EXPECT_EQ(diff.differences[0].a.why, "a template for Action, the step's own action");
  EXPECT_EQ(diff.differences[0].b.why, "a template for Action, 2 edges above the step");
  EXPECT_EQ(diff.differences[1].kind, Kind::kTemplate);
}

TEST_F(PlanDiffs, RetriesAndLimitsAreTold) {
  First().retries = 2;
  First().time_limit_s = 1.5;
  const auto diff = DiffPlans(plan_, changed_);
  ASSERT_EQ(diff.differences.size(), 2u);
  EXPECT_EQ(diff.differences[0].a.value, "none");
  EXPECT_EQ(diff.differences[0].b.value, "2");
  EXPECT_EQ(diff.differences[1].b.value, "1.5 s");
}

TEST_F(PlanDiffs, AStepOfAnotherNameIsTheSameWhenItIsTheOnlyOneOfItsClass) {
  const std::string old = First().id;
  First().id = "renamed";
  if (changed_.start == old) changed_.start = "renamed";
  for (auto& transition : changed_.transitions) {
    if (transition.from == old) transition.from = "renamed";
    if (transition.to == old) transition.to = "renamed";
  }
  const Difference found = TheOnly();
  EXPECT_EQ(found.kind, Kind::kStep);
  EXPECT_THAT(found.b.value, HasSubstr("renamed"));
}

TEST_F(PlanDiffs, AStepThatIsInOnePlanOnlyIsToldAsThat) {
  State more = First();
  more.id = "more";
  more.step.iri += "more";
  changed_.states.push_back(more);
  const Difference found = TheOnly();
  EXPECT_EQ(found.kind, Kind::kStep);
  EXPECT_EQ(found.step, "more");
  EXPECT_EQ(found.a.value, "");
  EXPECT_EQ(found.b.value, more.skill);
}

TEST_F(PlanDiffs, TheJsonFollowsItsSchemaAndTheTextNamesBothSides) {
  const auto schema = nlohmann::json::parse(ReadFile(Source("docs/schemas/plan-diff.schema.json")));
  std::mt19937 random(29);
  for (int i = 0; i < 50; ++i) {
    const auto diff = DiffPlans(RandomFullPlan(random, 6), RandomFullPlan(random, 6));
    ASSERT_THAT(ValidateJson(schema, recipes::ToJson(diff)), IsEmpty());
  }
  First().retries = 1;
  EXPECT_THAT(recipes::ToText(DiffPlans(plan_, changed_)),
              HasSubstr("Step step-0\n  retries  a none\n           b 1\n"));
}

}  // namespace
}  // namespace lares::testing
