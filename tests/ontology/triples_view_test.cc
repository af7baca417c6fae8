#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "ontology/triples/cursor.h"
#include "ontology/triples/sorting.h"
#include "ontology/triples/view.h"
#include "tests/ontology/test_graph.h"

namespace lares::rdf {
namespace {

using lares::testing::GraphOf;
using lares::testing::TermOf;
using lares::testing::TripleOf;

Triple RandomTriple(std::mt19937& random, std::uint32_t terms) {
  const auto term = [&] { return TermId{1 + static_cast<std::uint32_t>(random() % terms)}; };
  return {term(), term(), term()};
}

bool Matches(const Pattern& pattern, const Triple& triple) {
  const auto fits = [](TermId wanted, TermId found) {
    return wanted == kAnyTerm || wanted == found;
  };
  return fits(pattern.subject, triple.subject) && fits(pattern.predicate, triple.predicate) &&
         fits(pattern.object, triple.object);
}

// Every pattern shape over a random layer answers what a scan answers. The larger size passes the
// limit from which sorting is by counting.
TEST(LayerTest, EveryPatternAnswersWhatAScanFinds) {
  for (const std::size_t size : {0U, 1U, 60U, 9000U}) {
    std::mt19937 random(static_cast<unsigned>(size));
    std::set<Triple> asserted;
    std::set<Triple> all;
    const std::uint32_t terms = size > 1000 ? 40 : 6;
    for (std::size_t i = 0; i < size; ++i) {
      const Triple triple = RandomTriple(random, terms);
      all.insert(triple);
      if (i % 2 == 0) asserted.insert(triple);
    }
    std::vector<Triple> inferred;
    std::set_difference(all.begin(), all.end(), asserted.begin(), asserted.end(),
                        std::back_inserter(inferred));
    const Layer layer({{"g", {asserted.begin(), asserted.end()}, {}}}, inferred, {});
    EXPECT_EQ(layer.size(), all.size());
    EXPECT_EQ(layer.asserted_size(), asserted.size());
    for (int round = 0; round < 200; ++round) {
      Pattern pattern;
      const Triple triple = RandomTriple(random, terms + 1);
      if ((round & 1) != 0) pattern.subject = triple.subject;
      if ((round & 2) != 0) pattern.predicate = triple.predicate;
      if ((round & 4) != 0) pattern.object = triple.object;
      const auto run = layer.Range(pattern);
      std::vector<Triple> found(run.begin(), run.end());
      std::sort(found.begin(), found.end());
      std::vector<Triple> expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [&](const Triple& each) { return Matches(pattern, each); });
      ASSERT_EQ(found, expected);
      EXPECT_EQ(layer.Contains(triple), all.contains(triple));
      EXPECT_EQ(layer.IsAsserted(triple), asserted.contains(triple));
    }
  }
}

TEST(LayerTest, CountingSortKeepsTheOrderOfEqualComponents) {
  std::mt19937 random(7);
  std::vector<Triple> triples(10'000);
  for (Triple& triple : triples) triple = RandomTriple(random, 1U << 23);
  std::vector<Triple> expected = triples;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const Triple& a, const Triple& b) { return a.object < b.object; });
  StableSortBy(Component::kObject, triples);
  EXPECT_EQ(triples, expected);
}

class ViewTest : public ::testing::Test {
 protected:
  std::shared_ptr<const Layer> LayerOf(std::string_view text, std::string_view name,
                                       std::string_view inferred = "") {
    return std::make_shared<Layer>(std::vector<Graph>{GraphOf(text, *dictionary_, name)},
                                   GraphOf(inferred, *dictionary_, "i").triples,
                                   std::vector<Clash>{});
  }
  Triple T(std::string_view triple) { return TripleOf(triple, *dictionary_); }
  TermId Id(std::string_view term) { return TermOf(term, *dictionary_); }

  std::shared_ptr<Dictionary> dictionary_ = std::make_shared<Dictionary>();
};

TEST_F(ViewTest, LayersAnswerTogetherAndEachAlone) {
  const View below = View(dictionary_).With(LayerOf(":a :p :b .", "one"));
  const View both = below.With(LayerOf(":a :p :c . :d :q :b .", "two", ":a :p :d ."));
  EXPECT_EQ(both.size(), 4U);
  EXPECT_EQ(below.size(), 1U);
  EXPECT_EQ(both.Objects(Id(":a"), Id(":p")).size(), 3U);
  EXPECT_EQ(both.Subjects(Id(":q"), Id(":b")), std::vector<TermId>{Id(":d")});
  EXPECT_EQ(both.Estimate({Id(":a"), {}, {}}), 3U);
  EXPECT_FALSE(below.Contains(T(":a :p :c")));
}

TEST_F(ViewTest, InferredTriplesAreNotAsserted) {
  const View view = View(dictionary_).With(LayerOf(":a :p :b .", "one", ":b :p :a ."));
  EXPECT_TRUE(view.Contains(T(":b :p :a")));
  EXPECT_FALSE(view.IsAsserted(T(":b :p :a")));
  EXPECT_EQ(view.Match({}, Origin::kAsserted), std::vector<Triple>{T(":a :p :b")});
  EXPECT_TRUE(view.GraphsOf(T(":b :p :a")).empty());
}

TEST_F(ViewTest, WhatALayerAssertsOfWhatWasInferredBelowIsAssertedOnce) {
  const View below = View(dictionary_).With(LayerOf(":a :p :b .", "one", ":b :p :a ."));
  Inference inference;
  inference.held_below = {T(":b :p :a")};
  const View view = below.With(std::make_shared<Layer>(
      std::vector<Graph>{GraphOf(":b :p :a . :c :p :c .", *dictionary_, "two")}, inference));
  EXPECT_EQ(view.Match({Id(":b"), {}, {}}).size(), 1U);
  EXPECT_TRUE(view.IsAsserted(T(":b :p :a")));
  EXPECT_FALSE(below.IsAsserted(T(":b :p :a")));
  EXPECT_EQ(view.Match({Id(":b"), {}, {}}, Origin::kAsserted).size(), 1U);
  EXPECT_EQ(view.GraphsOf(T(":b :p :a")), std::vector<std::string>{"two"});
}

TEST_F(ViewTest, GraphsOfNamesEveryDocumentThatSaysSo) {
  std::vector<Graph> graphs = {GraphOf(":a :p :b .", *dictionary_, "x"),
                               GraphOf(":a :p :b . :c :p :d .", *dictionary_, "y")};
  const View view =
      View(dictionary_)
          .With(std::make_shared<Layer>(graphs, std::vector<Triple>{}, std::vector<Clash>{}));
  EXPECT_EQ(view.GraphsOf(T(":a :p :b")), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(view.GraphsOf(T(":c :p :d")), std::vector<std::string>{"y"});
  EXPECT_EQ(view.layers()[0]->asserted_size(), 2U);
}

TEST_F(ViewTest, VisitStopsWhenToldTo) {
  const View view = View(dictionary_).With(LayerOf(":a :p :b , :c , :d .", "one"));
  int seen = 0;
  EXPECT_FALSE(view.ForEach({Id(":a"), {}, {}}, [&](const Triple&) { return ++seen < 2; }));
  EXPECT_EQ(seen, 2);
}

TEST_F(ViewTest, CursorGivesTheSameAnswersAndPinsItsView) {
  std::weak_ptr<const Layer> layer;
  {
    std::optional<Cursor> cursor;
    {
      auto top = LayerOf(":a :p :e .", "two", ":a :p :f .");
      layer = top;
      const View view =
          View(dictionary_).With(LayerOf(":a :p :b , :c .", "one")).With(std::move(top));
      cursor.emplace(std::make_shared<const View>(view), Pattern{Id(":a"), Id(":p"), {}},
                     Origin::kAsserted);
    }
    std::set<Triple> found;
    Triple triple;
    while (cursor->Next(&triple)) found.insert(triple);
    EXPECT_EQ(found, (std::set<Triple>{T(":a :p :b"), T(":a :p :c"), T(":a :p :e")}));
    EXPECT_FALSE(cursor->Next(&triple));
    EXPECT_FALSE(layer.expired());
  }
  EXPECT_TRUE(layer.expired());
}

TEST_F(ViewTest, LabelPrefersNoTagThenEnglishThenAnyThenTheName) {
  const View view = View(dictionary_)
                        .With(LayerOf(":a rdfs:label \"Tasse\"@de , \"cup\"@en , \"Cup\" . "
                                      ":b rdfs:label \"Tasse\"@de , \"cup\"@en . "
                                      ":c rdfs:label \"Tasse\"@de . "
                                      ":d :p \"7\" .",
                                      "one"));
  EXPECT_EQ(view.Label(Id(":a")), "Cup");
  EXPECT_EQ(view.Label(Id(":b")), "cup");
  EXPECT_EQ(view.Label(Id(":c")), "Tasse");
  EXPECT_EQ(view.Label(Id(":d")), "d");
  EXPECT_EQ(view.Label(Id("\"7\"")), "7");
}

TEST_F(ViewTest, IrisAreShownAsTheTopmostDocumentWroteThem) {
  const AliasTable aliases({{"http://old/", "http://new/", "renamed", false}});
  const auto layer = [&](std::string_view text, std::string_view name) {
    return std::make_shared<Layer>(
        std::vector<Graph>{MakeGraph(lares::testing::ParseText(text), name, aliases, *dictionary_)},
        std::vector<Triple>{}, std::vector<Clash>{});
  };
  const View old = View(dictionary_).With(layer("<http://old/a> :p <http://old/b> .", "one"));
  const TermId a = Id("<http://new/a>");
  EXPECT_EQ(old.AsWritten(a), "http://old/a");
  EXPECT_EQ(old.With(layer(":x :p :y .", "two")).AsWritten(a), "http://old/a");
  EXPECT_EQ(old.With(layer(":x :p <http://new/a> .", "two")).AsWritten(a), "http://new/a");
  EXPECT_EQ(old.AsWritten(Id(":p")), "http://example.org/p");
}

}  // namespace
}  // namespace lares::rdf
