// Route × role × foreign id, made from the description of the interface: every operation is asked
// by everybody, and the answer has to be what the table says.
#include <gmock/gmock.h>

#include <optional>

#include "server/access/access.h"
#include "server/api/openapi.h"
#include "server/http/multipart.h"
#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using access::Role;
using access::Rule;
using nlohmann::json;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kOwn = "flat-1";
constexpr const char* kForeign = "lab-1";
constexpr const char* kAbsent = "lab-2";  // foreign, and there is none

// What a request of an operation looks like when it is about `environment`. Operations that are not
// listed are sent without a query, and with a body of one letter where they take one.
struct Asked {
  std::multimap<std::string, std::string> query;
  std::string type;
  std::string body;
};

std::string FormBody(const http::EncodedForm& form) {
  std::string body;
  for (const http::FormPiece& piece : form.pieces) body += piece.text;
  return body;
}

Asked Example(const std::string& operation, const std::string& environment) {
  const json plan{{"task", "T"}, {"robot", "R"}, {"environment", environment}};
  const std::multimap<std::string, std::string> about{{"environment", environment}};
  std::multimap<std::string, std::string> query = about;
  if (operation == "askProlog") {
    return {{}, "application/json", json{{"goal", "true"}, {"environment", environment}}.dump()};
  }
  if (operation == "makePlan") return {{}, "application/json", plan.dump()};
  if (operation == "diffPlans") {
    return {{}, "application/json", json{{"a", plan}, {"b", plan}}.dump()};
  }
  if (operation == "postSparql") {
    return {{},
            "application/x-www-form-urlencoded",
            "query=ASK%20%7B%3Fs%20%3Fp%20%3Fo%7D&environment=" + environment};
  }
  if (operation == "querySparql" || operation == "watchQuery") {
    query.emplace("query", "ASK {?s ?p ?o}");
    return {query, "", ""};
  }
  if (operation == "findLikelyPlaces") {
    query.emplace("object", "Cup");
    return {query, "", ""};
  }
  if (operation == "explainTriple" || operation == "explainAbsence") {
    query.insert({{"subject", "urn:a"}, {"predicate", "urn:b"}, {"object", "urn:c"}});
    return {query, "", ""};
  }
  if (operation == "measureDistance") {
    query.insert({{"from", "urn:a"}, {"to", "urn:b"}});
    return {query, "", ""};
  }
  if (operation == "rankRobots") return {about, "", ""};
  if (operation == "rollBackEnvironment") return {{}, "", R"({"to": 1})"};
  if (operation == "mergeEnvironmentVersions") return {{}, "", R"({"theirs": 1})"};
  if (operation == "putEnvironmentTag" || operation == "pinRobot") {
    return {{}, "", R"({"version": 1})"};
  }
  if (operation == "putEnvironmentVersion") {
    const http::EncodedForm form =
        http::EncodeForm({{"trajectory", kTrajectory, {}, "path.txt", "text/plain"}});
    return {{}, form.content_type, FormBody(form)};
  }
  return {};
}

void Replace(std::string& text, const std::string& what, const std::string& with) {
  if (const std::size_t at = text.find(what); at != std::string::npos) {
    text.replace(at, what.size(), with);
  }
}

std::string PathFor(const http::Route& route, const std::string& environment) {
  std::string path = route.path;
  std::string id = "thing";
  if (path.starts_with("/v1/environments/")) id = environment;
  if (path.starts_with("/v1/quarantine/")) id = "environment." + environment;
  Replace(path, "{id}", id);
  Replace(path, "{number}", "1");
  Replace(path, "{name}", path.starts_with("/v1/environments/") ? "trajectory" : "thing");
  Replace(path, "{robot}", "pioneer");
  Replace(path, "{tag}", "tagged");
  Replace(path, "{environment}", environment);
  Replace(path, "{sha256}", std::string(64, '0'));
  EXPECT_EQ(path.find('{'), std::string::npos) << route.path << " has a part that is new here";
  return path;
}

class AccessMatrixTest : public ApiTest {
 protected:
  AccessMatrixTest() {
    Answers().view = [](const server::ViewRequest&) { return ViewOfTurtle(kTurtle); };
    own_context_ = std::make_unique<api::Context>(api::Context{*store_, *knowledge_});
    own_context_->access = std::make_shared<access::Access>(
        *store_, access::AccessTable(api::OperationsJson()), [this] { return now_; });
    service_ = api::MakeService(*own_context_);
    Seed();
  }

  // What requests of the test take away is put back before the next one.
  void Seed() {
    for (const std::string environment : {kOwn, kForeign}) {
      if (!store_->FindEnvironment(environment)) {
        const auto writer = store_->NewBlob();
        writer->Append(kTrajectory);
        store::NewVersion version;
        version.environment = environment;
        version.layers = {{"trajectory", "path.txt", "text/plain", writer->Commit(), {}}};
        store_->PutVersion(version);
      }
      store_->PutTag({environment, "tagged", 1, {}, "", ""}, true);
      const std::string aside = "environment." + environment;
      if (store_->FindDocument(store::DocumentKind::kQuarantined, aside)) continue;
      store::NewDocument document;
      document.kind = store::DocumentKind::kQuarantined;
      document.id = aside;
      document.bytes = kTurtle + std::to_string(++seeds_);
      document.media_type = "text/turtle";
      store_->PutDocument(document);
    }
  }

  std::string Token(Role role, std::vector<std::string> environments = {},
                    std::optional<Time> expires = std::nullopt) {
    access::NewToken wanted;
    wanted.label = "test";
    wanted.role = role;
    wanted.environments = std::move(environments);
    wanted.expires = expires;
    wanted.limits = {0, 0, 0};
    const access::CreatedToken created = own_context_->access->Create(wanted);
    ids_[created.token] = created.record.id;
    return created.token;
  }

  http::Response Ask(const http::Route& route, const std::string& token,
                     const std::string& environment) {
    Seed();
    const Asked asked = Example(route.operation, environment);
    http::Request request;
    request.method = route.method;
    request.path = PathFor(route, environment);
    request.query = asked.query;
    request.headers.Set("Host", "localhost");
    if (!token.empty()) request.headers.Set("Authorization", "Bearer " + token);
    std::string body = asked.body;
    if (!route.consumes.empty()) {
      if (body.empty()) body = "x";
      request.headers.Set("Content-Type", asked.type.empty() ? route.consumes.front() : asked.type);
      request.has_body = true;
      request.content_length = body.size();
    }
    request.read_body = [body](const http::Sink& sink) { sink(body); };
    return service_->Answer(std::move(request));
  }

  static std::string Text(const http::Response& response) {
    const auto* text = std::get_if<std::string>(&response.body);
    return text == nullptr ? "" : *text;
  }
  static std::string CodeOf(const http::Response& response) {
    const json problem = json::parse(Text(response), nullptr, false);
    return problem.is_object() ? problem.value("code", "") : "";
  }
  Rule RuleOf(const http::Route& route) const {
    return own_context_->access->table().Of(route.operation, route.method);
  }
  const std::vector<http::Route>& routes() const { return service_->router().routes(); }

  Time now_ = Now();
  int seeds_ = 0;
  std::map<std::string, std::string> ids_;  // of tokens, by their text
  std::unique_ptr<api::Context> own_context_;
  std::shared_ptr<const http::Service> service_;
};

TEST_F(AccessMatrixTest, WithoutATokenOrWithABadOneOnlyThePublicIsGiven) {
  Token(Role::kAdmin);
  const std::string expired = Token(Role::kAdmin, {}, now_ + std::chrono::hours(1));
  const std::string revoked = Token(Role::kAdmin);
  own_context_->access->Revoke(ids_[revoked]);
  now_ += std::chrono::hours(2);
  std::string wrong = expired;
  wrong.back() = wrong.back() == 'a' ? 'b' : 'a';
  const std::vector<std::pair<std::string, std::string>> callers = {
      {"", "token-missing"},      {expired, "token-expired"},
      {revoked, "token-revoked"}, {wrong, "token-invalid"},
      {"guess", "token-invalid"}, {"lares_aaaaaaaaaa_" + std::string(40, 'a'), "token-invalid"}};
  for (const http::Route& route : routes()) {
    for (const auto& [token, code] : callers) {
      const http::Response response = Ask(route, token, kOwn);
      if (RuleOf(route).role == Role::kPublic) {
        EXPECT_LT(response.status, 400) << route.operation;
        continue;
      }
      EXPECT_EQ(response.status, 401) << route.operation << " " << code;
      EXPECT_EQ(CodeOf(response), code) << route.operation;
      EXPECT_THAT(std::string(response.headers.Get("WWW-Authenticate")), HasSubstr("Bearer"));
    }
  }
}

TEST_F(AccessMatrixTest, EveryRoleMayWhatTheTableSaysAndNoMore) {
  std::map<Role, std::string> tokens;
  for (const Role role : {Role::kAdmin, Role::kReader, Role::kRobot, Role::kEditor}) {
    tokens[role] = Token(role);
  }
  for (const http::Route& route : routes()) {
    for (const auto& [role, token] : tokens) {
      const http::Response response = Ask(route, token, kOwn);
      const std::string what = route.operation + " as " + std::string(access::ToString(role));
      if (role < RuleOf(route).role) {
        EXPECT_EQ(response.status, 403) << what;
        EXPECT_EQ(CodeOf(response), "role-too-low") << what;
      } else {
        EXPECT_THAT(response.status, Not(AnyOf(401, 403))) << what << Text(response);
      }
    }
  }
}

TEST_F(AccessMatrixTest, AScopedTokenReachesItsOwnAndIsNeverToldOfOthers) {
  Token(Role::kAdmin);
  const std::map<Role, std::string> tokens = {{Role::kReader, Token(Role::kReader, {"flat-*"})},
                                              {Role::kRobot, Token(Role::kRobot, {"flat-*"})},
                                              {Role::kEditor, Token(Role::kEditor, {kOwn})}};
  int foreign_checked = 0;
  for (const http::Route& route : routes()) {
    const Rule rule = RuleOf(route);
    const bool has_id = route.path.find("{id}") != std::string::npos;
    const bool names = rule.environments == Rule::Environments::kPath ||
                       rule.environments == Rule::Environments::kNamed ||
                       (rule.environments == Rule::Environments::kListed && has_id);
    for (const auto& [role, token] : tokens) {
      const std::string what = route.operation + " as " + std::string(access::ToString(role));
      const http::Response own = Ask(route, token, kOwn);
      const http::Response foreign = Ask(route, token, kForeign);
      if (role < rule.role) {
        EXPECT_EQ(own.status, 403) << what;
        EXPECT_EQ(foreign.status, 403) << what;
        continue;
      }
      EXPECT_THAT(own.status, Not(AnyOf(401, 403))) << what << Text(own);
      EXPECT_THAT(Text(own), Not(HasSubstr(kForeign))) << what;
      if (!names) continue;
      ++foreign_checked;
      // (Knowledge is faked here, and keeps nothing aside that could be released.)
      if (route.operation != "releaseQuarantinedDocument") {
        EXPECT_THAT(Text(own), Not(HasSubstr("there is no environment"))) << what;
        if (rule.environments == Rule::Environments::kPath) {
          EXPECT_NE(own.status, 404) << what;
        }
      }
      EXPECT_EQ(foreign.status, 404) << what << Text(foreign);
      // As for one that is not there, word for word.
      std::string absent = Text(Ask(route, token, kAbsent));
      std::string told = Text(foreign);
      json a = json::parse(absent), b = json::parse(told);
      EXPECT_EQ(a["code"], b["code"]) << what;
      std::string detail = a["detail"];
      Replace(detail, kAbsent, kForeign);
      EXPECT_EQ(detail, b["detail"]) << what;
      EXPECT_EQ(a.value("hint", ""), b.value("hint", "")) << what;
      EXPECT_EQ(a.value("candidates", json()), b.value("candidates", json())) << what;
    }
  }
  EXPECT_GT(foreign_checked, 30);
}

// So that a new operation cannot hide: one that takes an environment has to be declared, and one
// that is declared has to be tried above with an environment in it.
TEST_F(AccessMatrixTest, EveryOperationThatNamesEnvironmentsIsDeclaredAndTried) {
  const json described = json::parse(api::OperationsJson())["operations"];
  for (const http::Route& route : routes()) {
    ASSERT_TRUE(described[route.operation].contains("x-lares-role")) << route.operation;
    const Rule rule = RuleOf(route);
    const json parameters = described[route.operation].value("parameters", json::array());
    bool takes_environment = false;
    for (const json& parameter : parameters) {
      takes_environment = takes_environment || parameter.value("name", "") == "environment";
    }
    if (takes_environment && route.operation != "listAudit") {
      EXPECT_EQ(rule.environments, Rule::Environments::kNamed) << route.operation;
    }
    if (rule.environments != Rule::Environments::kNamed) continue;
    const Asked asked = Example(route.operation, kOwn);
    const auto named = asked.query.find("environment");
    EXPECT_TRUE((named != asked.query.end() && named->second == kOwn) ||
                asked.body.find(kOwn) != std::string::npos)
        << route.operation << " has no example with an environment in this test";
  }
}

TEST_F(AccessMatrixTest, TheFlagOfEditorsTakesTheRoleOfOne) {
  Token(Role::kAdmin);
  for (const Role role : {Role::kRobot, Role::kEditor}) {
    const http::EncodedForm form =
        http::EncodeForm({{"trajectory", kTrajectory, {}, "path.txt", "text/plain"}});
    http::Request request;
    request.method = "POST";
    request.path = std::string("/v1/environments/") + kOwn + "/versions";
    request.query.emplace("editor", "true");
    request.headers.Set("Host", "localhost");
    request.headers.Set("Authorization", "Bearer " + Token(role));
    request.headers.Set("Content-Type", form.content_type);
    request.has_body = true;
    request.read_body = [body = FormBody(form)](const http::Sink& sink) { sink(body); };
    EXPECT_EQ(service_->Answer(std::move(request)).status, role == Role::kRobot ? 403 : 201);
  }
}

}  // namespace
}  // namespace lares::testing
