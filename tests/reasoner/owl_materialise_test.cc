// What the closure is beside its rules: layers, limits, contradictions, lists, literals.
#include "reasoner/owl/materialise.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TermOf;
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

// Between two values there is a literal whose value nobody knows: it joins neither, whichever comes
// first.
TEST_F(MaterialiseTest, AnIllTypedLiteralMakesNoTwoValuesOne) {
  const std::string schema = ":p a owl:FunctionalProperty . :b :q \"text\" . :c :q 1 . ";
  const std::vector<std::string> values = {":a :p \"x\"^^xsd:integer . ", ":a :p \"text\" . ",
                                           ":a :p 1 . "};
  for (const auto& order : {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}) {
    rdf::View view = Close(schema);
    for (const int i : order) view = Over(view, values[i]);
    EXPECT_FALSE(Has(view, ":b :q 1"));
    EXPECT_FALSE(Has(view, ":c :q \"text\""));
    EXPECT_FALSE(Has(view, ":b :q \"x\"^^xsd:integer"));
  }
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

TEST_F(MaterialiseTest, LiteralsAreNeverSubjectsAndDifferByTheirValues) {
  const rdf::View view = Close(
      ":p rdfs:range :C ; owl:inverseOf :q . :a :p 5 . "
      ":f a owl:FunctionalProperty . :a :f 1 , 2 , :b .");
  view.ForEach({}, [&](const rdf::Triple& triple) {
    EXPECT_NE(dictionary_->Kind(triple.subject), rdf::TermKind::kLiteral);
    return true;
  });
  EXPECT_TRUE(Has(view, ":b owl:sameAs 1"));
  ASSERT_FALSE(view.layers()[0]->clashes().empty());
  EXPECT_EQ(view.layers()[0]->clashes()[0].rule, "eq-diff1");
}

TEST_F(MaterialiseTest, LiteralsOfOneValueAreOneToEveryRule) {
  const rdf::View view = Close(
      ":k a owl:InverseFunctionalProperty . :a :k 1 . :b :k \"01\"^^xsd:int . "
      ":R owl:hasValue 2 ; owl:onProperty :p . :c :p \"2.0\"^^xsd:decimal . "
      ":e :g 4 , \"04\"^^xsd:int . :h :g 4 . "
      ":f a owl:FunctionalProperty . :d :f 3 , \"+3\"^^xsd:integer .");
  EXPECT_TRUE(Has(view, ":a owl:sameAs :b"));
  EXPECT_TRUE(Has(view, ":c a :R"));
  EXPECT_TRUE(view.layers()[0]->clashes().empty());
  EXPECT_FALSE(Has(view, ":h :g \"04\"^^xsd:int")) << "literals are answered as they were written";
}

TEST_F(MaterialiseTest, LiteralsAreOfTheirDatatypesAndOfNoOther) {
  EXPECT_TRUE(
      Has(Close(":R owl:someValuesFrom xsd:int ; owl:onProperty :p . :a :p 5 ."), ":a a :R"));
  EXPECT_TRUE(Has(Close("xsd:integer rdfs:subClassOf :N . :R owl:someValuesFrom :N ; "
                        "owl:onProperty :p . :a :p 5 ."),
                  ":a a :R"));
  const rdf::View below = Close(
      "xsd:integer rdfs:subClassOf :N . :R owl:someValuesFrom :N ; "
      "owl:onProperty :p . :a :p 5 .");
  EXPECT_TRUE(Has(Over(below, ":b :p 6 ."), ":b a :R"));
  EXPECT_TRUE(Has(Over(below, ":b :p 5 ."), ":b a :R"));
  const auto clash = [&](const char* text) {
    const rdf::View view = Close(text);
    const auto& clashes = view.layers()[0]->clashes();
    return clashes.empty() ? "" : clashes[0].rule;
  };
  EXPECT_EQ(clash(":p rdfs:range xsd:byte . :a :p 300 ."), "dt-not-type");
  EXPECT_EQ(clash(":p rdfs:range xsd:byte . :a :p 3 ."), "");
  EXPECT_EQ(clash(":a owl:sameAs 300 ; a xsd:byte ."), "dt-not-type");
  EXPECT_EQ(clash(":p rdfs:range xsd:byte . :a :p \"x\"^^:own ."), "") << "nothing is known of it";
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

// Lists of more than four members are not read as pairs.
struct LongList {
  const char* list;
  const char* harmless;
  const char* clash;
  const char* rule;
};

TEST_F(MaterialiseTest, AnyTwoMembersOfALongListClash) {
  const LongList lists[] = {
      {"a owl:AllDisjointClasses ; owl:members ( :C1 :C2 :C3 :C4 :C5 :C6 ) .",
       ":x a :C2 , :D . :y a :C6 .", ":x a :C6 .", "cax-adc"},
      {"a owl:AllDisjointProperties ; owl:members ( :p1 :p2 :p3 :p4 :p5 :p6 ) .",
       ":x :p2 :y , :z ; :p6 :w .", ":x :p6 :z .", "prp-adp"},
      {"a owl:AllDifferent ; owl:members ( :m1 :m2 :m3 :m4 :m5 :m6 ) .", ":m2 owl:sameAs :other .",
       ":other owl:sameAs :m6 .", "eq-diff2"},
      {"a owl:AllDifferent ; owl:distinctMembers ( :m1 :m2 :m3 :m4 :m5 :m6 ) .",
       ":m2 owl:sameAs :other .", ":other owl:sameAs :m6 .", "eq-diff3"},
      {"a owl:AllDisjointClasses ; owl:members ( :C1 :C2 :C3 :C4 :C5 :C2 ) .", ":x a :C1 .",
       ":x a :C2 .", "cax-adc"},
  };
  for (const LongList& each : lists) {
    const auto clashes = [&](const std::string& text) {
      const rdf::View view = Close(text);
      std::set<std::string> rules;
      for (const rdf::Clash& clash : view.layers()[0]->clashes()) rules.insert(clash.rule);
      return rules;
    };
    const std::string list = std::string("_:list ") + each.list + " ";
    const std::string facts = std::string(each.harmless) + " ";
    const std::set<std::string> expected = {each.rule};
    EXPECT_TRUE(clashes(list + facts).empty()) << each.list;
    EXPECT_EQ(clashes(list + facts + each.clash), expected) << each.list;
    // Whichever layer has what.
    for (const rdf::View& stack :
         {Over(Close(list + facts), each.clash), Over(Close(facts + each.clash), list)}) {
      const auto& found = stack.layers().back()->clashes();
      ASSERT_FALSE(found.empty()) << each.list;
      EXPECT_EQ(found[0].rule, each.rule);
    }
  }
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

TEST_F(MaterialiseTest, AThousandNamesOfOneThingStayCheap) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += ":n" + std::to_string(i) + " owl:sameAs :n" + std::to_string(i + 1) + " ; :p :v" +
            std::to_string(i) + " . ";
  }
  Options options;
  options.max_inferred = 4000;
  const rdf::View view = Close(text, options);
  EXPECT_LE(view.size(), 1000U);
  EXPECT_TRUE(Has(view, ":n0 :p :v999") && Has(view, ":n1000 :p :v0"));
  EXPECT_TRUE(Has(view, ":n7 owl:sameAs :n993"));
  EXPECT_EQ(view.Match({{}, TermOf(":p", *dictionary_), TermOf(":v3", *dictionary_)}).size(),
            1001U);
}

TEST_F(MaterialiseTest, AnOverlayMayMakeNamesOfTheCatalogueTheSame) {
  const rdf::View below = Close(":a :p :x . :b :q :y . :c owl:sameAs :d . :d :r :a .");
  const rdf::View view = Over(below, ":a owl:sameAs :b . :b owl:sameAs :c .");
  for (const char* each : {":a :q :y", ":c :p :x", ":d :q :y", ":a :r :d", ":d owl:sameAs :a"}) {
    EXPECT_TRUE(Has(view, each)) << each;
    EXPECT_FALSE(Has(below, each)) << each;
  }
  EXPECT_EQ(view.Match({{}, TermOf(":r", *dictionary_), {}}).size(), 16U);
}

TEST_F(MaterialiseTest, WordsOfOwlItselfAreNeverTheSame) {
  EXPECT_EQ(CodeOf("owl:sameAs owl:sameAs rdf:type .", {}), Code::kUnsupported);
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

}  // namespace
}  // namespace lares::owl
