// What rules see of the view they were given.
#include <algorithm>

#include "base/error.h"
#include "reasoner/prolog/rdf_predicates.h"
#include "tests/reasoner/prolog_fixture.h"

namespace lares::prolog::testing {
namespace {

using PrologRdfView = PrologTest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

constexpr const char* kInteger = "http://www.w3.org/2001/XMLSchema#integer";

Value Literal(const std::string& lexical, const std::string& datatype = "",
              const std::string& language = "") {
  return C("literal", {A(lexical), A(datatype), A(language)});
}

// Two documents and one inferred triple.
rdf::View SmallWorld() {
  const rdf::View room = With(EmptyView(), "room",
                              {{Named("cup"), Named("in"), Named("kitchen")},
                               {Named("cup"), Named("size"), rdf::Term::Literal("5", kInteger)},
                               {Named("cup"), Named("name"), rdf::Term::Literal("Tasse", "", "de")},
                               {Named("loop"), Named("in"), Named("loop")}},
                              {{Named("cup"), Named("in"), Named("house")}});
  return With(room, "more",
              {{Named("plate"), Named("in"), Named("kitchen")},
               {rdf::Term::Blank("b1"), Named("in"), Named("kitchen")}});
}

TEST_F(PrologRdfView, RdfAnswersEveryTripleOfEveryLayerOnce) {
  EXPECT_THAT(All("subjects", {Iri("in"), Iri("kitchen")}, SmallWorld()),
              UnorderedElementsAre(Iri("cup"), Iri("plate"), A("_:b1")));
  EXPECT_EQ(Once("sum_of_triples", {}, SmallWorld()), I(7));
}

TEST_F(PrologRdfView, TermsAreAtomsAndLiteralsOfThreeAtoms) {
  EXPECT_THAT(All("asserted", {Iri("cup")}, SmallWorld()),
              UnorderedElementsAre(C("t", {Iri("in"), Iri("kitchen")}),
                                   C("t", {Iri("size"), Literal("5", kInteger)}),
                                   C("t", {Iri("name"), Literal("Tasse", "", "de")})));
}

TEST_F(PrologRdfView, BoundArgumentsOfEveryKindAreLookedUp) {
  EXPECT_THAT(All("subjects", {Iri("size"), Literal("5", kInteger)}, SmallWorld()),
              ElementsAre(Iri("cup")));
  EXPECT_THAT(All("subjects", {Iri("size"), Literal("5")}, SmallWorld()), IsEmpty());
  EXPECT_THAT(All("subjects", {Iri("in"), A("_:b1")}, SmallWorld()), IsEmpty());
  EXPECT_THAT(All("asserted", {A("_:b1")}, SmallWorld()), SizeIs(1));
  EXPECT_THAT(All("asserted", {Iri("unheard-of")}, SmallWorld()), IsEmpty());
}

TEST_F(PrologRdfView, ALiteralMayBeKnownInPart) {
  EXPECT_THAT(All("literal_with", {A("any"), A("any"), A("de")}, SmallWorld()),
              ElementsAre(C("t", {A("Tasse"), A(""), A("de")})));
  EXPECT_THAT(All("literal_with", {A("5"), A("any"), A("any")}, SmallWorld()),
              ElementsAre(C("t", {A("5"), A(kInteger), A("")})));
  EXPECT_THAT(All("literal_with", {S("5"), A("any"), A("any")}, SmallWorld()), SizeIs(1));
  EXPECT_THAT(All("literal_with", {S("6"), A("any"), A("any")}, SmallWorld()), IsEmpty());
}

TEST_F(PrologRdfView, OneVariableTwiceMustBeOneTerm) {
  EXPECT_THAT(All("same_both_ends", {}, SmallWorld()), ElementsAre(Iri("loop")));
}

TEST_F(PrologRdfView, LiteralSubjectsMatchNothing) {
  EXPECT_THAT(All("raw", {Literal("5", kInteger)}, SmallWorld()), IsEmpty());
}

TEST_F(PrologRdfView, WhatIsNoTermRaisesATypeError) {
  for (const Value& wrong : {I(123), S("http://x/cup"), C(":", {A("lares"), A("Cup")}),
                             Value{List{}}, C("literal", {I(5), A(""), A("")})}) {
    const Error error = ErrorOf("raw", {wrong}, SmallWorld());
    EXPECT_EQ(error.code(), Code::kInternal);
    EXPECT_THAT(error.what(), HasSubstr("Type error"));
  }
}

TEST_F(PrologRdfView, AssertedLeavesOutWhatFollows) {
  EXPECT_THAT(All("asserted", {Iri("cup")}, SmallWorld()), SizeIs(3));
  EXPECT_THAT(All("subjects", {Iri("in"), Iri("house")}, SmallWorld()), ElementsAre(Iri("cup")));
}

TEST_F(PrologRdfView, AGraphAnswersOnlyWhatItStates) {
  EXPECT_THAT(All("in_graph", {A("more"), A("any")}, SmallWorld()), SizeIs(2));
  EXPECT_THAT(All("in_graph", {A("room"), Iri("cup")}, SmallWorld()), SizeIs(3));
  EXPECT_THAT(All("in_graph", {A("room"), Iri("plate")}, SmallWorld()), IsEmpty());
  EXPECT_THAT(All("in_graph", {A("nowhere"), A("any")}, SmallWorld()), IsEmpty());
  EXPECT_EQ(Once("graphs", {}, SmallWorld()), (Value{List{A("room"), A("more")}}));
}

TEST_F(PrologRdfView, AnEmptyViewHasNoAnswers) {
  EXPECT_EQ(Once("sum_of_triples", {}), I(0));
  EXPECT_EQ(Once("graphs", {}), Value{List{}});
}

TEST_F(PrologRdfView, NumbersAreReadAsXmlSchemaWritesThem) {
  const std::vector<std::pair<std::string, Value>> numbers = {
      {"5", I(5)},       {"-5", I(-5)},
      {"+5", I(5)},      {" 7\n", I(7)},
      {"5.0", {5.0}},    {".5", {0.5}},
      {"5.", {5.0}},     {"1E3", {1000.0}},
      {"1e-3", {0.001}}, {"99999999999999999999", {1e20}}};
  for (const auto& [text, number] : numbers) {
    EXPECT_EQ(Once("number_of", {Literal(text)}), number) << text;
  }
  for (const char* text : {"", "abc", "0x10", "0'a", "1r3", "5 6", "INF", "-INF", "NaN", "inf",
                           "+-5", "++5", "1_000", "1e999", "--5"}) {
    EXPECT_EQ(Once("number_of", {Literal(text)}), std::nullopt) << text;
  }
  EXPECT_EQ(Once("number_of", {Iri("cup")}), std::nullopt);
  EXPECT_THAT(ErrorOf("number_of", {I(5)}).what(), HasSubstr("Type error"));
}

TEST_F(PrologRdfView, LabelsAndOriginalNames) {
  rdf::View view = EmptyView();
  rdf::Dictionary& dictionary = view.dictionary();
  const auto label = rdf::Term::Iri("http://www.w3.org/2000/01/rdf-schema#label");
  rdf::Graph graph{
      "g", ToTriples(dictionary, {{Named("cup"), label, rdf::Term::Literal("mug")}}), {}};
  graph.as_written[dictionary.InternIri("http://x/cup")] = dictionary.InternIri("http://old/Cup");
  view = view.With(std::make_shared<const rdf::Layer>(
      std::vector{graph}, std::vector<rdf::Triple>{}, std::vector<rdf::Clash>{}));
  EXPECT_EQ(Once("label_of", {Iri("cup")}, view), A("mug"));
  EXPECT_EQ(Once("label_of", {A("http://x#Saucer")}, view), A("Saucer"));
  EXPECT_EQ(Once("label_of", {Literal("some text")}, view), A("some text"));
  EXPECT_EQ(Once("written_of", {Iri("cup")}, view), A("http://old/Cup"));
  EXPECT_EQ(Once("written_of", {Iri("saucer")}, view), Iri("saucer"));
  EXPECT_THAT(ErrorOf("label_of", {I(5)}).what(), HasSubstr("Type error"));
}

TEST_F(PrologRdfView, PrefixesAreExpandedWhenARuleIsCompiled) {
  EXPECT_EQ(Once("same_term", {}), A("http://www.w3.org/2000/01/rdf-schema#subClassOf"));
}

// ---- Choice points -----------------------------------------------------------------------------

// How many besides the test itself hold the only layer.
long Holders(const rdf::View& view) { return view.layers().front().use_count() - 1; }

TEST_F(PrologRdfView, ACutGivesTheViewBack) {
  const rdf::View view = Numbered(10);
  EXPECT_TRUE(Once("first_triple", {}, view));
  EXPECT_EQ(LiveChoicePoints(), 0);
  EXPECT_EQ(Holders(view), 0);
}

TEST_F(PrologRdfView, AnExceptionGivesTheViewBack) {
  const rdf::View view = Numbered(10);
  ErrorOf("throw_after_triple", {}, view);
  EXPECT_EQ(LiveChoicePoints(), 0);
  EXPECT_EQ(Holders(view), 0);
}

TEST_F(PrologRdfView, PartialIterationGivesTheViewBack) {
  const rdf::View view = Numbered(10);
  EXPECT_EQ(Once("partial", {I(3)}, view)->list().size(), 3u);
  EXPECT_TRUE(Once("triple", {C("t", {Iri("n1"), Iri("p"), Iri("m1")})}, view));
  EXPECT_TRUE(Once("subjects", {Iri("p"), Iri("m1")}, view));
  EXPECT_THROW(
      All("triple", {C("t", {Iri("n1"), Iri("p"), Iri("m1")})}, view, Limits{.max_answers = 0}),
      Error);
  EXPECT_EQ(LiveChoicePoints(), 0);
  EXPECT_EQ(Holders(view), 0);
}

TEST_F(PrologRdfView, ATimeLimitGivesTheViewBack) {
  const rdf::View view = Numbered(10);
  const Error error =
      ErrorOf("loop_over_triples", {}, view, Limits{.time = std::chrono::milliseconds(50)});
  EXPECT_EQ(error.code(), Code::kTimeout);
  EXPECT_EQ(LiveChoicePoints(), 0);
  EXPECT_EQ(Holders(view), 0);
}

TEST_F(PrologRdfView, TheViewOfOneGoalIsNotTheNextOnes) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(Once("sum_of_triples", {}, Numbered(i)), I(i));
  }
}

TEST_F(PrologRdfView, ManyDictionariesComeAndGo) {
  for (int i = 0; i < 50; ++i) {
    const rdf::View view =
        With(EmptyView(), "g", {{Named("only" + std::to_string(i)), Named("p"), Named("o")}});
    EXPECT_EQ(Once("first_triple", {}, view), Iri("only" + std::to_string(i)));
  }
}

}  // namespace
}  // namespace lares::prolog::testing
