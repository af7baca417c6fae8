#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class PlansTest : public ApiTest {
 protected:
  http::ClientResponse Plan(const std::string& body, const std::string& query = "",
                            const std::string& accept = "") {
    return Send("POST", "/v1/plans" + query, "application/json", body,
                accept.empty() ? "" : "Accept", accept);
  }
  const std::string kRequest = R"({"task":"FindBottle","robot":"pioneer"})";
};

TEST_F(PlansTest, APlanComesInTheFormatAskedFor) {
  const auto json = Plan(kRequest);
  EXPECT_EQ(json.status, 200);
  EXPECT_EQ(Json(json)["robot"], "pioneer");
  EXPECT_EQ(Plan(kRequest, "?as=bt-xml").body, "<root task=\"FindBottle\"/>");
  EXPECT_EQ(Plan(kRequest, "?as=bt-xml").headers.Get("Content-Type"), "application/xml");
  EXPECT_EQ(Plan(kRequest, "", "text/vnd.graphviz").body, "digraph {}\n");
  EXPECT_EQ(Plan(kRequest, "?as=text").body, "plan of FindBottle\n");
  EXPECT_EQ(Plan(kRequest, "", "image/png").status, 406);
  EXPECT_EQ(Plan(kRequest, "?as=poem").status, 422);
}

TEST_F(PlansTest, PddlComesInTwoDocuments) {
  EXPECT_EQ(Plan(kRequest, "?as=pddl-domain").body, "(define (domain d))\n");
  EXPECT_EQ(Plan(kRequest, "?as=pddl-problem").body, "(define (problem p))\n");
  EXPECT_EQ(Plan(kRequest, "?as=pddl-problem").headers.Get("Content-Type"), "text/x-pddl");
  EXPECT_EQ(Plan(kRequest, "", "text/x-pddl").body, "(define (domain d))\n");
  EXPECT_EQ(Plan(kRequest, "", "text/plain").body, "plan of FindBottle\n");
}

TEST_F(PlansTest, PlansAndRequestsForPlansAreCompared) {
  const auto diff = [&](const std::string& body, const std::string& query = "") {
    return Send("POST", "/v1/plans/diff" + query, "application/json", body, "", "");
  };
  const auto differ =
      diff(R"({"a":{"format":"lares-plan","task":"One"},"b":)" + kRequest + "}", "?as=text");
  EXPECT_EQ(differ.status, 200);
  EXPECT_EQ(differ.body, "One against FindBottle\n");
  EXPECT_EQ(differ.headers.Get("X-Plans-Equal"), "false");
  const auto equal = diff(R"({"a":)" + kRequest + R"(,"b":)" + kRequest + "}");
  EXPECT_EQ(equal.headers.Get("X-Plans-Equal"), "true");
  EXPECT_EQ(Json(equal)["a"], "FindBottle");
  EXPECT_EQ(diff("[]").status, 422);
  EXPECT_EQ(diff("{").status, 400);
  EXPECT_EQ(diff(R"({"a":)" + kRequest + "}").status, 422);
  EXPECT_EQ(diff(R"({"a":1,"b":2})").status, 422);
  EXPECT_EQ(diff(R"({"a":)" + kRequest + R"(,"b":)" + kRequest + R"(,"c":1})").status, 422);
  EXPECT_EQ(diff(R"({"a":)" + kRequest + R"(,"b":)" + kRequest + "}", "?as=dot").status, 422);
  const auto bad = diff(R"({"a":)" + kRequest + R"(,"b":{"format":"lares-plan"}})");
  EXPECT_EQ(bad.status, 422);
  EXPECT_THAT(bad.body, HasSubstr("plan b: / lacks"));
}

TEST_F(PlansTest, EveryMemberReachesThePlanner) {
  server::PlanRequest seen;
  Answers().plan = [&](const server::PlanRequest& request) {
    seen = request;
    server::PlanAnswer answer;
    answer.result.plan = recipes::Plan{};
    return answer;
  };
  Plan(R"({"task":"t","robot":"r","environment":"e","version":3,"strict":true,
           "templates":{"step":"template"}})");
  EXPECT_EQ(seen.environment, "e");
  EXPECT_EQ(seen.environment_version, 3);
  EXPECT_TRUE(seen.strict);
  EXPECT_EQ(seen.templates.at("step"), "template");
}

TEST_F(PlansTest, AnInfeasibleTaskIsAProblemThatExplainsItself) {
  Answers().plan = [](const server::PlanRequest&) {
    server::PlanAnswer answer;
    answer.result.match.task = {"urn:t", "ServeADrink", ""};
    answer.result.match.robot = {"urn:p", "Pioneer", ""};
    answer.result.match.smallest_repair = {{"urn:Arm", "ArmComponent", ""}};
    answer.capable_robots = {{"urn:a", "AMIGO", ""}, {"urn:b", "PR2", ""}};
    return answer;
  };
  const auto refused = Plan(kRequest);
  EXPECT_EQ(refused.status, 422);
  const auto problem = Json(refused);
  EXPECT_EQ(problem["code"], "not-feasible");
  EXPECT_EQ(problem["smallest_repair"][0]["label"], "ArmComponent");
  EXPECT_EQ(problem["capable_robots"][1]["label"], "PR2");
  EXPECT_EQ(problem["match"]["feasible"], false);
  EXPECT_EQ(problem["text"], "ServeADrink needs more\n");
  EXPECT_THAT(problem["detail"].get<std::string>(), HasSubstr("lacks ArmComponent"));
}

TEST_F(PlansTest, ARefusalNamesTheRobotsThatNearlyCan) {
  Answers().plan = [](const server::PlanRequest&) {
    server::PlanAnswer answer;
    recipes::RankedRobot near;
    near.robot = {"urn:b", "PR2", ""};
    near.cost = 3;
    near.repair = {{{{"urn:Program", "program", ""}, {}, 3, "program"}}, 3};
    answer.nearest_robots = {{"pr2", near}};
    return answer;
  };
  const auto problem = Json(Plan(kRequest));
  EXPECT_EQ(problem["nearest_robots"][0]["id"], "pr2");
  EXPECT_EQ(problem["nearest_robots"][0]["cost"], 3);
  EXPECT_EQ(problem["nearest_robots"][0]["add"][0]["what"]["label"], "program");
}

TEST_F(PlansTest, RobotsAreRankedForARecipe) {
  const auto answer = Json(Get("/v1/recipes/FindBottle/robots?environment=flat"));
  EXPECT_EQ(answer["task"]["label"], "FindBottle");
  ASSERT_EQ(answer["robots"].size(), 3U);
  EXPECT_EQ(answer["robots"][0]["feasible"], true);
  EXPECT_EQ(answer["robots"][0]["downloads"][0]["label"], "map");
  EXPECT_EQ(answer["robots"][1]["add"][0]["bounds"][0]["at_least"], 0.5);
  EXPECT_TRUE(answer["robots"][2]["cost"].is_null());
  EXPECT_EQ(answer["robots"][2]["repair_is_smallest"], true);
  const auto strict = Json(Get("/v1/recipes/FindBottle/robots?strict=true"));
  EXPECT_EQ(strict["robots"][2]["repair_is_smallest"], false);
  EXPECT_EQ(Get("/v1/recipes/FindBottle/robots?strict=perhaps").status, 422);
}

TEST_F(PlansTest, ChoicesAndUnusableRecipesAreProblemsOfTheirOwn) {
  Answers().plan = [](const server::PlanRequest&) {
    server::PlanAnswer answer;
    answer.result.match.feasible = true;
    answer.result.choices = {{{"urn:s", "Grasp", ""}, {{"urn:1", "A", ""}, {"urn:2", "B", ""}}}};
    return answer;
  };
  const auto choice = Json(Plan(kRequest));
  EXPECT_EQ(choice["code"], "choice-needed");
  EXPECT_THAT(choice["hint"].get<std::string>(), HasSubstr("--template Grasp="));
  Answers().plan = [](const server::PlanRequest&) {
    server::PlanAnswer answer;
    answer.result.match.feasible = true;
    answer.result.problems = {"transition 'X' leads to 'Y', which is no step of it"};
    return answer;
  };
  EXPECT_EQ(Json(Plan(kRequest))["code"], "recipe-unusable");
}

TEST_F(PlansTest, BadRequestsAreRefused) {
  EXPECT_EQ(Plan("{").status, 400);
  EXPECT_EQ(Plan("[]").status, 422);
  EXPECT_EQ(Plan(R"({"task":"t"})").status, 422);
  EXPECT_EQ(Plan(R"({"task":1,"robot":"r"})").status, 422);
  EXPECT_EQ(Plan(R"({"task":"t","robot":"r","version":1.5})").status, 422);
  EXPECT_EQ(Plan(R"({"task":"t","robot":"r","version":-1})").status, 422);
  EXPECT_EQ(Plan(R"({"task":"t","robot":"r","templates":[]})").status, 422);
  EXPECT_EQ(Plan(R"({"task":"t","robot":"r","enviroment":"e"})").status, 422);
  EXPECT_EQ(Send("POST", "/v1/plans", "text/plain", kRequest).status, 415);
  EXPECT_EQ(Plan(std::string(2'000'000, ' ')).status, 413);
  EXPECT_EQ(Plan(std::string(200'000, '[')).status, 400);
}

TEST_F(PlansTest, AnAmbiguousNameListsWhatItMayMean) {
  Answers().plan = [](const server::PlanRequest&) -> server::PlanAnswer {
    throw Error(Code::kAmbiguous, "'amigo' means several things")
        .WithCandidates({"amigo", "amigo2"});
  };
  const auto ambiguous = Plan(kRequest);
  EXPECT_EQ(ambiguous.status, 409);
  EXPECT_EQ(Json(ambiguous)["candidates"].size(), 2u);
}

TEST_F(ApiTest, LikelyPlacesAreRankedAndNameTheirTable) {
  const auto answer = Json(Get("/v1/likely-places?object=Cup&prior=omics&environment=lab"));
  EXPECT_EQ(answer["prior"]["name"], "omics");
  EXPECT_EQ(answer["rooms"][0]["label"], "Kitchen");
  EXPECT_NEAR(answer["rooms"][0]["probability"], 0.72834, 1e-9);
  EXPECT_EQ(answer["seen"][0]["environment"], "lab");
  EXPECT_EQ(answer["seen"][0]["age"], "just now");
  EXPECT_EQ(Get("/v1/likely-places").status, 422);
}

}  // namespace
}  // namespace lares::testing
