// The exported problem says what the plan's graph says.
#include <gmock/gmock.h>

#include <deque>
#include <random>

#include "base/text.h"
#include "recipes/plan/export.h"
#include "recipes/plan/pddl_names.h"
#include "recipes/plan/shape.h"
#include "tests/recipes/pddl_planner.h"
#include "tests/recipes/random_plan.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Effect;
using recipes::Fluent;
using recipes::Plan;
using recipes::State;
using ::testing::HasSubstr;
using ::testing::Not;

using Facts = std::set<std::pair<std::string, std::string>>;

bool Holds(const Facts& facts, const Fluent& fluent) {
  return facts.count({fluent.name, fluent.argument}) > 0;
}

void Apply(const Fluent& fluent, Facts& facts) {
  if (fluent.argument == "*") {
    std::erase_if(
        facts, [&](const auto& fact) { return fact.first == fluent.name && !fact.second.empty(); });
  } else if (fluent.holds) {
    facts.insert({fluent.name, fluent.argument});
  } else {
    facts.erase({fluent.name, fluent.argument});
  }
}

bool CanStart(const State& state, const Facts& facts) {
  for (const Fluent& fluent : state.preconditions) {
    if (fluent.argument != "*") {
      if (Holds(facts, fluent) != fluent.holds) return false;
      continue;
    }
    for (const auto& [name, argument] : facts) {
      if (name == fluent.name && !argument.empty()) return false;
    }
  }
  return true;
}

std::vector<const State*> RunningIn(const Plan& plan, const State& state) {
  if (state.kind != State::Kind::kParallel) return {&state};
  std::vector<const State*> running;
  for (const std::string& id : state.members) running.push_back(recipes::FindState(plan, id));
  return running;
}

void Finish(const std::vector<const State*>& ending, const std::string& outcome, Facts& facts) {
  // All effects of the state at once: the last word on a fact counts.
  for (const State* state : ending) {
    for (const Effect& effect : state->effects) {
      if (effect.outcome == outcome) Apply(effect.fluent, facts);
    }
  }
}

// The length of a shortest way through the graph on which everything that is needed is so.
std::optional<std::size_t> ShortestWay(const Plan& plan) {
  using Situation = std::pair<std::string, Facts>;
  const recipes::Ways ways = recipes::WaysOf(plan);
  Situation first{plan.start, {}};
  for (const Fluent& fluent : plan.assumptions) Apply(fluent, first.second);
  std::map<Situation, std::size_t> lengths{{first, 0}};
  std::deque<Situation> open{first};
  while (!open.empty()) {
    const auto [id, facts] = open.front();
    open.pop_front();
    const State& state = *recipes::FindState(plan, id);
    const std::size_t length = lengths.at({id, facts});
    if (state.success) return length;
    if (state.kind == State::Kind::kEnd) continue;
    const auto running = RunningIn(plan, state);
    bool can_start = true;
    for (const State* each : running) can_start = can_start && CanStart(*each, facts);
    if (!can_start) continue;
    const auto reach = [&](const std::string& outcome, const std::string& to,
                           const std::vector<const State*>& ending) {
      Facts next = facts;
      Finish(ending, outcome, next);
      if (lengths.emplace(Situation{to, next}, length + 1).second) open.push_back({to, next});
    };
    for (const auto& [outcome, to] : ways.at(id)) {
      if (state.kind == State::Kind::kParallel && outcome == "failed") {
        for (const State* each : running) reach(outcome, to, {each});
      } else {
        reach(outcome, to, running);
      }
    }
  }
  return std::nullopt;
}

// Follows "state__outcome" from the start; where it ends.
const State* Follow(const Plan& plan, const std::vector<std::string>& actions) {
  const recipes::Ways ways = recipes::WaysOf(plan);
  std::string id = plan.start;
  for (const std::string& action : actions) {
    const std::size_t mark = action.find("__");
    EXPECT_EQ(action.substr(0, mark), ToLower(id));
    std::string outcome = action.substr(mark + 2);
    outcome = outcome.substr(0, outcome.find("__"));
    id = ways.at(id).at(outcome);
  }
  return recipes::FindState(plan, id);
}

std::optional<std::vector<std::string>> PlanOf(const Plan& plan) {
  return FindPddlPlan(ReadPddl(recipes::ToPddlDomain(plan), recipes::ToPddlProblem(plan)));
}

TEST(PddlExport, HasAPlanExactlyWhenTheGraphHasAWayAndItIsOne) {
  std::mt19937 random(31);
  int found = 0, none = 0, parallels = 0;
  for (int i = 0; i < 400; ++i) {
    const Plan plan = RandomFullPlan(random, 7);
    const auto actions = PlanOf(plan);
    const auto length = ShortestWay(plan);
    ASSERT_EQ(actions.has_value(), length.has_value())
        << recipes::ToPddlDomain(plan) << recipes::ToPddlProblem(plan);
    none += !actions;
    if (!actions) continue;
    ++found;
    EXPECT_EQ(actions->size(), *length);
    const State* end = Follow(plan, *actions);
    ASSERT_NE(end, nullptr);
    EXPECT_TRUE(end->success);
    for (const std::string& action : *actions) {
      const State* from = recipes::FindState(plan, action.substr(0, action.find("__")));
      parallels += from != nullptr && from->kind == State::Kind::kParallel;
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 20);
  EXPECT_GT(parallels, 20);
}

TEST(PddlExport, ThePlansOfTheLibraryCanSucceed) {
  for (const auto& [recipe, task, robot] : {std::tuple("object-search", "ObjectSearch", "scout"),
                                            std::tuple("fetch-drink", "FetchDrink", "helper")}) {
    World world = Catalogue();
    world.PutFile("robot", Source(std::string("robots/models/") + robot + ".ttl"))
        .PutFile("recipe", Source(std::string("recipes/library/") + recipe + ".ttl"));
    recipes::PlanOptions options;
    if (std::string(task) == "ObjectSearch") options.set["object"] = "Cup";
    const auto result = recipes::MakePlan(
        Engines(), world.view(),
        std::string("https://w3id.org/lares/recipes/") + recipe + "#" + task,
        std::string("https://w3id.org/lares/robots/") + robot + "#" + robot + "1", options);
    ASSERT_TRUE(result.plan) << task;
    const auto actions = PlanOf(*result.plan);
    ASSERT_TRUE(actions) << task;
    EXPECT_TRUE(Follow(*result.plan, *actions)->success);
  }
}

TEST(PddlExport, WithoutAWayToSuccessThereIsNoPlan) {
  std::mt19937 random(3);
  Plan plan = RandomFullPlan(random, 5);
  for (State& state : plan.states) state.success = false;
  EXPECT_FALSE(PlanOf(plan));
}

TEST(PddlExport, WhatIsHeldMustHaveBeenGrasped) {
  Plan plan;
  State grasp;
  grasp.id = "grasp";
  grasp.outcomes = {"succeeded", "failed"};
  grasp.preconditions = {{"holding", "*", false}};
  grasp.effects = {{"succeeded", {"holding", "https://example.org/#Cup", true}}};
  State place = grasp;
  place.id = "place";
  place.preconditions = {{"holding", "https://example.org/#Cup", true}};
  place.effects = {{"succeeded", {"holding", "*", false}}};
  State done;
  done.id = "done";
  done.kind = State::Kind::kEnd;
  done.success = true;
  plan.states = {grasp, place, done};
  plan.start = "grasp";
  plan.transitions = {{"grasp", "succeeded", "place", false, ""},
                      {"grasp", "failed", "place", false, ""},
                      {"place", "succeeded", "done", false, ""},
                      {"place", "failed", "grasp", false, ""}};
  EXPECT_EQ(PlanOf(plan), (std::vector<std::string>{"grasp__succeeded", "place__succeeded"}));
  plan.assumptions = {{"holding", "https://example.org/#Pot", true}};
  EXPECT_FALSE(PlanOf(plan)) << "the hand is full";
}

TEST(PddlNames, AreLegalAndDifferent) {
  recipes::PddlNames names;
  EXPECT_EQ(names.Of("1", "Kitchen"), "kitchen");
  EXPECT_EQ(names.Of("2", "kitchen"), "kitchen-2");
  EXPECT_EQ(names.Of("3", "KITCHEN"), "kitchen-3");
  EXPECT_EQ(names.Of("1", "kitchen"), "kitchen");
  EXPECT_EQ(recipes::PddlName("3 cups; (red)"), "x3_cups___red_");
  EXPECT_EQ(recipes::PddlName("And"), "and_");
  EXPECT_EQ(recipes::PddlName(""), "x");
  EXPECT_EQ(recipes::PddlName("Küche"), "k__che");
}

}  // namespace
}  // namespace lares::testing
