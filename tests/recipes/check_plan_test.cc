#include <gmock/gmock.h>

#include "recipes/plan/plan.h"

namespace lares::recipes {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

State Skill(const std::string& id, std::vector<std::string> outcomes) {
  State state;
  state.id = id;
  state.skill = "DoIt";
  state.outcomes = std::move(outcomes);
  return state;
}

State End(const std::string& id) {
  State state;
  state.id = id;
  state.kind = State::Kind::kEnd;
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
  EXPECT_THAT(CheckPlan(plan), ::testing::UnorderedElementsAre(
                                   HasSubstr("'name' of 'a' has a name that"),
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

TEST(CheckPlan, WantsAKeyToBeCreatedByAnEarlierStep) {
  Plan plan = Loop();
  plan.states[0].inputs = {Input("pose", "{next}", Parameter::Source::kStep)};
  EXPECT_THAT(CheckPlan(plan), ElementsAre(HasSubstr("uses 'next', which no step before it")));
  plan.states[1].outputs = {{"pose", "next"}};  // b comes before a, round the loop
  EXPECT_THAT(CheckPlan(plan), IsEmpty());
}

}  // namespace
}  // namespace lares::recipes
