#include "reasoner/authority/authority.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "ontology/rdf/reader.h"
#include "reasoner/authority/structure.h"
#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"

namespace lares::authority {
namespace {

using lares::testing::GraphOf;
using lares::testing::TripleOf;

class StructureTest : public ::testing::Test {
 protected:
  // Whether what is known holds the first triple of `said` with a blank node in it.
  bool Holds(const std::string& known, const std::string& said) {
    const rdf::View empty(dictionary_);
    const rdf::View view = empty.With(
        std::make_shared<rdf::Layer>(std::vector{GraphOf(known, *dictionary_, "known")},
                                     std::vector<rdf::Triple>{}, std::vector<rdf::Clash>{}));
    const rdf::Graph graph = GraphOf(said, *dictionary_, "said");
    StructureMatch match(view, graph);
    return std::all_of(graph.triples.begin(), graph.triples.end(),
                       [&](const rdf::Triple& triple) { return match.Holds(triple); });
  }
  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
};

TEST_F(StructureTest, BlankNodesMatchByWhatIsSaidOfThem) {
  const std::string known =
      ":c :below _:r , _:s . _:r :on :p ; :some :d . _:s :on :q ; :some :e . ";
  EXPECT_TRUE(Holds(known, ":c :below _:x . _:x :some :e ; :on :q . "));
  EXPECT_FALSE(Holds(known, ":c :below _:x . _:x :some :d ; :on :q . ")) << "halves of two nodes";
}

TEST_F(StructureTest, AListMatchesItemByItemAndInOrder) {
  const std::string known = ":c :all ( :a _:r :b ) . _:r :on :p . ";
  EXPECT_TRUE(Holds(known, ":c :all ( :a _:z :b ) . _:z :on :p . "));
  EXPECT_FALSE(Holds(known, ":c :all ( :a :b _:z ) . _:z :on :p . "));
  EXPECT_FALSE(Holds(known, ":c :all ( :a _:z ) . _:z :on :p . "));
}

TEST_F(StructureTest, CirclesOfBlankNodesEnd) {
  EXPECT_TRUE(
      Holds("_:x :p _:y . _:y :p _:x . :c :q _:x . ", ":c :q _:a . _:a :p _:b . _:b :p _:a . "));
  EXPECT_FALSE(
      Holds("_:x :p _:y . _:y :p _:z . :c :q _:x . ", ":c :q _:a . _:a :p _:b . _:b :p _:a . "));
}

TEST_F(StructureTest, AStructureBuiltToExplodeIsNotFoundRatherThanSearchedForEver) {
  std::string known = ":c :q _:n0 . ";
  std::string said = ":c :q _:m0 . ";
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      known += "_:n" + std::to_string(i) + " :p _:n" + std::to_string(j) + " . ";
    }
    said += "_:m" + std::to_string(i) + " :p _:m" + std::to_string(i + 1) + " . ";
  }
  said += "_:m30 :p :nowhere . ";
  EXPECT_FALSE(Holds(known, said));
}

// The principle: with what is allowed, data in the terms of others has the same consequences in
// their terms as without.
TEST(AuthorityPropertyTest, WhatIsAllowedAddsNothingToDataInTheTermsOfOthers) {
  std::mt19937 random(11);
  const auto pick = [&](int count) { return static_cast<int>(random() % count); };
  const std::vector<std::string> theirs = {":T0", ":T1", ":T2", ":T3"};
  const std::vector<std::string> mine = {":M0", ":M1", ":M2"};
  const auto any = [&] { return pick(2) == 0 ? theirs[pick(4)] : mine[pick(3)]; };
  int allowed = 0;
  int refused = 0;
  for (int round = 0; round < 1500; ++round) {
    auto dictionary = std::make_shared<rdf::Dictionary>();
    std::string base;
    for (const std::string& term : theirs) base += term + " a owl:Class . ";
    base += ":T0 rdfs:subClassOf :T1 . ";
    std::string document;
    for (int i = 0; i < 3; ++i) {
      const std::string both = "_:both" + std::to_string(i);
      const std::string meaning = both + " owl:intersectionOf ( " + any() + " " + any() + " ) . ";
      switch (pick(5)) {
        case 0:
          document += any() + " rdfs:subClassOf " + any() + " . ";
          break;
        case 1:
          document += mine[pick(3)] + " owl:equivalentClass " + both + " . " + meaning;
          break;
        case 2:
          document += any() + " owl:disjointWith " + any() + " . ";
          break;
        case 3:
          document += both + " rdfs:subClassOf " + any() + " . " + meaning;
          break;
        default:
          document += any() + " owl:equivalentClass " + any() + " . ";
          break;
      }
    }
    const rdf::Graph schema = GraphOf(base, *dictionary, "theirs");
    const rdf::View empty(dictionary);
    const rdf::View known = empty.With(owl::Materialise(empty, {schema}));
    Owners owners;
    owners.Add(MakeSharedClaim(schema, "http://nowhere", *dictionary));
    const rdf::Graph graph = GraphOf(document, *dictionary, "mine");
    if (!FindTrespasses(known, graph, owners).empty()) {
      ++refused;
      continue;
    }
    ++allowed;
    const rdf::Graph facts = GraphOf(
        ":x a :T0 , :T2 . :y a :T0 , :T1 , :T2 , :T3 . :z a :T1 , :T3 . ", *dictionary, "data");
    const rdf::View without = known.With(owl::Materialise(known, {facts}));
    const rdf::View with = known.With(owl::Materialise(known, {graph, facts}));
    EXPECT_EQ(with.layers().back()->clash_count(), 0U) << document;
    if (HasFailure()) return;
    for (const char* thing : {":x", ":y", ":z"}) {
      for (const std::string& term : theirs) {
        const rdf::Triple triple = TripleOf(thing + std::string(" a ") + term, *dictionary);
        EXPECT_EQ(with.Contains(triple), without.Contains(triple)) << document << thing << term;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(allowed, 200);
  EXPECT_GT(refused, 200);
}

TEST(AuthorityTest, ADeepExpressionAndACircularListEnd) {
  rdf::Dictionary dictionary;
  const rdf::View empty(std::shared_ptr<rdf::Dictionary>(&dictionary, [](auto*) {}));
  std::string text = "_:l rdf:first :a ; rdf:rest _:l . :u owl:unionOf _:l . ";
  for (int i = 0; i < 200; ++i) {
    text +=
        "_:e" + std::to_string(i) + " owl:intersectionOf ( _:e" + std::to_string(i + 1) + " ) . ";
  }
  text += "_:e0 rdfs:subClassOf :a . ";
  Owners owners;
  owners.Add(MakeSharedClaim(GraphOf(":a a owl:Class . ", dictionary, "theirs"), "http://nowhere",
                             dictionary));
  EXPECT_NO_THROW(FindTrespasses(empty, GraphOf(text, dictionary, "mine"), owners));
}

}  // namespace
}  // namespace lares::authority
