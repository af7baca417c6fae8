#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "base/file.h"
#include "recipes/plan/export.h"
#include "recipes/plan/shape.h"
#include "tests/recipes/behavior_tree.h"
#include "tests/recipes/json_schema.h"
#include "tests/recipes/random_plan.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Plan;
using recipes::State;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

nlohmann::json Schema() {
  return nlohmann::json::parse(ReadFile(Source("docs/schemas/plan.schema.json")));
}

recipes::PlanResult LibraryPlan(const std::string& recipe, const std::string& task,
                                const std::string& robot,
                                const recipes::PlanOptions& options = {}) {
  World world = Catalogue();
  world.PutFile("robot", Source("robots/models/" + robot + ".ttl"))
      .PutFile("recipe", Source("recipes/library/" + recipe + ".ttl"));
  return recipes::MakePlan(Engines(), world.view(),
                           "https://w3id.org/lares/recipes/" + recipe + "#" + task,
                           "https://w3id.org/lares/robots/" + robot + "#" + robot + "1", options);
}
recipes::PlanOptions ForACup() {
  recipes::PlanOptions options;
  options.set["object"] = "Cup";
  return options;
}
Plan SearchPlan() { return *LibraryPlan("object-search", "ObjectSearch", "scout", ForACup()).plan; }
Plan FetchPlan() { return *LibraryPlan("fetch-drink", "FetchDrink", "helper").plan; }

// What the plan's graph does when the n-th skill run ends in its outcome number `choices[n]`.
struct Trace {
  std::vector<std::string> states;
  bool ended = false;
  bool success = false;
  friend bool operator==(const Trace&, const Trace&) = default;
};

std::string Outcome(const State& state, int choice) {
  return state.outcomes[static_cast<std::size_t>(choice) % state.outcomes.size()];
}

Trace RunGraph(const Plan& plan, const std::vector<int>& choices) {
  const recipes::Ways ways = recipes::WaysOf(plan);
  Trace trace;
  const State* state = recipes::FindState(plan, plan.start);
  for (const int choice : choices) {
    if (state->kind == State::Kind::kEnd) break;
    trace.states.push_back(state->id);
    state = recipes::FindState(plan, ways.at(state->id).at(Outcome(*state, choice)));
  }
  trace.ended = state->kind == State::Kind::kEnd;
  trace.success = trace.ended && state->success;
  return trace;
}

struct OutOfChoices {};

Trace RunTree(const Plan& plan, const std::vector<int>& choices) {
  Trace trace;
  BehaviorTree tree(recipes::ToBehaviorTreeXml(plan), [&](const std::string& id) {
    if (trace.states.size() == choices.size()) throw OutOfChoices{};
    trace.states.push_back(id);
    return Outcome(*recipes::FindState(plan, id), choices[trace.states.size() - 1]);
  });
  try {
    trace.success = tree.RunToEnd(10'000) == TickStatus::kSuccess;
    trace.ended = true;
  } catch (const OutOfChoices&) {
  }
  return trace;
}

std::vector<int> RandomChoices(std::mt19937& random) {
  std::vector<int> choices(20);
  for (int& choice : choices) choice = std::uniform_int_distribution<int>(0, 5)(random);
  return choices;
}

TEST(BehaviorTreeExport, HasTheTracesOfThePlansGraph) {
  std::mt19937 random(7);
  int ended = 0, loops = 0;
  for (int i = 0; i < 300; ++i) {
    const Plan plan = RandomPlan(random, 8);
    loops += recipes::LinearSteps(plan).empty();
    for (int run = 0; run < 5; ++run) {
      const std::vector<int> choices = RandomChoices(random);
      const Trace expected = RunGraph(plan, choices);
      ended += expected.ended;
      ASSERT_EQ(RunTree(plan, choices).states, expected.states) << recipes::ToBehaviorTreeXml(plan);
      ASSERT_EQ(RunTree(plan, choices), expected) << recipes::ToBehaviorTreeXml(plan);
    }
  }
  EXPECT_GT(ended, 500);
  EXPECT_GT(loops, 100);
}

TEST(BehaviorTreeExport, APlainRowIsAPlainSequence) {
  const Plan plan = FetchPlan();
  const std::string xml = recipes::ToBehaviorTreeXml(plan);
  EXPECT_THAT(xml, Not(HasSubstr("Script")));
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const std::vector<int> choices = RandomChoices(random);
    ASSERT_EQ(RunTree(plan, choices), RunGraph(plan, choices));
  }
  const std::vector<int> all_well(20, 0);
  EXPECT_TRUE(RunTree(plan, all_well).success);
  EXPECT_EQ(RunTree(plan, all_well).states.size(), 7u);
}

TEST(BehaviorTreeExport, ModelsListEverySkillOnceWithItsPorts) {
  const XmlElement root = ParseXml(recipes::ToBehaviorTreeXml(FetchPlan()));
  EXPECT_EQ(root.attributes.at("BTCPP_format"), "4");
  const XmlElement& models = root.children.back();
  ASSERT_EQ(models.name, "TreeNodesModel");
  std::vector<std::string> ids;
  for (const XmlElement& model : models.children) {
    EXPECT_EQ(model.name, "Action");
    ids.push_back(model.attributes.at("ID"));
    std::vector<std::string> ports;
    for (const XmlElement& port : model.children) {
      EXPECT_THAT(port.name, ::testing::AnyOf("input_port", "output_port"));
      EXPECT_FALSE(port.text.empty());
      EXPECT_THAT(port.attributes.at("type"), ::testing::AnyOf("std::string", "double", "bool"));
      ports.push_back(port.attributes.at("name"));
    }
    EXPECT_THAT(ports, Contains("outcome"));
  }
  EXPECT_THAT(ids, ElementsAre("GraspObject", "LocateObject", "NavigateToPose", "OpenGripper",
                               "ReachToPose"));
}

TEST(BehaviorTreeExport, EveryPortOfANodeIsInItsModel) {
  for (const Plan& plan : {SearchPlan(), FetchPlan()}) {
    const std::string xml = recipes::ToBehaviorTreeXml(plan);
    const XmlElement root = ParseXml(xml);
    std::map<std::string, std::set<std::string>> ports;
    for (const XmlElement& model : root.children.back().children) {
      for (const XmlElement& port : model.children) {
        ports[model.attributes.at("ID")].insert(port.attributes.at("name"));
      }
    }
    const std::function<void(const XmlElement&)> visit = [&](const XmlElement& element) {
      if (ports.count(element.name) > 0) {
        for (const auto& [name, value] : element.attributes) {
          EXPECT_TRUE(name == "name" || ports[element.name].count(name) > 0) << name;
        }
      }
      for (const XmlElement& child : element.children) visit(child);
    };
    visit(root.children.front());
  }
}

TEST(BehaviorTreeExport, KeysThatTheTreeItselfUsesAreRenamed) {
  Plan plan = SearchPlan();
  for (State& state : plan.states) {
    for (auto& [output, key] : state.outputs) key = "state";
    for (auto& input : state.inputs) {
      if (input.source == recipes::Parameter::Source::kStep) input.value = "{state}";
    }
  }
  const std::string xml = recipes::ToBehaviorTreeXml(plan);
  EXPECT_THAT(xml, HasSubstr("candidate_poses=\"{state_value}\""));
  EXPECT_THAT(xml, Not(HasSubstr("\"{state}\"")));
}

TEST(JsonExport, FollowsThePublishedSchema) {
  const nlohmann::json schema = Schema();
  EXPECT_THAT(ValidateJson(schema, recipes::ToJson(SearchPlan())), IsEmpty());
  EXPECT_THAT(ValidateJson(schema, recipes::ToJson(FetchPlan())), IsEmpty());
  std::mt19937 random(11);
  for (int i = 0; i < 50; ++i) {
    const auto json = recipes::ToJson(RandomPlan(random, 6));
    ASSERT_THAT(ValidateJson(schema, json), IsEmpty());
  }
}

TEST(JsonExport, TheSchemaRefusesWhatIsNoPlan) {
  const nlohmann::json schema = Schema();
  nlohmann::json plan = recipes::ToJson(SearchPlan());
  plan["states"][0]["id"] = "not an id";
  EXPECT_THAT(ValidateJson(schema, plan), Not(IsEmpty()));
  plan = recipes::ToJson(SearchPlan());
  plan.erase("start");
  EXPECT_THAT(ValidateJson(schema, plan), ElementsAre(HasSubstr("lacks \"start\"")));
  plan = recipes::ToJson(SearchPlan());
  plan["surprise"] = 1;
  EXPECT_THAT(ValidateJson(schema, plan), ElementsAre(HasSubstr("unknown member surprise")));
}

TEST(JsonExport, AResultWithoutAPlanSaysWhy) {
  const auto result = LibraryPlan("fetch-drink", "FetchDrink", "scout");
  const nlohmann::json json = recipes::ToJson(result);
  EXPECT_TRUE(json.at("plan").is_null());
  EXPECT_EQ(json.at("match").at("feasible"), false);
  EXPECT_EQ(json.at("match").at("smallest_repair").size(), 3u);
}

TEST(DotExport, ShowsAddedWaysDashedAndEndsDoubled) {
  const std::string dot = recipes::ToDot(SearchPlan());
  EXPECT_THAT(dot, HasSubstr("\"go-to-next-pose\" -> \"stop-vision\" [label=\"exhausted\", "
                             "style=dashed"));
  EXPECT_THAT(dot, HasSubstr("\"succeeded\" [shape=doublecircle"));
  Plan plan = SearchPlan();
  plan.states.front().label = "say \"hi\" \\ bye";
  EXPECT_THAT(recipes::ToDot(plan), HasSubstr("say \\\"hi\\\" \\\\ bye\\nStartVision"));
}

TEST(TextExport, TellsThePlanAndTheRefusal) {
  const std::string plan = recipes::ToText(SearchPlan());
  EXPECT_THAT(plan, HasSubstr("1. start-vision: StartVision"));
  EXPECT_THAT(plan, HasSubstr("exhausted -> stop-vision  (added: "));
  const std::string refusal =
      recipes::ToText(LibraryPlan("fetch-drink", "FetchDrink", "scout").match);
  EXPECT_THAT(refusal, HasSubstr("cannot do FetchDrink (fetch a drink)"));
  EXPECT_THAT(refusal, HasSubstr("The smallest repair is to add: "));
}

}  // namespace
}  // namespace lares::testing
