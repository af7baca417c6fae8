#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "base/file.h"
#include "recipes/plan/export.h"
#include "tests/recipes/json_schema.h"
#include "tests/recipes/random_plan.h"
#include "tests/recipes/world.h"
#include "tests/recipes/xml.h"

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

// {"Skill", {{"input", …}, {"output", …}}} → ports as the exported models list them.
std::map<std::string, std::set<std::string>> PortsInDocumentation() {
  const std::string text = ReadFile(Source("docs/plans.md"));
  const std::regex entry(R"re(\{"(\w+)", \{\{([^{}]*)\}, \{([^{}]*)\}\}\})re");
  const std::regex word(R"re("(\w+)")re");
  std::map<std::string, std::set<std::string>> skills;
  for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at) {
    std::set<std::string>& ports = skills[(*at)[1]];
    ports.insert("outcome");
    for (const int group : {2, 3}) {
      const std::string list = (*at)[group];
      for (std::sregex_iterator name(list.begin(), list.end(), word), none; name != none; ++name) {
        ports.insert((*name)[1]);
      }
    }
  }
  return skills;
}

TEST(BehaviorTreeExport, TheWorkedExampleKnowsEverySkillAndPortOfItsPlan) {
  const XmlElement root = ParseXml(recipes::ToBehaviorTreeXml(SearchPlan()));
  std::map<std::string, std::set<std::string>> exported;
  for (const XmlElement& model : root.children.back().children) {
    for (const XmlElement& port : model.children) {
      exported[model.attributes.at("ID")].insert(port.attributes.at("name"));
    }
  }
  EXPECT_EQ(PortsInDocumentation(), exported);
}

TEST(JsonExport, FollowsThePublishedSchema) {
  const nlohmann::json schema = Schema();
  EXPECT_THAT(ValidateJson(schema, recipes::ToJson(SearchPlan())), IsEmpty());
  EXPECT_THAT(ValidateJson(schema, recipes::ToJson(FetchPlan())), IsEmpty());
  std::mt19937 random(11);
  for (int i = 0; i < 50; ++i) {
    const auto json = recipes::ToJson(RandomPlan(random, 6));
    ASSERT_THAT(ValidateJson(schema, json), IsEmpty());
    const auto full = recipes::ToJson(RandomFullPlan(random, 6));
    ASSERT_THAT(ValidateJson(schema, full), IsEmpty()) << full.dump(1);
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
