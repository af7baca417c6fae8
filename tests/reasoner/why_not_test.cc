// What is missing, and that it would do.
#include "reasoner/owl/why_not.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/random_ontology.h"

namespace lares::owl {
namespace {

using lares::testing::Author;
using lares::testing::GraphOf;
using lares::testing::TripleOf;

rdf::View Closed(const std::string& text) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  return rdf::View(dictionary)
      .With(Materialise(rdf::View(dictionary), {GraphOf(text, *dictionary)}));
}

std::vector<std::string> Missing(const Lack& lack, const rdf::View& view) {
  std::vector<std::string> texts;
  for (const Atom& atom : lack.missing) texts.push_back(PhraseOf(atom, view));
  return texts;
}

constexpr char kContainers[] =
    ":Container owl:equivalentClass _:c . _:c owl:intersectionOf ( :Artifact _:r ) . "
    "_:r owl:onProperty :hasCavity . _:r owl:someValuesFrom :Cavity . "
    ":Bottle rdfs:subClassOf :Container . :cup1 a :Artifact . ";

TEST(WhyNotTest, TheNearestWayComesFirst) {
  const rdf::View view = Closed(std::string(kContainers) + ":cup1 :hasCavity :hollow .");
  const rdf::Triple goal = TripleOf(":cup1 a :Container", view.dictionary());
  const auto lacks = WhyNot(view, goal);
  ASSERT_GE(lacks.size(), 2U);
  EXPECT_EQ(Missing(lacks[0], view), std::vector<std::string>{"hollow a Cavity"});
  EXPECT_NE(ToText(goal, lacks, view).find("hollow a Cavity"), std::string::npos);
  const auto json = nlohmann::json::parse(ToJson(goal, lacks, view));
  EXPECT_EQ(json["goal"], "cup1 a Container");
  EXPECT_EQ(json["lacks"][0]["missing"][0]["triple"][0], "<http://example.org/hollow>");
  bool is_bottle = false;
  for (const Lack& lack : lacks) {
    is_bottle = is_bottle || Missing(lack, view) == std::vector<std::string>{"cup1 a Bottle"};
  }
  EXPECT_TRUE(is_bottle);
}

TEST(WhyNotTest, WhatIsNotThereAtAllIsSomething) {
  const rdf::View view = Closed(kContainers);
  const auto lacks = WhyNot(view, TripleOf(":cup1 a :Container", view.dictionary()));
  bool found = false;
  for (const Lack& lack : lacks) {
    if (lack.missing.size() != 2) continue;
    found = found || (lack.missing[0].object.is_variable && lack.missing[1].subject.is_variable &&
                      lack.missing[0].object.value == lack.missing[1].subject.value);
  }
  EXPECT_TRUE(found) << ToText(TripleOf(":cup1 a :Container", view.dictionary()), lacks, view);
}

TEST(WhyNotTest, NothingIsSaidWhereNothingWouldDo) {
  const rdf::View view = Closed(":cup1 a :Artifact .");
  const rdf::Triple goal = TripleOf(":cup1 a :Unheard", view.dictionary());
  EXPECT_TRUE(WhyNot(view, goal).empty());
  EXPECT_NE(ToText(goal, {}, view).find("nothing is known"), std::string::npos);
}

TEST(WhyNotTest, CirclesOfDefinitionsEnd) {
  const rdf::View view = Closed(
      ":A owl:intersectionOf ( :B :C ) . :B owl:intersectionOf ( :A :C ) . "
      ":C owl:unionOf ( :A :B ) . :x a :D .");
  WhyNot(view, TripleOf(":x a :A", view.dictionary()));
}

constexpr char kKitchen[] =
    ":Cup rdfs:subClassOf :DrinkingVessel . :DrinkingVessel rdfs:subClassOf :Vessel . "
    ":Vessel rdfs:subClassOf :Artifact . :Bottle rdfs:subClassOf :Container . "
    ":Container rdfs:subClassOf :Artifact . :Artifact rdfs:subClassOf :Object . "
    ":Vessel rdfs:subClassOf _:v . _:v owl:onProperty :has ; owl:someValuesFrom :Cavity . "
    ":Container owl:equivalentClass _:w . _:w owl:onProperty :holds ; owl:someValuesFrom :Object "
    ". ";

TEST(WhyNotTest, OfASubclassAnAxiomIsMissingAndTheNearestSuperclassIsTold) {
  const rdf::View view = Closed(kKitchen);
  const rdf::Triple goal = TripleOf(":Cup rdfs:subClassOf :Container", view.dictionary());
  const auto lacks = WhyNot(view, goal);
  ASSERT_EQ(lacks.size(), 2U);
  EXPECT_EQ(Missing(lacks[0], view), std::vector<std::string>{"Cup subClassOf Container"});
  EXPECT_EQ(Missing(lacks[1], view), std::vector<std::string>{"Vessel subClassOf Container"});
  EXPECT_EQ(ToText(goal, lacks, view),
            "'Cup subClassOf Container' does not hold; it would, if\n"
            "  Cup subClassOf Container\n"
            "    were said: no axiom leads there; what does hold: Cup subClassOf Artifact, "
            "Container subClassOf Artifact\n"
            "or\n"
            "  Vessel subClassOf Container\n"
            "    by scm-sco, given that Cup subClassOf Vessel\n");
}

TEST(WhyNotTest, TheOtherWayRoundIsTold) {
  const rdf::View view = Closed(kKitchen);
  const rdf::Triple goal = TripleOf(":Artifact rdfs:subClassOf :Cup", view.dictionary());
  const auto lacks = WhyNot(view, goal);
  ASSERT_EQ(lacks.size(), 1U);
  EXPECT_NE(ToText(goal, lacks, view).find("what does hold: Cup subClassOf Artifact"),
            std::string::npos);
}

TEST(WhyNotTest, OfClassesThatNothingJoinsOnlyTheAxiomIsMissing) {
  const rdf::View view = Closed(":A a owl:Class . :B a owl:Class . :p a owl:ObjectProperty .");
  for (const char* axiom : {":A rdfs:subClassOf :B", ":A owl:equivalentClass :B",
                            ":p rdfs:domain :A", ":p rdfs:subPropertyOf :q"}) {
    const rdf::Triple goal = TripleOf(axiom, view.dictionary());
    const auto lacks = WhyNot(view, goal);
    ASSERT_EQ(lacks.size(), 1U) << axiom;
    ASSERT_EQ(lacks[0].missing.size(), 1U);
    EXPECT_TRUE(lacks[0].held.empty()) << ToText(goal, lacks, view);
    EXPECT_TRUE(lacks[0].rules.empty());
  }
}

// Whatever is said to be missing, adding it makes the triple follow.
TEST(WhyNotTest, AddingWhatIsMissingMakesItFollow) {
  int ways = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Author author(seed);
    const std::string text = author.Text(16);
    const rdf::View view = Closed(text);
    for (const char* name :
         {":I0 a :C0", ":I1 a :C1", ":I2 a :C2", ":I0 :P0 :I1", ":C0 rdfs:subClassOf :C1"}) {
      const rdf::Triple goal = TripleOf(name, view.dictionary());
      if (view.Contains(goal)) continue;
      for (const Lack& lack : WhyNot(view, goal)) {
        rdf::Graph added{"added", {}, {}};
        for (const Atom& atom : lack.missing) {
          const auto term = [&](const Slot& slot) {
            return slot.is_variable ? view.dictionary().InternIri("http://example.org/new" +
                                                                  std::to_string(slot.value))
                                    : rdf::TermId{slot.value};
          };
          added.triples.push_back({term(atom.subject), term(atom.predicate), term(atom.object)});
        }
        const rdf::View more = view.With(Materialise(view, {added}));
        EXPECT_TRUE(more.Contains(goal))
            << "seed " << seed << ": " << ToText(goal, {lack}, view) << text;
        ++ways;
      }
    }
  }
  EXPECT_GT(ways, 100);
}

}  // namespace
}  // namespace lares::owl
