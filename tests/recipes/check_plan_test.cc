#include <gmock/gmock.h>

#include "recipes/plan/plan.h"

namespace lares::recipes {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

State Skill(const std::string& id, std::vector<std::string> outcomes) {
  State state;
  state.id = id;
  state.skill = "DoIt";
  state.outcomes = std::move(outcomes);
  return state;
}

State End(const std::string& id, bool success = true) {
  State state;
  state.id = id;
  state.kind = State::Kind::kEnd;
  state.success = success;
  return state;
}

// a -succeeded-> b -true-> done, b -false-> a.
Plan Loop() {
  Plan plan;
  plan.start = "a";
  plan.states = {Skill("a", {"succeeded"}), Skill("b", {"true", "false"}), End("done")};
  plan.transitions = {{"a", "succeeded", "b"}, {"b", "true", "done"}, {"b", "false", "a"}};
  return plan;
}

Parameter Input(const std::string& name, const std::string& value, Parameter::Source source) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = "string";
  parameter.value = value;
  parameter.source = source;
  return parameter;
}

TEST(CheckPlan, AcceptsALoopWithAnExit) { EXPECT_THAT(CheckPlan(Loop()), IsEmpty()); }

TEST(CheckPlan, NamesAStateThatCannotBeReached) {
  Plan plan = Loop();
  plan.states.push_back(End("island"));
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("'island' cannot be reached")));
}

TEST(CheckPlan, NamesEachStateFromWhichNoEndCanBeReached) {
  Plan plan = Loop();
  plan.transitions[1].to = "a";
  const auto violations = CheckPlan(plan);
  EXPECT_THAT(violations, Contains(HasSubstr("no end can be reached from 'a'")));
  EXPECT_THAT(violations, Contains(HasSubstr("no end can be reached from 'b'")));
}

TEST(CheckPlan, NamesAnOutcomeThatLeadsNowhereOrTwice) {
  Plan plan = Loop();
  plan.transitions.push_back({"b", "true", "a"});
  plan.states[0].outcomes.push_back("failed");
  EXPECT_THAT(CheckPlan(plan),
              ElementsAre(HasSubstr("outcome 'failed' of 'a' leads nowhere"),
                          HasSubstr("outcome 'true' of 'b' leads to several states")));
}

TEST(CheckPlan, NamesTransitionsToAndFromNowhere) {
  Plan plan = Loop();
  plan.transitions.push_back({"ghost", "succeeded", "a"});
  plan.transitions[2].to = "limbo";
  const auto violations = CheckPlan(plan);
  EXPECT_THAT(violations, Contains(HasSubstr("comes from 'ghost'")));
  EXPECT_THAT(violations, Contains(HasSubstr("leads to 'limbo'")));
}

TEST(CheckPlan, NamesIdsThatAreTwiceThereOrMalformed) {
  Plan plan = Loop();
  plan.states.push_back(End("done"));
  plan.states[0].id = "not an id";
  const auto violations = CheckPlan(plan);
  EXPECT_THAT(violations, Contains(HasSubstr("two states have the id 'done'")));
  EXPECT_THAT(violations, Contains(HasSubstr("'not an id' is malformed")));
}

TEST(CheckPlan, NamesAMissingStart) {
  Plan plan = Loop();
  plan.start = "nowhere";
  EXPECT_THAT(CheckPlan(plan), Contains(HasSubstr("the start 'nowhere' is no state")));
}

TEST(CheckPlan, NamesParametersThatAreNotBound) {
  Plan plan = Loop();
  plan.states[0].inputs = {Input("target", "", Parameter::Source::kRecipe),
                           Input("name", "x", Parameter::Source::kRecipe),
                           Input("odd", "{key}", Parameter::Source::kRecipe)};
  EXPECT_THAT(CheckPlan(plan),
              UnorderedElementsAre(HasSubstr("'name' of 'a' has a name that"),
                                   HasSubstr("'odd' of 'a' has a value written like a key"),
                                   HasSubstr("'target' of 'a' is not bound")));
}

TEST(CheckPlan, NamesUnknownTypesAndOutputsThatNoTreeCanHold) {
  Plan plan = Loop();
  plan.states[0].inputs = {Input("target", "x", Parameter::Source::kRecipe)};
  plan.states[0].inputs[0].type = "banana";
  plan.states[0].outputs = {{"pose", "not a key"}};
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("its key 'not a key' is no identifier"),
                                           HasSubstr("has the unknown type 'banana'")));
}

TEST(CheckPlan, AFailureThatWasAddedIsNoWayToEnd) {
  Plan plan = Loop();
  plan.states[0].outcomes.push_back("failed");
  plan.states.push_back(End("failed", false));
  plan.transitions.push_back({"a", "failed", "failed", true, "so that it leads on"});
  EXPECT_THAT(CheckPlan(plan), IsEmpty());
  plan.transitions[1].to = "a";
  plan.states.erase(plan.states.begin() + 2);
  EXPECT_THAT(CheckPlan(plan),
              UnorderedElementsAre(HasSubstr("no end can be reached from 'a' unless a step fails"),
                                   HasSubstr("no end can be reached from 'b' unless a step fails"),
                                   HasSubstr("no end that is a success")));
}

TEST(CheckPlan, WantsASuccessThatCanBeReachedFromTheStart) {
  Plan plan = Loop();
  plan.states[2].success = false;
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("no end that is a success")));
  plan.states[2].id = plan.transitions[1].to = "exhausted";
  EXPECT_THAT(CheckPlan(plan), IsEmpty()) << "everything was gone through";
}

TEST(CheckPlan, WantsAKeyToBeCreatedOnEveryPath) {
  Plan plan = Loop();
  plan.states[0].inputs = {Input("pose", "{next}", Parameter::Source::kStep)};
  EXPECT_THAT(CheckPlan(plan),
              ElementsAre(HasSubstr("uses 'next', which no step creates on the way a")));
  plan.states[1].outputs = {{"pose", "next"}};
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("on the way a")))
      << "b comes before a only from the second round on";
  plan.start = "b";
  EXPECT_THAT(CheckPlan(plan), IsEmpty());
}

TEST(CheckPlan, NamesThePathOnWhichAKeyIsNotCreated) {
  Plan plan;
  plan.start = "a";
  plan.states = {Skill("a", {"true", "false"}), Skill("make", {"succeeded"}),
                 Skill("use", {"succeeded"}), End("done")};
  plan.states[1].outputs = {{"pose", "next"}};
  plan.states[2].inputs = {Input("pose", "{next}", Parameter::Source::kStep)};
  plan.transitions = {{"a", "true", "make"},
                      {"a", "false", "make"},
                      {"make", "succeeded", "use"},
                      {"use", "succeeded", "done"}};
  EXPECT_THAT(CheckPlan(plan), IsEmpty());
  plan.transitions[1].to = "use";
  EXPECT_THAT(CheckPlan(plan),
              ElementsAre("parameter 'pose' of 'use' uses 'next', which no step creates on the way "
                          "a → use"));
}

TEST(CheckPlan, AStepThatFailedHasCreatedNothing) {
  Plan plan;
  plan.start = "make";
  plan.states = {Skill("make", {"succeeded", "failed"}), Skill("use", {"succeeded"}), End("done")};
  plan.states[0].outputs = {{"pose", "next"}};
  plan.states[1].inputs = {Input("pose", "{next}", Parameter::Source::kStep)};
  plan.transitions = {
      {"make", "succeeded", "use"}, {"make", "failed", "use"}, {"use", "succeeded", "done"}};
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("on the way make → use")));
  plan.transitions[1].to = "make";
  EXPECT_THAT(CheckPlan(plan), IsEmpty());
}

}  // namespace
}  // namespace lares::recipes
