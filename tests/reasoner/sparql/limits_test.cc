// Queries that want too much are stopped within their limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/reasoner/sparql/sparql_support.h"

namespace lares::sparql::testing {
namespace {

using namespace std::chrono_literals;

const World& Crowd() {
  static const World world = [] {
    std::string turtle;
    for (int i = 0; i < 2000; ++i) {
      turtle += ":s" + std::to_string(i) + " :p " + std::to_string(i) + " ; :next :s" +
                std::to_string((i + 1) % 2000) + " .\n";
    }
    return World(turtle);
  }();
  return world;
}

struct Stopped {
  Code code = Code::kInternal;
  std::chrono::milliseconds after{0};
};

Stopped AskCrowd(std::string_view query, const Limits& limits, std::stop_token stop = {}) {
  ParseOptions options;
  options.prefixes = {{"", "http://example.org/"}};
  const auto start = std::chrono::steady_clock::now();
  Stopped stopped;
  try {
    Evaluate(Parse(query, options), Crowd().dataset(), limits, std::move(stop));
  } catch (const Error& error) {
    stopped.code = error.code();
  }
  stopped.after = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start);
  return stopped;
}

// A cross product of everything: 4000³ rows.
constexpr std::string_view kEverything = "{ ?a ?b ?c . ?d ?e ?f . ?g ?h ?i }";

std::string With(std::string_view head, std::string_view tail = "") {
  return std::string(head) + std::string(kEverything) + std::string(tail);
}

TEST(SparqlLimits, ACrossProductOfEverythingStopsInTime) {
  const Limits limits{200ms, SIZE_MAX, 64u << 20};
  for (const std::string& query :
       {With("SELECT (COUNT(*) AS ?n) "), With("SELECT (MAX(?c) AS ?n) "),
        With("SELECT * ", " OFFSET 1000000000000"), With("ASK ", "OFFSET 1000000000000"),
        std::string("SELECT (COUNT(*) AS ?n) { ?x (:next|!:next)* ?y . ?y (:next/:next)+ ?z }"),
        std::string(
            "SELECT * { ?a ?b ?c FILTER NOT EXISTS { ?d ?e ?f . ?g ?h ?i FILTER(?f = ?a) } }"),
        std::string(
            "SELECT * { VALUES ?q { 1 } ?a ?b ?c . ?d ?e ?f . ?g ?h ?i FILTER(?b = ?i) }")}) {
    const Stopped stopped = AskCrowd(query, limits);
    EXPECT_EQ(stopped.code, Code::kTimeout) << query;
    EXPECT_LT(stopped.after, 5s) << query;
  }
}

TEST(SparqlLimits, KeptRowsStopAtTheMemoryLimit) {
  const Limits limits{20s, SIZE_MAX, 8u << 20};
  for (const std::string& query :
       {With("SELECT * ", " ORDER BY ?a"), With("SELECT DISTINCT * "),
        With("SELECT ?a ?d ?g (COUNT(*) AS ?n) ", " GROUP BY ?a ?d ?g"),
        With("SELECT (GROUP_CONCAT(?c) AS ?n) "), With("SELECT (COUNT(DISTINCT *) AS ?n) "),
        std::string("SELECT * { ?x :p 1 MINUS { ?x ?b ?c . ?d ?e ?f } }"),
        With("CONSTRUCT { ?d ?h ?i } "),
        std::string("SELECT (COUNT(*) AS ?n) { { SELECT ?a ?d { ?a ?b ?c . ?d ?e ?f } } }")}) {
    EXPECT_EQ(AskCrowd(query, limits).code, Code::kTooLarge) << query;
  }
}

TEST(SparqlLimits, TextThatDoublesStopsAtTheMemoryLimit) {
  std::string query = "SELECT * { BIND(\"0123456789\" AS ?v0)";
  for (int i = 0; i < 60; ++i) {
    const std::string from = "?v" + std::to_string(i);
    query += " BIND(CONCAT(" + from + "," + from + ") AS ?v" + std::to_string(i + 1) + ")";
  }
  EXPECT_EQ(AskCrowd(query + "}", {20s, SIZE_MAX, 8u << 20}).code, Code::kTooLarge);
}

TEST(SparqlLimits, ComputedTermsOfRowsThatAreGoneTakeNoMemory) {
  const Limits limits{20s, SIZE_MAX, 1u << 20};
  ParseOptions options;
  options.prefixes = {{"", "http://example.org/"}};
  const Query query = Parse(
      "SELECT (CONCAT(\"a long text that is made for each row \", STR(?b), STR(?d)) AS ?t) "
      "{ ?a :p ?b . ?c :p ?d } LIMIT 200000",
      options);
  const Statistics statistics =
      Select(query, Crowd().dataset(), limits, {}, [](Cells) { return true; });
  EXPECT_EQ(statistics.rows, 200'000u);
  EXPECT_LT(statistics.peak_memory_bytes, 64u << 10);
}

TEST(SparqlLimits, RegularExpressionsThatExplodeAreStopped) {
  const Stopped stopped = AskCrowd(
      "SELECT * { FILTER REGEX(\"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaab\", "
      "\"^(a+)+$\") }",
      {});
  EXPECT_EQ(stopped.code, Code::kTooLarge);
  EXPECT_LT(stopped.after, 5s);
}

TEST(SparqlLimits, TooManyRowsAreRefusedNotCut) {
  EXPECT_EQ(AskCrowd("SELECT * { ?s ?p ?o }", {20s, 100, 64u << 20}).code, Code::kTooLarge);
  EXPECT_EQ(AskCrowd("CONSTRUCT WHERE { ?s ?p ?o }", {20s, 100, 64u << 20}).code, Code::kTooLarge);
  EXPECT_EQ(AskCrowd("SELECT * { ?s ?p ?o } LIMIT 100", {20s, 100, 64u << 20}).code,
            Code::kInternal);
}

TEST(SparqlLimits, AStopIsObeyed) {
  std::stop_source source;
  std::thread later([&] {
    std::this_thread::sleep_for(50ms);
    source.request_stop();
  });
  const Stopped stopped =
      AskCrowd(With("SELECT (COUNT(*) AS ?n) "), {20s, SIZE_MAX, 64u << 20}, source.get_token());
  later.join();
  EXPECT_EQ(stopped.code, Code::kTimeout);
  EXPECT_LT(stopped.after, 5s);
}

TEST(SparqlLimits, ReadersMayLeaveAtAnyRow) {
  std::size_t rows = 0;
  Select(Parse(With("SELECT * ")), Crowd().dataset(), {}, {}, [&](Cells) { return ++rows < 3; });
  EXPECT_EQ(rows, 3u);
}

}  // namespace
}  // namespace lares::sparql::testing
