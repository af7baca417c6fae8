#include "server/api/openapi.h"

#include <gmock/gmock.h>

#include "tests/server/api/api_fixture.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(ApiTest, RoutesAndOpenApiDocumentAgree) {
  EXPECT_THAT(api::CheckOpenApi(api::MakeRouter(*context_).routes()), IsEmpty());
}

TEST_F(ApiTest, ARouteThatNobodyDescribedIsNoticed) {
  http::Router router = api::MakeRouter(*context_);
  router.Add({"GET", "/v1/secret", "getSecret", nullptr, {}, 0});
  EXPECT_THAT(api::CheckOpenApi(router.routes()), ::testing::ElementsAre(HasSubstr("getSecret")));
  std::vector<http::Route> fewer = api::MakeRouter(*context_).routes();
  fewer.pop_back();
  EXPECT_EQ(api::CheckOpenApi(fewer).size(), 1u);
}

TEST_F(ApiTest, TheServedDocumentListsEveryRoute) {
  const auto document = Json(Get("/openapi.json"));
  EXPECT_EQ(document["openapi"], "3.1.0");
  const http::Router router = api::MakeRouter(*context_);
  for (const http::Route& route : router.routes()) {
    std::string method = route.method;
    for (char& c : method) c = static_cast<char>(std::tolower(c));
    ASSERT_TRUE(document["paths"].contains(route.path)) << route.path;
    EXPECT_EQ(document["paths"][route.path][method]["operationId"], route.operation);
  }
}

TEST_F(ApiTest, EveryGetWithoutParametersAnswers) {
  const http::Router router = api::MakeRouter(*context_);
  for (const http::Route& route : router.routes()) {
    if (route.method != "GET" || route.path.find('{') != std::string::npos) continue;
    if (route.operation == "findLikelyPlaces") continue;  // wants ?object=
    if (route.operation == "explainTriple" || route.operation == "explainAbsence") continue;
    if (route.operation == "measureDistance") continue;         // ?from=, ?to=
    if (route.operation == "getTypicalObjectModels") continue;  // ?room=
    if (route.operation == "querySparql" || route.operation == "watchQuery") continue;  // ?query=
    EXPECT_EQ(Get(route.path).status, 200) << route.path;
  }
}

TEST_F(ApiTest, ThePagesComeWithoutAnythingFromElsewhere) {
  for (const char* path : {"/", "/docs", "/web/docs.js", "/web/index.js", "/web/page.css"}) {
    const auto page = Get(path);
    EXPECT_EQ(page.status, 200);
    EXPECT_THAT(page.body, ::testing::Not(HasSubstr("//cdn")));
    EXPECT_THAT(page.body, ::testing::Not(HasSubstr("https://")));
    EXPECT_THAT(std::string(page.headers.Get("Content-Security-Policy")),
                HasSubstr("default-src 'none'"));
  }
}

TEST_F(ApiTest, OperationsReportTheState) {
  EXPECT_EQ(Json(Get("/healthz"))["status"], "ok");
  EXPECT_EQ(Json(Get("/readyz"))["status"], "ready");
  EXPECT_EQ(Json(Get("/v1/status"))["counts"]["statements_inferred"], 30);
  EXPECT_THAT(Get("/metrics").body,
              ::testing::AllOf(
                  HasSubstr("lares_http_requests_total{operation=\"getHealth\""),
                  HasSubstr("lares_terms 10\n"), HasSubstr("lares_snapshots_pinned 0\n"),
                  HasSubstr("lares_snapshot_oldest_seconds 0\n"),
                  HasSubstr("lares_watch_subscribers 0\n"), HasSubstr("lares_store_healthy 1\n")));
}

}  // namespace
}  // namespace lares::testing
