// Ontologies built to explode, and broken ones: each ends soon, with an answer or a clear error,
// and takes no more memory than the limit on inferred triples allows.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::TripleOf;

const std::string kPrefixes =
    "@prefix : <http://example.org/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n";

std::string N(const char* name, int number) { return ":" + (name + std::to_string(number)); }

// Numbers 0 to count − 1, each said by `say`.
std::string Each(int count, const std::function<std::string(int)>& say) {
  std::string text;
  for (int i = 0; i < count; ++i) text += say(i);
  return text;
}

struct Outcome {
  rdf::View view{std::make_shared<rdf::Dictionary>()};
  std::optional<Code> error;
  std::string message;
  double seconds = 0;
  double grown_mib = 0;  // of the process' peak
};

double PeakMib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Outcome Close(const std::string& text, std::size_t max_inferred = 1'000'000) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::View empty(dictionary);
  rdf::ReadOptions reading;
  reading.source = "hostile.ttl";
  const rdf::Graph graph = rdf::MakeGraph(
      rdf::ReadRdf(kPrefixes + text, rdf::Format::kTurtle, reading), "hostile", {}, *dictionary);
  Options options;
  options.max_inferred = max_inferred;
  std::stop_source stop;
  // A case that this has to end has failed.
  std::jthread watch([&](const std::stop_token& done) {
    for (int i = 0; i < 600 && !done.stop_requested(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    stop.request_stop();
  });
  Outcome outcome;
  const double before = PeakMib();
  const auto start = std::chrono::steady_clock::now();
  try {
    outcome.view = empty.With(Materialise(empty, {graph}, options, stop.get_token()));
  } catch (const Error& error) {
    outcome.error = error.code();
    outcome.message = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.grown_mib = PeakMib() - before;
  std::printf("%.3f s, %.0f MiB, %s\n", outcome.seconds, outcome.grown_mib,
              outcome.error ? "error" : std::to_string(outcome.view.size()).c_str());
  return outcome;
}

void ExpectTooLarge(const Outcome& outcome) {
  ASSERT_TRUE(outcome.error);
  EXPECT_EQ(*outcome.error, Code::kTooLarge);
  EXPECT_LT(outcome.grown_mib, 400);
}

TEST(OwlHostileTest, EquivalencesWithoutEndAreTooLarge) {
  ExpectTooLarge(Close(Each(
      3000, [](int i) { return N("C", i) + " owl:equivalentClass " + N("C", i + 1) + " .\n"; })));
}

TEST(OwlHostileTest, DefinitionsWithinDefinitionsAreClosed) {
  const Outcome outcome = Close(
      ":x a :C0 .\n" + Each(200,
                            [](int i) {
                              return N("C", i) + " owl:equivalentClass [ owl:intersectionOf ( " +
                                     N("C", i + 1) + " [ owl:unionOf ( " + N("D", i) +
                                     " [ a owl:Restriction ; owl:onProperty :p ; " +
                                     "owl:someValuesFrom " + N("C", i + 1) + " ] ) ] ) ] .\n";
                            }),
      2'000'000);
  EXPECT_FALSE(outcome.error);
}

// 60^7 ways lead to 60^2 answers.
TEST(OwlHostileTest, AChainOverACliqueIsTooLarge) {
  std::string text = ":q owl:propertyChainAxiom ( :p :p :p :p :p :p :p ) .\n";
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 60; ++k) text += N("n", i) + " :p " + N("n", k) + " .\n";
  }
  const Outcome outcome = Close(text);
  ExpectTooLarge(outcome);
  EXPECT_NE(outcome.message.find("prp-spo2"), std::string::npos) << outcome.message;
}

TEST(OwlHostileTest, AChainThatFeedsItselfOverACliqueIsClosed) {
  std::string text = ":p owl:propertyChainAxiom ( :p :p :p ) ; a owl:TransitiveProperty .\n";
  for (int i = 0; i < 50; ++i) {
    for (int k = 0; k < 50; ++k) text += N("n", i) + " :p " + N("n", k) + " .\n";
  }
  EXPECT_FALSE(Close(text).error);
}

TEST(OwlHostileTest, KeysOfManyPropertiesOverManyLikeThingsAreClosed) {
  const std::string text = ":C owl:hasKey ( :k0 :k1 :k2 :k3 :k4 :k5 ) .\n" + Each(100, [](int i) {
                             std::string thing = N("i", i) + " a :C";
                             for (int k = 0; k < 6; ++k) {
                               for (int v = 0; v < 4; ++v) {
                                 thing += " ; " + N("k", k) + " " + std::to_string((i + v) % 7);
                               }
                             }
                             return thing + " .\n";
                           });
  EXPECT_FALSE(Close(text).error);
}

TEST(OwlHostileTest, ManyValuesWhereThereMayBeOneBecomeOneThing) {
  const std::string text =
      ":p a owl:FunctionalProperty , owl:InverseFunctionalProperty .\n" +
      Each(3000, [](int i) { return ":x :p " + N("v", i) + " .\n" + N("w", i) + " :p :v0 .\n"; });
  const Outcome outcome = Close(text);
  ASSERT_FALSE(outcome.error);
  EXPECT_LT(outcome.view.size(), 20'000U);
}

TEST(OwlHostileTest, ThousandsOfDifferentThingsAndDisjointClassesAreNoPairs) {
  std::string members, classes, facts;
  for (int i = 0; i < 3000; ++i) {
    members += N("m", i) + ' ';
    classes += N("C", i) + ' ';
    facts += N("m", i) + " a " + N("C", i) + " .\n";
  }
  const Outcome outcome =
      Close("[] a owl:AllDifferent ; owl:distinctMembers ( " + members +
            ") .\n[] a owl:AllDisjointClasses ; owl:members ( " + classes + ") .\n" + facts);
  ASSERT_FALSE(outcome.error);
  EXPECT_TRUE(outcome.view.layers()[0]->clashes().empty());
}

TEST(OwlHostileTest, ThousandsOfContradictionsAreCounted) {
  const std::string text =
      Each(300, [](int i) { return N("C", i) + " owl:disjointWith " + N("C", i + 1) + " .\n"; }) +
      Each(300, [](int i) {
        std::string thing = N("i", i) + " a :C0";
        for (int k = 1; k <= 300; ++k) thing += ", " + N("C", k);
        return thing + " .\n";
      });
  const Outcome outcome = Close(text);
  ASSERT_FALSE(outcome.error);
  EXPECT_EQ(outcome.view.layers()[0]->clash_count(), 90'000U);
}

TEST(OwlHostileTest, ListsThatAreNoListsSayNothing) {
  const Outcome outcome = Close(
      ":A owl:intersectionOf _:loop . _:loop rdf:first :B ; rdf:rest _:loop .\n"
      ":C owl:unionOf _:two . _:two rdf:first :D , :E ; rdf:rest () .\n"
      ":F owl:oneOf _:endless . _:endless rdf:first :f ; rdf:rest :nowhere .\n"
      ":G owl:intersectionOf \"list\" . :H owl:unionOf () . :I owl:oneOf :I .\n"
      ":q owl:propertyChainAxiom _:headless . _:headless rdf:rest ( :p ) .\n"
      "_:first rdf:first _:first ; rdf:rest _:first . :J owl:intersectionOf _:first .\n"
      ":x a :B , :D , :A ; :p :y .");
  ASSERT_FALSE(outcome.error);
  EXPECT_FALSE(outcome.view.Contains(TripleOf(":x a :J", outcome.view.dictionary())));
}

TEST(OwlHostileTest, ListsOfAHundredThousandMembersAreRead) {
  std::string members;
  for (int i = 0; i < 100'000; ++i) members += N("m", i) + ' ';
  const Outcome outcome = Close(":A owl:oneOf ( " + members + ") .");
  ASSERT_FALSE(outcome.error);
  EXPECT_TRUE(outcome.view.Contains(TripleOf(":m99999 a :A", outcome.view.dictionary())));
}

TEST(OwlHostileTest, LiteralsOutOfTheirValueSpaceAreContradictionsNotCrashes) {
  const std::string digits(100'000, '9');
  const Outcome outcome =
      Close(":x :p \"abc\"^^xsd:integer , \"" + digits + "\"^^xsd:integer , \"" + digits +
            "\"^^xsd:byte , \"1e999999999\"^^xsd:double , \"-\"^^xsd:decimal , "
            "\"2026-13-45T99:99:99\"^^xsd:dateTime , \"\"^^xsd:boolean , \"NaN\"^^xsd:float .\n"
            ":p rdfs:range xsd:integer .");
  ASSERT_FALSE(outcome.error);
  EXPECT_GE(outcome.view.layers()[0]->clash_count(), 4U);
}

TEST(OwlHostileTest, ClassesThatAreTheirOwnPartsAreClosed) {
  const Outcome outcome = Close(
      ":A owl:intersectionOf ( :A :A ) ; owl:complementOf :A ; owl:unionOf ( :A ) .\n"
      ":R owl:onProperty :R ; owl:someValuesFrom :R ; owl:allValuesFrom :R ; owl:hasValue :R ; "
      "owl:maxCardinality 1 .\n"
      ":R :R :R . :p owl:inverseOf :p ; rdfs:subPropertyOf :p ; owl:propertyChainAxiom ( :p :p ) "
      ".\n:x a :A , :R ; :p :x .");
  ASSERT_FALSE(outcome.error);
  EXPECT_GT(outcome.view.layers()[0]->clash_count(), 0U);
}

}  // namespace
}  // namespace lares::owl
