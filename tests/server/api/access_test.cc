// Tokens and the audit log over HTTP, and the limits of a token.
#include "server/access/access.h"

#include <gmock/gmock.h>

#include <future>
#include <thread>

#include "server/api/openapi.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using access::Role;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class AccessTest : public ApiTest {
 protected:
  AccessTest() {
    Answers().view = [](const server::ViewRequest&) { return ViewOfTurtle(kTurtle); };
  }

  http::ClientResponse As(const std::string& token, const std::string& method,
                          const std::string& path, const std::string& type = "",
                          const std::string& body = "") {
    http::ClientRequest request{method, path, {}, {}, {}};
    if (!type.empty()) request.body = body;
    if (!type.empty()) request.headers.Set("Content-Type", type);
    if (!token.empty()) request.headers.Set("Authorization", "Bearer " + token);
    return client_->Send(request);
  }
  http::ClientResponse Create(const std::string& as, const nlohmann::json& token) {
    return As(as, "POST", "/v1/tokens", "application/json", token.dump());
  }
  std::string Made(const std::string& as, const nlohmann::json& token) {
    const auto response = Create(as, token);
    EXPECT_EQ(response.status, 201) << response.body;
    return Json(response).value("token", "");
  }
  std::string Admin() { return Made("", {{"label", "me"}, {"role", "admin"}}); }
  http::ClientResponse PutRecipe(const std::string& token, const std::string& id,
                                 const std::string& bytes = kTurtle) {
    return As(token, "PUT", "/v1/recipes/" + id, "text/turtle", bytes);
  }
};

TEST_F(AccessTest, WithoutTokensEverythingIsOpenAndFromTheFirstOneOnNothing) {
  EXPECT_EQ(Get("/v1/recipes").status, 200);
  EXPECT_EQ(PutRecipe("", "a").status, 201);
  const std::string admin = Admin();
  const auto refused = Get("/v1/recipes");
  EXPECT_EQ(refused.status, 401);
  EXPECT_EQ(Json(refused)["code"], "token-missing");
  EXPECT_EQ(refused.headers.Get("WWW-Authenticate"), "Bearer realm=\"lares\"");
  EXPECT_EQ(Get("/healthz").status, 200);
  EXPECT_EQ(Get("/docs").status, 200);
  EXPECT_EQ(As(admin, "GET", "/v1/recipes").status, 200);
}

TEST_F(AccessTest, TheFirstTokenIsAnAdmins) {
  const auto refused = Create("", {{"label", "x"}, {"role", "robot"}});
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(Get("/v1/tokens").status, 200);  // still open
}

TEST_F(AccessTest, ATokensTextIsShownOnceAndKeptNowhere) {
  const std::string admin = Admin();
  const auto created = Create(admin, {{"label", "kitchen-bot"},
                                      {"role", "robot"},
                                      {"environments", {"flat-*"}},
                                      {"expires", "2100-01-31T12:00:00Z"}});
  ASSERT_EQ(created.status, 201);
  EXPECT_EQ(created.headers.Get("Cache-Control"), "no-store");
  const auto json = Json(created);
  const std::string text = json["token"];
  const std::string secret = text.substr(text.rfind('_') + 1);
  const std::string id = json["id"];
  for (const std::string& path :
       {std::string("/v1/tokens"), "/v1/tokens/" + id, std::string("/v1/audit")}) {
    const auto shown = As(admin, "GET", path);
    EXPECT_EQ(shown.status, 200);
    EXPECT_THAT(shown.body, HasSubstr(id));
    EXPECT_THAT(shown.body, Not(HasSubstr(secret)));
  }
  std::ifstream database(folder_ / "data" / "lares.sqlite", std::ios::binary);
  std::ifstream log(folder_ / "data" / "lares.sqlite-wal", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(database), {}};
  bytes.append(std::istreambuf_iterator<char>(log), {});
  EXPECT_THAT(bytes, HasSubstr("kitchen-bot"));
  EXPECT_EQ(bytes.find(secret), std::string::npos);
}

TEST_F(AccessTest, WhatMakesNoSenseIsRefusedByName) {
  const std::string admin = Admin();
  const auto refusal = [&](const nlohmann::json& token) {
    const auto response = Create(admin, token);
    EXPECT_EQ(response.status, 422) << token;
    return Json(response).value("detail", "");
  };
  EXPECT_THAT(refusal({{"role", "robot"}}), HasSubstr("label"));
  EXPECT_THAT(refusal({{"label", " "}, {"role", "robot"}}), HasSubstr("label"));
  EXPECT_THAT(refusal({{"label", "x"}}), HasSubstr("role"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "public"}}), HasSubstr("role"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "god"}}), HasSubstr("role"));
  EXPECT_THAT(refusal({{"label", 5}, {"role", "robot"}}), HasSubstr("label"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"environments", {"a b"}}}),
              HasSubstr("a b"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"environments", "a"}}),
              HasSubstr("environments"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "admin"}, {"environments", {"a"}}}),
              HasSubstr("admin"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"expires", "soon"}}),
              HasSubstr("expires"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"expires", "2020-01-01T00:00:00Z"}}),
              HasSubstr("expired"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"max_queries", -1}}),
              HasSubstr("max_queries"));
  EXPECT_THAT(refusal({{"label", "x"}, {"role", "robot"}, {"colour", "red"}}), HasSubstr("colour"));
  EXPECT_EQ(As(admin, "POST", "/v1/tokens", "application/json", "{").status, 400);
  EXPECT_EQ(Json(As(admin, "GET", "/v1/tokens"))["count"], 1);
}

TEST_F(AccessTest, ARevokedTokenIsRefusedAtOnceAndTheLastAdminStays) {
  const std::string admin = Admin();
  const std::string reader = Made(admin, {{"label", "r"}, {"role", "reader"}});
  EXPECT_EQ(As(reader, "GET", "/v1/recipes").status, 200);
  const auto id_of = [](const std::string& text) { return text.substr(6, 10); };
  EXPECT_EQ(As(reader, "DELETE", "/v1/tokens/" + id_of(reader)).status, 403);
  const auto revoked = As(admin, "DELETE", "/v1/tokens/" + id_of(reader));
  EXPECT_EQ(revoked.status, 200);
  EXPECT_EQ(Json(revoked)["state"], "revoked");
  const auto refused = As(reader, "GET", "/v1/recipes");
  EXPECT_EQ(refused.status, 401);
  EXPECT_EQ(Json(refused)["code"], "token-revoked");
  EXPECT_THAT(std::string(refused.headers.Get("WWW-Authenticate")), HasSubstr("invalid_token"));
  EXPECT_EQ(As(admin, "DELETE", "/v1/tokens/" + id_of(admin)).status, 409);
  EXPECT_EQ(As(admin, "DELETE", "/v1/tokens/nobody").status, 404);
  const std::string second = Made(admin, {{"label", "me too"}, {"role", "admin"}});
  EXPECT_EQ(As(second, "DELETE", "/v1/tokens/" + id_of(admin)).status, 200);
  EXPECT_EQ(As(admin, "GET", "/v1/tokens").status, 401);
}

TEST_F(AccessTest, OnlyOneAuthorizationAndOnlyAsBearer) {
  const std::string admin = Admin();
  http::ClientRequest request{"GET", "/v1/recipes", {}, {}, {}};
  request.headers.Set("Authorization", "bearer  " + admin);
  EXPECT_EQ(client_->Send(request).status, 200);
  request.headers.Add("Authorization", "Bearer " + admin);
  EXPECT_EQ(client_->Send(request).status, 400);
  for (const std::string& value : {"Basic " + admin, admin, std::string("Bearer")}) {
    request.headers.Set("Authorization", value);
    EXPECT_EQ(client_->Send(request).status, 401) << value;
  }
  EXPECT_EQ(Get("/v1/recipes?token=" + admin).status, 401);
}

TEST_F(AccessTest, EveryWriteIsInTheAuditLogWithItsToken) {
  PutRecipe("", "open");
  const std::string admin = Admin();
  const std::string editor = Made(admin, {{"label", "ed"}, {"role", "editor"}});
  const std::string reader = Made(admin, {{"label", "re"}, {"role", "reader"}});
  EXPECT_EQ(PutRecipe(editor, "a").status, 201);
  EXPECT_EQ(PutRecipe(editor, "a", "<urn:a> <urn:b> <urn:d> .\n").status, 200);
  EXPECT_EQ(PutRecipe(editor, "b", "malformed").status, 422);
  EXPECT_EQ(PutRecipe(reader, "c").status, 403);
  EXPECT_EQ(PutRecipe("nobody", "d").status, 401);
  EXPECT_EQ(As(editor, "GET", "/v1/recipes").status, 200);
  EXPECT_EQ(As(editor, "GET", "/v1/audit").status, 403);
  const auto all = Json(As(admin, "GET", "/v1/audit"))["items"];
  std::vector<std::string> told;
  for (const auto& record : all) {
    told.push_back(record["label"].get<std::string>() + " " +
                   record["operation"].get<std::string>() + " " +
                   record["result"].get<std::string>());
  }
  EXPECT_THAT(
      told, ::testing::ElementsAre("re putRecipe role-too-low", "ed putRecipe invalid",
                                   "ed putRecipe done", "ed putRecipe done", "me createToken done",
                                   "me createToken done", " createToken done", " putRecipe done"));
  EXPECT_EQ(all[2]["target"], "/v1/recipes/a");
  EXPECT_EQ(all[2]["version"], 2);
  EXPECT_EQ(all[3]["version"], 1);
  EXPECT_EQ(all[3]["bytes"], std::string(kTurtle).size());
  EXPECT_FALSE(all[3]["request_id"].get<std::string>().empty());
  const std::string id = editor.substr(6, 10);
  EXPECT_EQ(Json(As(admin, "GET", "/v1/audit?token=" + id))["items"].size(), 3u);
  EXPECT_THAT(Json(As(admin, "GET", "/v1/audit?since=2100-01-01T00:00:00Z"))["items"], IsEmpty());
  EXPECT_EQ(As(admin, "GET", "/v1/audit?since=yesterday").status, 422);
  const auto page = Json(As(admin, "GET", "/v1/audit?limit=5"));
  EXPECT_EQ(page["items"].size(), 5u);
  const auto rest =
      Json(As(admin, "GET", "/v1/audit?limit=5&after=" + page["next"].get<std::string>()));
  EXPECT_EQ(rest["items"].size(), 3u);
  EXPECT_TRUE(rest["next"].is_null());
}

TEST_F(AccessTest, AVersionOfAnEnvironmentIsFoundInTheAuditLogByIt) {
  const std::string admin = Admin();
  const std::string robot =
      Made(admin, {{"label", "bot"}, {"role", "robot"}, {"environments", {"flat-*"}}});
  for (const char* id : {"flat-1", "lab-1"}) {
    http::ClientRequest request{"POST",
                                std::string("/v1/environments/") + id + "/versions",
                                {},
                                {},
                                http::EncodeForm({{"trajectory", kTrajectory, {}, "p.txt", ""}})};
    request.headers.Set("Authorization", "Bearer " + robot);
    EXPECT_EQ(client_->Send(request).status, id[0] == 'f' ? 201 : 404);
  }
  const auto made = Json(As(admin, "GET", "/v1/audit?environment=flat-1"))["items"];
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0]["version"], 1);
  EXPECT_EQ(made[0]["target"], "/v1/environments/flat-1/versions/1");
  const auto refused = Json(As(admin, "GET", "/v1/audit?environment=lab-1"))["items"];
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0]["result"], "not-found");
  EXPECT_FALSE(store_->FindEnvironment("lab-1"));
}

TEST_F(AccessTest, WhoAsksMoreOftenThanAllowedIsToldWhenToComeAgain) {
  const std::string admin = Admin();
  const std::string few =
      Made(admin, {{"label", "f"}, {"role", "reader"}, {"max_requests_per_minute", 3}});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(As(few, "GET", "/v1/recipes").status, 200);
  const auto refused = As(few, "GET", "/v1/recipes");
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(Json(refused)["code"], "too-many-requests");
  const int wait_s = std::stoi(std::string(refused.headers.Get("Retry-After")));
  EXPECT_GE(wait_s, 1);
  EXPECT_LE(wait_s, 20);
  EXPECT_EQ(As(admin, "GET", "/v1/recipes").status, 200);  // others go on
  EXPECT_EQ(As(few, "GET", "/healthz").status, 200);
}

TEST_F(AccessTest, WhoHasStoredAsMuchAsAllowedTodayStoresNoMore) {
  const std::string admin = Admin();
  const std::string editor =
      Made(admin, {{"label", "e"}, {"role", "editor"}, {"max_bytes_per_day", 1000}});
  const std::string bytes = kTurtle + std::string(600, '#') + "\n";
  EXPECT_EQ(PutRecipe(editor, "a", bytes).status, 201);
  const auto refused = PutRecipe(editor, "b", bytes);
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(Json(refused)["code"], "too-many-bytes");
  EXPECT_GE(std::stoi(std::string(refused.headers.Get("Retry-After"))), 1);
  EXPECT_EQ(PutRecipe(editor, "c").status, 201);  // what still fits
  EXPECT_EQ(As(editor, "GET", "/v1/recipes").status, 200);
  EXPECT_FALSE(store_->FindDocument(store::DocumentKind::kRecipe, "b"));
}

TEST_F(AccessTest, QueriesAtOnceAreCountedByToken) {
  const std::string admin = Admin();
  const std::string one = Made(admin, {{"label", "q"}, {"role", "robot"}, {"max_queries", 1}});
  std::promise<void> begun, go_on;
  auto gate = go_on.get_future().share();
  std::atomic<int> asked{0};
  Answers().plan = [&, gate](const server::PlanRequest&) {
    if (asked++ == 0) {
      begun.set_value();
      gate.wait();
    }
    throw Error(Code::kNotFound, "no such task");
    return server::PlanAnswer{};
  };
  const std::string body = R"({"task": "T", "robot": "R"})";
  std::thread first([&] {
    http::Client other(server_->url());
    http::ClientRequest request{"POST", "/v1/plans", {}, {}, body};
    request.headers.Set("Content-Type", "application/json");
    request.headers.Set("Authorization", "Bearer " + one);
    EXPECT_EQ(other.Send(request).status, 404);
  });
  begun.get_future().wait();
  const auto refused = As(one, "POST", "/v1/plans", "application/json", body);
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(Json(refused)["code"], "too-many-queries");
  EXPECT_EQ(refused.headers.Get("Retry-After"), "1");
  EXPECT_EQ(As(admin, "POST", "/v1/plans", "application/json", body).status, 404);
  go_on.set_value();
  first.join();
  EXPECT_EQ(As(one, "POST", "/v1/plans", "application/json", body).status, 404);
}

TEST_F(AccessTest, AWatchEndsWithItsToken) {
  const std::string admin = Admin();
  const std::string reader = Made(admin, {{"label", "r"}, {"role", "reader"}});
  std::promise<void> told;
  std::thread watching([&] {
    http::Client other(server_->url());
    http::ClientRequest request{"GET", "/v1/watches", {{"query", "SELECT * {?s ?p ?o}"}}, {}, {}};
    request.headers.Set("Authorization", "Bearer " + reader);
    http::Transfer transfer;
    bool first = true;
    transfer.sink = [&](std::string_view) {
      if (first) told.set_value();
      first = false;
    };
    EXPECT_EQ(other.Send(request, transfer).status, 200);
  });
  told.get_future().wait();
  EXPECT_EQ(As(admin, "DELETE", "/v1/tokens/" + reader.substr(6, 10)).status, 200);
  watching.join();  // within seconds, or the test's time is over
}

TEST_F(AccessTest, AStoreWithTokensNeverOpensAgain) {
  const std::string admin = Admin();
  context_->access = nullptr;
  server_.reset();
  auto again = std::make_unique<api::Context>(api::Context{*store_, *knowledge_});
  again->access =
      std::make_shared<access::Access>(*store_, access::AccessTable(api::OperationsJson()),
                                       [] { return Now() + std::chrono::hours(24 * 365 * 200); });
  const auto service = api::MakeService(*again);
  http::Request request;
  request.method = "GET";
  request.path = "/v1/recipes";
  request.headers.Set("Host", "localhost");
  EXPECT_EQ(service->Answer(request).status, 401);
}

}  // namespace
}  // namespace lares::testing
