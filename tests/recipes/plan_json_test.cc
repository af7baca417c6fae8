// Plans read back from JSON.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <random>

#include "base/error.h"
#include "recipes/plan/export.h"
#include "tests/recipes/random_plan.h"

namespace lares::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(PlanJson, WhatWasWrittenIsReadBack) {
  std::mt19937 random(23);
  for (int i = 0; i < 300; ++i) {
    const recipes::Plan plan = RandomFullPlan(random, 8);
    const json written = recipes::ToJson(plan);
    const recipes::Plan read = recipes::PlanFromJson(written);
    ASSERT_EQ(recipes::ToJson(read).dump(1), written.dump(1));
    // What the JSON leaves out would not show above.
    ASSERT_EQ(recipes::ToBehaviorTreeXml(read), recipes::ToBehaviorTreeXml(plan));
    ASSERT_EQ(recipes::ToPddlDomain(read), recipes::ToPddlDomain(plan));
    ASSERT_EQ(recipes::ToText(read), recipes::ToText(plan));
    ASSERT_EQ(recipes::ToDot(read), recipes::ToDot(plan));
  }
}

TEST(PlanJson, WhatOlderPlansDoNotHaveMayBeMissingAndAPackageIsNotThePlans) {
  std::mt19937 random(24);
  json written = recipes::ToJson(RandomPlan(random, 4));
  for (const char* name : {"requirements", "downloads", "repairs", "repair_is_smallest"}) {
    written["match"].erase(name);
  }
  written["package"] = {{"models", json::array()}};
  const recipes::Plan read = recipes::PlanFromJson(written);
  EXPECT_TRUE(read.match.repair_is_smallest);
  EXPECT_FALSE(recipes::ToJson(read).contains("package"));
}

std::string Refusal(const json& value) {
  try {
    recipes::PlanFromJson(value);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    return error.what();
  }
  return "";
}

class PlanJsonFaults : public ::testing::Test {
 protected:
  PlanJsonFaults() {
    std::mt19937 random(5);
    recipes::Plan plan = RandomFullPlan(random, 6);
    plan.states[0].retries = 2;
    plan_ = recipes::ToJson(plan);
  }
  std::string With(const std::string& pointer, const json& value) const {
    json plan = plan_;
    plan[json::json_pointer(pointer)] = value;
    return Refusal(plan);
  }
  json plan_;
};

TEST_F(PlanJsonFaults, NameTheirPlace) {
  EXPECT_EQ(Refusal(plan_), "");
  EXPECT_THAT(Refusal(json::array()), HasSubstr("/ must be an object"));
  EXPECT_THAT(With("/format", "other"), HasSubstr("/format must be \"lares-plan\""));
  EXPECT_THAT(With("/format_version", 2), HasSubstr("/format_version must be 1"));
  EXPECT_THAT(With("/surprise", 1), HasSubstr("/surprise is not known"));
  EXPECT_THAT(With("/a~1b", 1), HasSubstr("/a~1b is not known"));
  EXPECT_THAT(With("/states/0/kind", "loop"), HasSubstr("/states/0/kind must be one of"));
  EXPECT_THAT(With("/states/0/id", 5), HasSubstr("/states/0/id must be a text"));
  EXPECT_THAT(With("/states/0/outcomes", "failed"),
              HasSubstr("/states/0/outcomes must be an array"));
  EXPECT_THAT(With("/transitions/0/added", "yes"), HasSubstr("/transitions/0/added must be true"));
  EXPECT_THAT(With("/environment", json{{"id", "flat"}, {"version", -1}}),
              HasSubstr("/environment/version must be from 0"));
  EXPECT_THAT(With("/environment", json{{"id", "flat"}, {"version", 1e300}}),
              HasSubstr("/environment/version must be a whole number"));
  EXPECT_THAT(With("/environment", json{{"id", "flat"}, {"version", 18446744073709551615ull}}),
              HasSubstr("/environment/version must be from 0"));
  json plan = plan_;
  plan.erase("start");
  EXPECT_THAT(Refusal(plan), HasSubstr("/ lacks \"start\""));
}

TEST_F(PlanJsonFaults, AreFoundInWhatASkillMayHave) {
  json skill;
  for (const json& state : plan_["states"]) {
    if (state["kind"] == "skill") skill = state;
  }
  json plan = plan_;
  plan["states"] = json::array({skill});
  ASSERT_EQ(Refusal(plan), "");
  plan_ = plan;
  EXPECT_THAT(With("/states/0/retries", 1.5),
              HasSubstr("/states/0/retries must be a whole number"));
  EXPECT_THAT(With("/states/0/retries", 1'000'000), HasSubstr("must be from 0 to 100"));
  EXPECT_THAT(With("/states/0/time_limit_s", -1),
              HasSubstr("/states/0/time_limit_s must be above 0"));
  EXPECT_THAT(With("/states/0/time_limit_s", nullptr), HasSubstr("must be a number"));
  EXPECT_THAT(With("/states/0/tree_fragment", "<Inverter><Skill/></Inverter>"),
              HasSubstr("/states/0/tree_fragment cannot be used: <Inverter>"));
  EXPECT_THAT(With("/states/0/inputs/0/source", "dream"),
              HasSubstr("/states/0/inputs/0/source must be one of recipe"));
  EXPECT_THAT(With("/states/0/preconditions", json::array({json{{"name", ""}, {"holds", true}}})),
              HasSubstr("/states/0/preconditions/0/name must not be empty"));
}

TEST_F(PlanJsonFaults, AreBoundsToo) {
  EXPECT_THAT(With("/notes", std::vector<std::string>(20'000, "x")),
              HasSubstr("/notes has too many"));
  EXPECT_THAT(With("/start", std::string(100'000, 'x')), HasSubstr("/start is too long"));
  json finding = plan_["match"]["capabilities"][0];
  finding["dependencies"] = json::array();
  for (int i = 0; i < 200; ++i) {
    json outer = finding;
    outer["dependencies"] = json::array({finding});
    finding = outer;
  }
  EXPECT_THAT(With("/match/capabilities/0", finding), HasSubstr("lies too deep"));
}

}  // namespace
}  // namespace lares::testing
