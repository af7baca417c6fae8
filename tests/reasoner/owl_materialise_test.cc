// What the closure is beside its rules: layers, limits, contradictions, lists, literals.
#include "reasoner/owl/materialise.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TripleOf;

class MaterialiseTest : public ::testing::Test {
 protected:
  rdf::View Over(const rdf::View& below, const std::string& text, const Options& options = {}) {
    const std::string name = "g" + std::to_string(below.layers().size());
    return below.With(Materialise(below, {GraphOf(text, *dictionary_, name)}, options));
  }
  rdf::View Close(const std::string& text, const Options& options = {}) {
    return Over(rdf::View(dictionary_), text, options);
  }
  bool Has(const rdf::View& view, std::string_view triple) {
    return view.Contains(TripleOf(triple, *dictionary_));
  }
  Code CodeOf(const std::string& text, const Options& options, std::stop_token stop = {}) {
    try {
      Materialise(rdf::View(dictionary_), {GraphOf(text, *dictionary_)}, options, stop);
    } catch (const Error& error) {
      return error.code();
    }
    ADD_FAILURE() << "no error";
    return Code::kInternal;
  }
  // A ring, whose closure has n² pairs.
  static std::string Ring(int n) {
    std::string text = ":p a owl:TransitiveProperty . ";
    for (int i = 0; i < n; ++i) {
      text += ":n" + std::to_string(i) + " :p :n" + std::to_string((i + 1) % n) + " . ";
    }
    return text;
  }

  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
};

TEST_F(MaterialiseTest, NothingFollowsFromNothing) {
  const rdf::View view = Close("");
  EXPECT_EQ(view.size(), 0U);
  EXPECT_EQ(Over(view, "").size(), 0U);
}

TEST_F(MaterialiseTest, TheLayerBelowIsNotRepeated) {
  const rdf::View below = Close(":C rdfs:subClassOf :D . :D rdfs:subClassOf :E . :a a :C .");
  const rdf::View view = Over(below, ":C rdfs:subClassOf :E . :b a :D . :a a :C .");
  EXPECT_EQ(view.layers()[1]->size(), 2U);  // :b a :D, :b a :E
  EXPECT_EQ(view.layers()[1]->asserted_size(), 3U);
  EXPECT_TRUE(view.IsAsserted(TripleOf(":C rdfs:subClassOf :E", *dictionary_)));
  EXPECT_FALSE(below.IsAsserted(TripleOf(":C rdfs:subClassOf :E", *dictionary_)));
}

TEST_F(MaterialiseTest, TwoOverlaysOfOneCatalogueDoNotMeet) {
  const rdf::View catalogue = Close(":p a owl:FunctionalProperty .");
  const rdf::View one = Over(catalogue, ":room :p :a .");
  const rdf::View two = Over(catalogue, ":room :p :b .");
  EXPECT_FALSE(Has(one, ":a owl:sameAs :b"));
  EXPECT_FALSE(Has(two, ":a owl:sameAs :b"));
  EXPECT_TRUE(Has(Over(one, ":room :p :b ."), ":a owl:sameAs :b"));
}

TEST_F(MaterialiseTest, NewSchemaIsAppliedToOldData) {
  const rdf::View below = Close(":a :p :b . :b :p :c . :c a :C .");
  EXPECT_TRUE(Has(Over(below, ":p a owl:TransitiveProperty ."), ":a :p :c"));
  EXPECT_TRUE(Has(Over(below, ":p owl:inverseOf :q ."), ":b :q :a"));
  EXPECT_TRUE(Has(Over(below, ":R owl:onProperty :p ; owl:someValuesFrom :C ."), ":b a :R"));
}

TEST_F(MaterialiseTest, AListMayGrowInALaterLayer) {
  const rdf::View below = Close(":U owl:unionOf :l . :l rdf:first :C . :l rdf:rest :m . :a a :D .");
  EXPECT_FALSE(Has(below, ":C rdfs:subClassOf :U"));  // no list yet
  const rdf::View view = Over(below, ":m rdf:first :D ; rdf:rest rdf:nil . :b a :C .");
  EXPECT_TRUE(Has(view, ":a a :U"));
  EXPECT_TRUE(Has(view, ":b a :U"));
}

TEST_F(MaterialiseTest, CircularAndBrokenListsAreNoLists) {
  const rdf::View view = Close(
      ":U owl:unionOf :l . :l rdf:first :C ; rdf:rest :l . :a a :C . "
      ":V owl:intersectionOf :m . :m rdf:first :C . "
      ":W owl:intersectionOf rdf:nil .");
  EXPECT_FALSE(Has(view, ":a a :U"));
  EXPECT_FALSE(Has(view, ":a a :V"));
  EXPECT_FALSE(Has(view, ":a a :W"));
}

TEST_F(MaterialiseTest, LongListsAreReadWhole) {
  std::string members;
  std::string types = ":a a ";
  for (int i = 0; i < 300; ++i) {
    members += ":C" + std::to_string(i) + " ";
    types += std::string(i == 0 ? "" : ", ") + ":C" + std::to_string(i) + " ";
  }
  const rdf::View view =
      Close(":I owl:intersectionOf ( " + members + ") . " + types + ". :b a :I .");
  EXPECT_TRUE(Has(view, ":a a :I"));
  EXPECT_TRUE(Has(view, ":b a :C299"));
}

TEST_F(MaterialiseTest, TrivialTriplesAreKeptOnlyWhenAsserted) {
  const rdf::View view = Close(
      ":C rdfs:subClassOf :D , owl:Thing . :D rdfs:subClassOf :C . :a owl:sameAs :b . :x a :C . "
      ":E rdfs:subClassOf :E .");
  EXPECT_FALSE(Has(view, ":C rdfs:subClassOf :C"));
  EXPECT_FALSE(Has(view, ":a owl:sameAs :a"));
  EXPECT_FALSE(Has(view, ":x a owl:Thing"));
  EXPECT_TRUE(Has(view, ":C rdfs:subClassOf owl:Thing"));
  EXPECT_TRUE(Has(view, ":E rdfs:subClassOf :E"));
}

TEST_F(MaterialiseTest, LiteralsAreNeitherSubjectsNorEqual) {
  const rdf::View view = Close(
      ":p rdfs:range :C ; owl:inverseOf :q . :a :p 5 . "
      ":f a owl:FunctionalProperty . :a :f 1 , 2 , :b .");
  view.ForEach({}, [&](const rdf::Triple& triple) {
    EXPECT_NE(dictionary_->Kind(triple.subject), rdf::TermKind::kLiteral);
    return true;
  });
  EXPECT_FALSE(Has(view, ":b owl:sameAs 1"));
}

TEST_F(MaterialiseTest, AClashNamesItsRuleAndPremises) {
  const rdf::View below = Close(":C owl:disjointWith :D . :E rdfs:subClassOf :D .");
  const rdf::View view = Over(below, ":a a :C , :E .");
  EXPECT_TRUE(below.layers()[0]->clashes().empty());
  const auto& clashes = view.layers()[1]->clashes();
  ASSERT_EQ(clashes.size(), 1U);
  EXPECT_EQ(clashes[0].rule, "cax-dw");
  const std::set<rdf::Triple> premises(clashes[0].premises.begin(), clashes[0].premises.end());
  EXPECT_EQ(premises, (std::set<rdf::Triple>{TripleOf(":C owl:disjointWith :D", *dictionary_),
                                             TripleOf(":a a :C", *dictionary_),
                                             TripleOf(":a a :D", *dictionary_)}));
}

TEST_F(MaterialiseTest, ClashesBeyondTheLimitAreCounted) {
  std::string text = ":C owl:disjointWith :D . ";
  for (int i = 0; i < 20; ++i) text += ":i" + std::to_string(i) + " a :C , :D . ";
  Options options;
  options.max_clashes = 3;
  const rdf::View view = Close(text, options);
  EXPECT_EQ(view.layers()[0]->clashes().size(), 3U);
  EXPECT_EQ(view.layers()[0]->clash_count(), 20U);
}

TEST_F(MaterialiseTest, ARingClosesIntoAllPairs) {
  const rdf::View view = Close(Ring(40) + ":p owl:inverseOf :q . :q a owl:TransitiveProperty .");
  EXPECT_EQ(view.Estimate({{}, lares::testing::TermOf(":p", *dictionary_), {}}), 1600U);
  EXPECT_EQ(view.Estimate({{}, lares::testing::TermOf(":q", *dictionary_), {}}), 1600U);
}

TEST_F(MaterialiseTest, TooManyInferencesAreAnError) {
  Options options;
  options.max_inferred = 1000;
  EXPECT_EQ(CodeOf(Ring(40), options), Code::kTooLarge);
  options.max_inferred = 1600;
  EXPECT_EQ(Close(Ring(40), options).size(), 1601U);
}

TEST_F(MaterialiseTest, SameAsBlowUpMeetsTheLimitToo) {
  std::string text;
  for (int i = 0; i < 60; ++i) {
    text += ":n" + std::to_string(i) + " owl:sameAs :n" + std::to_string(i + 1) + " ; :p :v" +
            std::to_string(i) + " . ";
  }
  Options options;
  options.max_inferred = 2000;
  EXPECT_EQ(CodeOf(text, options), Code::kTooLarge);
}

TEST_F(MaterialiseTest, AStopRequestEndsIt) {
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(CodeOf(Ring(200), {}, source.get_token()), Code::kTimeout);
}

TEST_F(MaterialiseTest, ReadersAndAnotherClosureMayRunBesideIt) {
  const rdf::View below = Close(Ring(10));
  std::vector<std::thread> threads;
  std::vector<std::size_t> sizes(3);
  for (std::size_t t = 0; t < sizes.size(); ++t) {
    threads.emplace_back(
        [&, t] { sizes[t] = Over(below, ":x" + std::to_string(t) + " :p :n0 .").size(); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(sizes, std::vector<std::size_t>(3, below.size() + 10));
}

TEST_F(MaterialiseTest, DerivationsTellRuleAndPremises) {
  std::vector<std::string> rules;
  Options options;
  options.on_derivation = [&](const Derivation& derivation) {
    rules.emplace_back(derivation.rule);
    EXPECT_EQ(derivation.premises.size(), 2U);
  };
  Close(":C rdfs:subClassOf :D . :a a :C .", options);
  EXPECT_EQ(rules, std::vector<std::string>{"cax-sco"});
}

}  // namespace
}  // namespace lares::owl
