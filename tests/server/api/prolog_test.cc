// POST /v1/prolog: outcomes, formats, faults. The test program is its own worker.
#include <gmock/gmock.h>

#include <thread>

#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

class PrologApiTest : public ApiTest {
 protected:
  http::ClientResponse Ask(nlohmann::json body, const std::string& accept = "application/json") {
    return Send("POST", "/v1/prolog", "application/json", body.dump(), "Accept", accept);
  }
  nlohmann::json Problem(const nlohmann::json& body, int status) {
    const http::ClientResponse response = Ask(body);
    EXPECT_EQ(response.status, status) << response.body;
    EXPECT_EQ(response.headers.Get("Content-Type"), "application/problem+json");
    return Json(response);
  }
};

TEST_F(PrologApiTest, YesNoAndErrorAreThreeOutcomes) {
  const auto yes = Json(Ask({{"goal", "member(X, [1, 2])"}}));
  EXPECT_EQ(yes, nlohmann::json::parse(R"({"outcome": "yes", "count": 2, "complete": true,
                                           "answers": [{"X": 1}, {"X": 2}]})"));
  EXPECT_EQ(
      Json(Ask({{"goal", "fail"}})),
      nlohmann::json::parse(R"({"outcome": "no", "count": 0, "complete": true, "answers": []})"));
  const auto error = Problem({{"goal", "X is foo + 1"}}, 422);
  EXPECT_EQ(error["code"], "goal-error");
  EXPECT_EQ(error["kind"], "type");
}

TEST_F(PrologApiTest, AnErrorAfterAnAnswerFollowsIt) {
  const auto answer = Json(Ask({{"goal", "member(X, [1, a]), _ is X + 1"}}));
  EXPECT_EQ(answer["outcome"], "error");
  EXPECT_EQ(answer["count"], 1);
  EXPECT_EQ(answer["error"]["kind"], "type");
}

TEST_F(PrologApiTest, LinesComeOneForAnAnswerAndOneForTheEnd) {
  const auto response = Ask({{"goal", "member(X, [1, 2])"}}, "application/x-ndjson");
  EXPECT_EQ(response.headers.Get("Content-Type"), "application/x-ndjson");
  EXPECT_EQ(response.body,
            "{\"answer\":{\"X\":1}}\n{\"answer\":{\"X\":2}}\n"
            "{\"outcome\":\"yes\",\"count\":2,\"complete\":true}\n");
  EXPECT_EQ(Ask({{"goal", "X is foo + 1"}}, "application/x-ndjson").status, 422);
  EXPECT_EQ(Ask({{"goal", "true"}}, "text/html").status, 406);
}

TEST_F(PrologApiTest, TheFirstLineComesBeforeTheGoalHasEnded) {
  http::ClientRequest request{"POST", "/v1/prolog", {}, {}, {}};
  request.headers.Set("Content-Type", "application/json");
  request.headers.Set("Accept", "application/x-ndjson");
  request.body = nlohmann::json{{"goal", "X = 1 ; repeat, fail"}, {"timeout_s", 2}}.dump();
  const auto begin = std::chrono::steady_clock::now();
  std::chrono::steady_clock::duration first{};
  std::string body;
  client_->Send(request, {[&](std::string_view piece) {
                            if (body.empty()) first = std::chrono::steady_clock::now() - begin;
                            body += piece;
                          },
                          {},
                          {}});
  EXPECT_GT(std::chrono::steady_clock::now() - begin - first, std::chrono::milliseconds(1000));
  EXPECT_THAT(body, HasSubstr("\"outcome\":\"error\""));
  EXPECT_THAT(body, HasSubstr("\"kind\":\"time\""));
}

TEST_F(PrologApiTest, ManyAnswersStream) {
  const auto response =
      Ask({{"goal", "between(1, 20000, X)"}, {"limit", 100000}}, "application/x-ndjson");
  EXPECT_EQ(std::count(response.body.begin(), response.body.end(), '\n'), 20001);
  EXPECT_EQ(Json(Ask({{"goal", "repeat"}, {"limit", 5}}))["complete"], false);
}

TEST_F(PrologApiTest, FaultsAreProblemsOfTheirKind) {
  EXPECT_EQ(Problem({{"goal", "repeat, fail"}, {"timeout_s", 0.3}}, 504)["code"], "timeout");
  const auto syntax = Problem({{"goal", "X = 1,\n foo bar"}}, 422);
  EXPECT_EQ(syntax["kind"], "syntax");
  EXPECT_EQ(syntax["place"]["line"], 2);
  const auto refused = Problem({{"goal", "repeat, assertz(a(1)), fail"}}, 422);
  EXPECT_EQ(refused["kind"], "refused");
  EXPECT_THAT(refused["detail"], HasSubstr("assertz/1"));
  EXPECT_EQ(Problem({{"goal", "true"}, {"environment", "nowhere"}}, 404)["code"], "not-found");
}

TEST_F(PrologApiTest, MalformedQuestionsAreRefused) {
  EXPECT_EQ(Problem({{"goal", ""}}, 422)["code"], "invalid");
  EXPECT_EQ(Problem({{"goal", 1}}, 422)["code"], "invalid");
  EXPECT_EQ(Problem({{"goal", "true"}, {"limit", 0}}, 422)["code"], "invalid");
  EXPECT_EQ(Problem({{"goal", "true"}, {"timeout_s", 1000}}, 422)["code"], "invalid");
  EXPECT_EQ(Problem({{"goal", "true"}, {"gaol", 1}}, 422)["code"], "invalid");
  EXPECT_EQ(Problem(nlohmann::json::array(), 422)["code"], "invalid");
  EXPECT_EQ(Send("POST", "/v1/prolog", "application/json", "{").status, 400);
  EXPECT_EQ(Send("POST", "/v1/prolog", "text/plain", "true").status, 415);
  EXPECT_EQ(Problem({{"goal", std::string(5 << 20, 'a')}}, 413)["code"], "too-large");
}

TEST_F(PrologApiTest, AClientThatGoesAwayEndsItsGoal) {
  {
    http::Client impatient(server_->url(), {std::chrono::seconds(1), "", ""});
    http::ClientRequest request{"POST", "/v1/prolog", {}, {}, {}};
    request.headers.Set("Content-Type", "application/json");
    request.body = nlohmann::json{{"goal", "repeat, fail"}, {"timeout_s", 60}}.dump();
    EXPECT_THROW(impatient.Send(request), Error);
  }
  for (int i = 0; i < 100 && context_->workers->counts().running > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(context_->workers->counts().running, 0);
}

TEST_F(PrologApiTest, MetricsSayHowGoalsEnded) {
  Ask({{"goal", "true"}});
  Ask({{"goal", "repeat, fail"}, {"timeout_s", 0.2}});
  const std::string metrics = Get("/metrics").body;
  EXPECT_THAT(metrics, HasSubstr("lares_prolog_goals_total{ended=\"yes\"} 1"));
  EXPECT_THAT(metrics, HasSubstr("lares_prolog_goals_total{ended=\"time\"} 1"));
  EXPECT_THAT(metrics, HasSubstr("lares_prolog_workers_running 0"));
}

}  // namespace
}  // namespace lares::testing
