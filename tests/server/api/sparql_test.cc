#include <gmock/gmock.h>

#include <thread>

#include "base/error.h"
#include "server/http/url.h"
#include "tests/server/api/api_fixture.h"
#include "tests/server/http/raw_client.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kCups = R"(
@prefix : <https://w3id.org/lares#> .
:cup1 a :Cup ; :weight 3 .
:cup2 a :Cup ; :label "the \"blue\" one"@en .
)";

template <typename Condition>
bool Eventually(Condition condition) {
  for (int i = 0; i < 2500 && !condition(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return condition();
}

class SparqlTest : public ApiTest {
 protected:
  SparqlTest() {
    Answers().view = [this](const server::ViewRequest& about) {
      asked_ = about;
      if (about.environment == "nowhere") {
        throw Error(Code::kNotFound, "no environment is called 'nowhere'");
      }
      return view_;
    };
  }

  http::ClientResponse Query(const std::string& query, const std::string& accept = "",
                             std::multimap<std::string, std::string> more = {}) {
    more.emplace("query", query);
    http::ClientRequest request{"GET", "/v1/sparql", more, {}, {}};
    if (!accept.empty()) request.headers.Set("Accept", accept);
    return client_->Send(request);
  }
  static std::string Type(const http::ClientResponse& response) {
    return std::string(response.headers.Get("Content-Type"));
  }

  rdf::View view_ = ViewOfTurtle(kCups);
  server::ViewRequest asked_;
};

constexpr const char* kSelect = "SELECT ?c { ?c a lares:Cup } ORDER BY ?c";

TEST_F(SparqlTest, AQueryIsTakenFromTheAddressAFormOrTheBody) {
  const auto got = Query(kSelect);
  EXPECT_EQ(got.status, 200);
  EXPECT_EQ(Type(got), "application/sparql-results+json");
  EXPECT_EQ(Json(got)["head"]["vars"], nlohmann::json({"c"}));
  ASSERT_EQ(Json(got)["results"]["bindings"].size(), 2u);
  EXPECT_EQ(Json(got)["results"]["bindings"][0]["c"]["value"], "https://w3id.org/lares#cup1");
  EXPECT_EQ(Send("POST", "/v1/sparql", "application/sparql-query", kSelect).body, got.body);
  EXPECT_EQ(Send("POST", "/v1/sparql", "application/x-www-form-urlencoded",
                 "query=" + http::PercentEncode(kSelect))
                .body,
            got.body);
}

TEST_F(SparqlTest, TheFormatIsNegotiatedWithinTheQuerysForm) {
  EXPECT_THAT(Query(kSelect, "text/csv").body, StartsWith("c\r\nhttps://w3id.org/lares#cup1\r\n"));
  EXPECT_EQ(Type(Query(kSelect, "text/csv")), "text/csv; charset=utf-8");
  EXPECT_THAT(Query(kSelect, "text/tab-separated-values").body, StartsWith("?c\n"));
  EXPECT_THAT(Query(kSelect, "application/sparql-results+xml").body, HasSubstr("<sparql"));
  EXPECT_EQ(Type(Query(kSelect, "application/json")), "application/json");
  EXPECT_EQ(Json(Query("ASK { lares:cup1 a lares:Cup }"))["boolean"], true);
  const std::string construct = "CONSTRUCT { ?c a lares:Thing } WHERE { ?c a lares:Cup }";
  EXPECT_EQ(Type(Query(construct)), "text/turtle; charset=utf-8");
  EXPECT_THAT(Query(construct, "application/n-triples").body,
              HasSubstr("<https://w3id.org/lares#cup1> "));
  EXPECT_THAT(Query(construct, "application/rdf+xml").body, HasSubstr("<rdf:RDF"));
  EXPECT_THAT(Query("DESCRIBE lares:cup2", "", {{"as", "ntriples"}}).body,
              HasSubstr("\"the \\\"blue\\\" one\"@en"));
}

TEST_F(SparqlTest, AFormatThatTheFormDoesNotHaveIsRefusedWithWhatThereIs) {
  const auto table = Query(kSelect, "text/turtle");
  EXPECT_EQ(table.status, 406);
  EXPECT_EQ(Json(table)["code"], "not-acceptable");
  EXPECT_THAT(Json(table)["offered"].dump(), HasSubstr("application/sparql-results+json"));
  EXPECT_EQ(Query("DESCRIBE lares:cup1", "text/csv").status, 406);
  EXPECT_EQ(Query("DESCRIBE lares:cup1", "", {{"as", "csv"}}).status, 406);
}

TEST_F(SparqlTest, WhatIsNoQueryIsRefusedWithItsPlace) {
  const auto answer = Query("SELECT ?c {\n ?c a lares:Cup");
  EXPECT_EQ(answer.status, 422);
  EXPECT_EQ(Json(answer)["code"], "invalid");
  EXPECT_EQ(Json(answer)["place"]["line"], 2);
  EXPECT_EQ(Get("/v1/sparql").status, 400);
  EXPECT_EQ(Get("/v1/sparql?query=ASK%7B%7D&query=ASK%7B%7D").status, 400);
  EXPECT_EQ(Send("POST", "/v1/sparql", "application/sparql-update", "x").status, 415);
  EXPECT_EQ(Query("INSERT DATA { <urn:a> <urn:b> <urn:c> }").status, 415);
}

TEST_F(SparqlTest, ParametersAreCheckedAndBounded) {
  EXPECT_EQ(Query(kSelect, "", {{"timeout_ms", "60001"}}).status, 422);
  EXPECT_EQ(Query(kSelect, "", {{"timeout_ms", "0"}}).status, 422);
  EXPECT_EQ(Query(kSelect, "", {{"max_rows", "10000001"}}).status, 422);
  EXPECT_EQ(Query(kSelect, "", {{"explain", "what"}}).status, 422);
  EXPECT_EQ(Query(kSelect, "", {{"version", "2"}}).status, 422);
  EXPECT_EQ(Query(kSelect, "", {{"environment", "nowhere"}}).status, 404);
  EXPECT_EQ(
      Query(kSelect, "", {{"environment", "kitchen"}, {"version", "2"}, {"robot", "r"}}).status,
      200);
  EXPECT_EQ(asked_.environment, "kitchen");
  EXPECT_EQ(asked_.environment_version, 2);
  EXPECT_EQ(asked_.robot, "r");
}

TEST_F(SparqlTest, DocumentsAreNamedGraphsAndTheProtocolChoosesAmongThem) {
  const std::string graph = "https://w3id.org/lares/documents/recipe/demo";
  EXPECT_THAT(Query("SELECT DISTINCT ?g { GRAPH ?g { ?s ?p ?o } }", "text/csv").body,
              HasSubstr(graph));
  EXPECT_EQ(Json(Query("ASK { ?c a lares:Cup }", "", {{"default-graph-uri", graph}}))["boolean"],
            true);
  EXPECT_EQ(Json(Query("ASK { ?c a lares:Cup }", "", {{"named-graph-uri", graph}}))["boolean"],
            false);
  EXPECT_EQ(Query("ASK { ?c a lares:Cup }", "", {{"default-graph-uri", "urn:none"}}).status, 404);
}

TEST_F(SparqlTest, HistoricNamesMeanTheSame) {
  EXPECT_EQ(Json(Query("ASK { ?c a <http://old#Cup> }"))["boolean"], true);
}

TEST_F(SparqlTest, LimitsAreProblemsOfTheirOwn) {
  const auto rows = Query("SELECT * { ?a ?b ?c }", "", {{"max_rows", "2"}});
  EXPECT_EQ(rows.status, 413);
  EXPECT_EQ(Json(rows)["code"], "too-large");
  std::string cross = "SELECT (COUNT(*) AS ?n) {";
  for (int i = 0; i < 16; ++i) {
    const std::string n = std::to_string(i);
    cross += " ?a" + n + " ?b" + n + " ?c" + n + " .";
  }
  const auto late = Query(cross + " }", "", {{"timeout_ms", "100"}});
  EXPECT_EQ(late.status, 504);
  EXPECT_EQ(Json(late)["code"], "timeout");
}

TEST_F(SparqlTest, ThePlanIsExplained) {
  const auto plan = Query(kSelect, "", {{"explain", "plan"}});
  EXPECT_EQ(Type(plan), "text/plain; charset=utf-8");
  EXPECT_FALSE(plan.body.empty());
  EXPECT_TRUE(Json(Query(kSelect, "application/json", {{"explain", "run"}})).is_object() ||
              Json(Query(kSelect, "application/json", {{"explain", "run"}})).is_array());
}

TEST_F(SparqlTest, ALongAnswerIsStreamed) {
  // 6^6 rows: five triples and one more pattern each.
  const auto answer =
      Query("SELECT * { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i . ?j ?k ?l . ?m ?n ?o }", "text/csv");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.headers.Get("Transfer-Encoding"), "chunked");
  const auto lines = std::count(answer.body.begin(), answer.body.end(), '\n');
  EXPECT_EQ(lines, 1 + 4 * 4 * 4 * 4 * 4);
}

TEST_F(SparqlTest, AQueryEndsWithItsClientAndFreesItsSnapshot) {
  std::string cross = "SELECT (COUNT(*) AS ?n) {";
  for (int i = 0; i < 16; ++i) {
    const std::string n = std::to_string(i);
    cross += " ?a" + n + " ?b" + n + " ?c" + n + " .";
  }
  {
    http::RawClient client(server_->port());
    client.Say("GET /v1/sparql?timeout_ms=60000&query=" + http::PercentEncode(cross + " }") +
               " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    ASSERT_TRUE(Eventually([&] { return context_->snapshots->count() == 1; }));
    EXPECT_THAT(Get("/metrics").body, HasSubstr("lares_snapshots_pinned 1\n"));
  }
  EXPECT_TRUE(Eventually([&] { return context_->snapshots->count() == 0; }));
}

}  // namespace
}  // namespace lares::testing
