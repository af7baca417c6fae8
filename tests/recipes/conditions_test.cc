// What must be so before skills run: read, bound, and followed through plans.
#include "recipes/plan/conditions.h"

#include <gmock/gmock.h>

namespace lares::recipes {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

State Skill(const std::string& id, std::vector<Fluent> needs, std::vector<Effect> effects,
            std::vector<std::string> outcomes = {"succeeded", "failed"}) {
  State state;
  state.id = id;
  state.skill = "DoIt";
  state.outcomes = std::move(outcomes);
  state.preconditions = std::move(needs);
  state.effects = std::move(effects);
  return state;
}

State End(const std::string& id, bool success) {
  State state;
  state.id = id;
  state.kind = State::Kind::kEnd;
  state.success = success;
  return state;
}

// The skills one after the other; failures end the plan.
Plan Row(std::vector<State> skills) {
  Plan plan;
  plan.start = skills.front().id;
  for (std::size_t i = 0; i < skills.size(); ++i) {
    const std::string next = i + 1 < skills.size() ? skills[i + 1].id : "done";
    plan.transitions.push_back({skills[i].id, "succeeded", next});
    plan.transitions.push_back({skills[i].id, "failed", "failed"});
  }
  plan.states = std::move(skills);
  plan.states.push_back(End("done", true));
  plan.states.push_back(End("failed", false));
  return plan;
}

const Fluent kRuns{"vision_running", "", true};
const Fluent kStopped{"vision_running", "", false};

TEST(Fluent, IsReadWithItsArgumentAndNegation) {
  EXPECT_EQ(ParseFluent("vision_running"), kRuns);
  EXPECT_EQ(ParseFluent(" not vision_running "), kStopped);
  EXPECT_EQ(ParseFluent("holding( object )"), (Fluent{"holding", "object", true}));
  EXPECT_EQ(ParseFluent("not at(*)"), (Fluent{"at", "*", false}));
}

TEST(Fluent, OtherTextIsNone) {
  for (const char* text : {"", "not ", "a b", "at(", "at)", "at(a b)", "at(a)(b)", "1st", "at(**)",
                           "at(object))", "nöt"}) {
    EXPECT_EQ(ParseFluent(text), std::nullopt) << text;
  }
}

TEST(Fluent, TakesTheValueThatItsInputHas) {
  State state = Skill("take", {}, {});
  state.inputs.push_back(
      {"object", "designator", "", "https://example.org/x#cup1", "", "", {}, {}});
  state.outputs["pose"] = "cup_pose";
  EXPECT_EQ(Ground({"holding", "object", true}, state).argument, "https://example.org/x#cup1");
  EXPECT_EQ(Ground({"at", "pose", true}, state).argument, "{cup_pose}");
  EXPECT_EQ(Ground({"at", "nothing", true}, state).argument, "");
  EXPECT_EQ(ToText(Ground({"holding", "object", false}, state)), "not holding(cup1)");
}

TEST(Simulation, WhatNothingSaysIsAssumedAtTheStart) {
  const Simulation simulation =
      Simulate(Row({Skill("look", {kRuns}, {}), Skill("look-again", {kRuns}, {})}));
  EXPECT_THAT(simulation.problems, IsEmpty());
  EXPECT_THAT(simulation.assumptions, ElementsAre(kRuns));
}

TEST(Simulation, WhatAStepBringsAboutNeedsNoAssumption) {
  const Simulation simulation =
      Simulate(Row({Skill("start", {}, {{"succeeded", kRuns}}), Skill("look", {kRuns}, {})}));
  EXPECT_THAT(simulation.problems, IsEmpty());
  EXPECT_THAT(simulation.assumptions, IsEmpty());
}

TEST(Simulation, AStepWhoseNeedWasUndoneIsNamedWithTheWay) {
  const Simulation simulation =
      Simulate(Row({Skill("stop", {}, {{"succeeded", kStopped}}), Skill("look", {kRuns}, {})}));
  EXPECT_THAT(simulation.problems, ElementsAre(AllOf(HasSubstr("'look' needs vision_running"),
                                                     HasSubstr("on the way stop → look"))));
}

TEST(Simulation, AnEffectCountsForItsOutcomeOnly) {
  Plan plan = Row({Skill("stop", {}, {{"failed", kStopped}}), Skill("look", {kRuns}, {})});
  EXPECT_THAT(Simulate(plan).problems, IsEmpty());
  plan.transitions[1].to = "look";  // on failed
  EXPECT_THAT(Simulate(plan).problems, ElementsAre(HasSubstr("'look' needs vision_running")));
}

TEST(Simulation, OneWayOfSeveralIsEnoughForAProblem) {
  Plan plan = Row({Skill("check", {}, {}, {"succeeded", "true", "failed"}),
                   Skill("stop", {}, {{"succeeded", kStopped}}), Skill("look", {kRuns}, {})});
  plan.transitions.push_back({"check", "true", "look"});
  const Simulation simulation = Simulate(plan);
  ASSERT_THAT(simulation.problems, ::testing::SizeIs(1));
  EXPECT_THAT(simulation.problems[0], HasSubstr("check → stop → look"));
}

TEST(Simulation, ALoopComesToAnEnd) {
  Plan plan = Row({Skill("go", {}, {{"succeeded", {"at", "a", true}}}),
                   Skill("look", {{"at", "a", true}}, {{"succeeded", {"at", "*", false}}})});
  plan.transitions[2].to = "go";
  plan.transitions.push_back({"look", "failed", "done"});
  EXPECT_THAT(Simulate(plan).problems, IsEmpty());
}

TEST(Simulation, EndingForAnyArgumentEndsEach) {
  const Fluent at_a{"at", "a", true};
  const auto simulate = [&](const Fluent& moved) {
    return Simulate(Row({Skill("go", {}, {{"succeeded", at_a}}),
                         Skill("away", {}, {{"succeeded", moved}}), Skill("look", {at_a}, {})}))
        .problems.size();
  };
  EXPECT_EQ(simulate({"at", "*", false}), 1u);
  EXPECT_EQ(simulate({"at", "b", false}), 0u);
}

TEST(Simulation, OppositeNeedsAtTheStartAreAProblem) {
  Plan plan = Row({Skill("check", {}, {}, {"succeeded", "true", "failed"}),
                   Skill("look", {kRuns}, {}), Skill("rest", {}, {})});
  plan.states.insert(plan.states.begin(), Skill("tidy", {kStopped}, {}));
  plan.transitions.push_back({"check", "true", "tidy"});
  plan.transitions.push_back({"tidy", "succeeded", "done"});
  plan.transitions.push_back({"tidy", "failed", "failed"});
  EXPECT_THAT(Simulate(plan).problems,
              ElementsAre(HasSubstr("another step needs at the start that it is not so")));
}

TEST(Simulation, WhatEarlierStepsBroughtAboutMustNotContradictTheStart) {
  const Plan plan = Row({Skill("look", {kRuns}, {})});
  EXPECT_THAT(Simulate(plan, {kRuns}).problems, IsEmpty());
  EXPECT_THAT(Simulate(plan, {kRuns}).assumptions, ElementsAre(kRuns));
  EXPECT_THAT(Simulate(plan, {kStopped}).problems, ElementsAre(HasSubstr("'look'")));
  EXPECT_THAT(Simulate(plan, {kStopped, kRuns}).problems, IsEmpty()) << "the later one counts";
}

TEST(Simulation, AnyArgumentIsNotNone) {
  const Fluent plain{"holding", "", true};
  const Fluent none_of_all{"holding", "*", false};
  EXPECT_FALSE(Touches(plain, none_of_all));
  EXPECT_THAT(
      Simulate(Row({Skill("drop", {}, {{"succeeded", none_of_all}}), Skill("use", {plain}, {})}))
          .problems,
      IsEmpty());
}

TEST(Simulation, StepsSideBySideNeedAndBringAboutTogether) {
  Plan plan = Row({Skill("before", {}, {}), Skill("after", {kRuns, {"open", "", true}}, {})});
  State both;
  both.id = "both";
  both.kind = State::Kind::kParallel;
  both.outcomes = {"succeeded", "failed"};
  both.members = {"start", "open"};
  plan.states.push_back(both);
  plan.states.push_back(Skill("start", {}, {{"succeeded", kRuns}}));
  plan.states.push_back(Skill("open", {}, {{"succeeded", {"open", "", true}}}));
  plan.transitions[0].to = "both";
  plan.transitions.push_back({"both", "succeeded", "after"});
  plan.transitions.push_back({"both", "failed", "after"});
  const Simulation simulation = Simulate(plan);
  EXPECT_THAT(simulation.problems, IsEmpty());
  EXPECT_THAT(simulation.assumptions, IsEmpty());  // after a failure it may be so or not
}

TEST(Simulation, TooManySituationsAreToldAndNotFollowed) {
  // Each of 20 checks may or may not bring something about.
  std::vector<State> skills;
  for (int i = 0; i < 20; ++i) {
    skills.push_back(Skill("s" + std::to_string(i), {},
                           {{"true", {"f" + std::to_string(i), "", true}}},
                           {"succeeded", "true", "failed"}));
  }
  Plan plan = Row(skills);
  for (int i = 0; i < 20; ++i) {
    plan.transitions.push_back(
        {"s" + std::to_string(i), "true", i < 19 ? "s" + std::to_string(i + 1) : "done"});
  }
  EXPECT_FALSE(Simulate(plan).complete);
}

}  // namespace
}  // namespace lares::recipes
