// What is written is read back as the same graph, and how it looks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using testing::AreIsomorphic;
using ::testing::HasSubstr;
using testing::Lines;
using testing::Named;

constexpr const char* kPrefixes =
    "@prefix : <http://e/> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n";

Document Turtle(const std::string& text) { return ReadRdf(text, Format::kTurtle, Named("x")); }

void ExpectSameAfter(const Document& document, Format format) {
  const std::string text = WriteRdf(document, format);
  Document again;
  ASSERT_NO_THROW(again = ReadRdf(text, format, Named("written"))) << text;
  EXPECT_TRUE(AreIsomorphic(document, again)) << text << "\nread as\n" << Lines(again);
}

TEST(RdfWriter, TurtleIsGroupedAndShort) {
  const Document document = Turtle(std::string(kPrefixes) +
                                   ":a :p 5, 'x'@en ; a owl:Class ; :q [ :r (1 2.5 (true)) ] ."
                                   ":b :p <http://other/x>, [], () . [] :s :a .");
  EXPECT_EQ(WriteRdf(document, Format::kTurtle),
            "@prefix : <http://e/> .\n"
            "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
            "\n"
            ":a a owl:Class ;\n"
            "    :p 5 , \"x\"@en ;\n"
            "    :q [ :r ( 1 2.5 ( true ) ) ] .\n"
            "\n"
            ":b :p <http://other/x> , [] , () .\n"
            "\n"
            "[] :s :a .\n"
            "\n");
  ExpectSameAfter(document, Format::kTurtle);
}

TEST(RdfWriter, BlankNodesUsedTwiceOrInACircleKeepTheirLabels) {
  for (const char* text : {":a :p _:x . :b :p _:x . _:x :q 1 .", "_:x :p _:y . _:y :p _:x .",
                           "_:x :p _:x .", ":a :p _:x . _:x :p _:y . _:y :p _:x ."}) {
    const Document document = Turtle(kPrefixes + std::string(text));
    EXPECT_THAT(WriteRdf(document, Format::kTurtle), HasSubstr("_:")) << text;
    ExpectSameAfter(document, Format::kTurtle);
  }
}

TEST(RdfWriter, IllFormedListsAreWrittenAsTheyAre) {
  const std::string rdf = "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n";
  for (const char* text : {":a :p [ rdf:first 1 ] .", ":a :p [ rdf:first 1, 2 ; rdf:rest () ] .",
                           ":a :p [ rdf:first 1 ; rdf:rest [ rdf:first 2 ; rdf:rest :x ] ] .",
                           ":a :p [ rdf:first 1 ; rdf:rest () ; :also 3 ] .",
                           "_:l rdf:first 1 ; rdf:rest _:l . :a :p _:l .",
                           ":a :p _:l . _:l rdf:first 1 ; rdf:rest _:m . _:m rdf:first 2 ; "
                           "rdf:rest () . :b :p _:m ."}) {
    ExpectSameAfter(Turtle(kPrefixes + rdf + text), Format::kTurtle);
    ExpectSameAfter(Turtle(kPrefixes + rdf + text), Format::kRdfXml);
  }
}

TEST(RdfWriter, LongListsAndDeepNestingAreReadBack) {
  std::string list = ":a :p (";
  for (int i = 0; i < 5000; ++i) list += " " + std::to_string(i);
  ExpectSameAfter(Turtle(kPrefixes + list + ") ."), Format::kTurtle);
  std::string deep = ":a :p ";
  for (int i = 0; i < 200; ++i) deep += i % 3 == 0 ? "( " : "[ :p ";
  deep += "1 ";
  for (int i = 199; i >= 0; --i) deep += i % 3 == 0 ? ") " : "] ";
  ExpectSameAfter(Turtle(kPrefixes + deep + "."), Format::kTurtle);
}

TEST(RdfWriter, GraphsOfTriGAreReadBack) {
  const Document document =
      ReadRdf(std::string(kPrefixes) +
                  ":a :p 1 . :g { :a :p [ :q _:shared ] . } _:g { _:shared :p () . :b :p _:g }",
              Format::kTriG, Named("x"));
  ExpectSameAfter(document, Format::kTriG);
  ExpectSameAfter(document, Format::kNQuads);
}

TEST(RdfWriter, GraphsAreRefusedWhereTheFormatHasNone) {
  const Document document =
      ReadRdf("<http://e/g> { <http://e/a> a <http://e/b> }", Format::kTriG, Named("x"));
  for (const Format format : {Format::kTurtle, Format::kNTriples, Format::kRdfXml}) {
    EXPECT_THROW(WriteRdf(document, format), Error);
  }
}

TEST(RdfWriter, XmlNamesTypesAndKeepsOddPrefixes) {
  Document document = Turtle(
      "@prefix xml1: <http://x/> . @prefix rdf: <http://not-rdf/> . @prefix e: <http://e/> .\n"
      "e:a a e:T, e:U ; e:p 'a<b>&\"c\"', ' x\ty\\r\\nz '@en, _:1n ; <http://y/größe> e:b . _:1n "
      "e:p 1 .");
  const std::string text = WriteRdf(document, Format::kRdfXml);
  EXPECT_THAT(text, HasSubstr("<e:T rdf1:about=\"http://e/a\">"));
  EXPECT_THAT(text, HasSubstr("<e:p>a&lt;b&gt;&amp;\"c\"</e:p>"));
  ExpectSameAfter(document, Format::kRdfXml);
}

TEST(RdfWriter, XmlRefusesWhatItCannotSpell) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      return WriteRdf(Turtle(text), Format::kRdfXml);
    } catch (const Error& error) {
      return error.FullMessage();
    }
  };
  EXPECT_EQ(fault("<http://e/a> <http://e/1> 'x' ."),
            "RDF/XML cannot spell the predicate <http://e/1>");
  EXPECT_EQ(fault("<http://e/a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#li> 'x' ."),
            "RDF/XML cannot spell the predicate "
            "<http://www.w3.org/1999/02/22-rdf-syntax-ns#li>");
  EXPECT_EQ(fault("<http://e/a> <http://e/p> '\\u0001' ."),
            "the literal '?' has a character that XML cannot hold");
}

TEST(RdfWriter, IllFormedDocumentsAreRefused) {
  Document document;
  document.terms = {Term::Iri("http://e/a"), Term::Iri("http://e/a> <b"), Term::Literal("x")};
  document.statements = {{0, 0, 1}};
  EXPECT_THROW(WriteRdf(document, Format::kTurtle), Error);
  document.terms[1] = Term::Iri("http://e/b");
  EXPECT_NO_THROW(WriteRdf(document, Format::kTurtle));
  document.statements = {{2, 0, 1}};
  EXPECT_THROW(WriteRdf(document, Format::kNTriples), Error);
  document.statements = {{0, 2, 1}};
  EXPECT_THROW(WriteRdf(document, Format::kNTriples), Error);
  document.statements = {{0, 0, 9}};
  EXPECT_THROW(WriteRdf(document, Format::kNTriples), Error);
}

TEST(RdfWriter, LabelsThatASyntaxCannotSpellAreReplaced) {
  Document document;
  document.terms = {Term::Blank("a b"), Term::Iri("http://e/p"), Term::Blank("n0")};
  document.statements = {{0, 1, 2}, {2, 1, 0}};
  for (const Format format : {Format::kTurtle, Format::kNTriples, Format::kRdfXml}) {
    ExpectSameAfter(document, format);
  }
}

// A graph of few terms, so that lists, circles and shared nodes come up by chance.
Document RandomDocument(unsigned seed, bool has_graphs) {
  std::mt19937 random(seed);
  const auto pick = [&](std::uint32_t count) {
    return static_cast<std::uint32_t>(random() % count);
  };
  const std::string rdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
  Document document;
  document.prefixes = {{"", "http://e/"}, {"e.x", "http://e/x#"}, {"rdf", rdf}};
  document.terms = {Term::Iri(rdf + "first"),  Term::Iri(rdf + "rest"),   Term::Iri(rdf + "type"),
                    Term::Iri("http://e/p"),   Term::Iri("http://e/x#q"), Term::Iri(rdf + "nil"),
                    Term::Iri("http://e/a.b"), Term::Iri("http://e/x#-"), Term::Iri("http://e/ü")};
  const std::uint32_t iris = 9;
  const std::uint32_t blanks = 7;
  for (std::uint32_t i = 0; i < blanks; ++i) {
    document.terms.push_back(Term::Blank("b" + std::to_string(i)));
  }
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  for (const Term& literal :
       {Term::Literal("x"), Term::Literal("x", "", "en-gb"), Term::Literal("-12", xsd + "integer"),
        Term::Literal("+.5", xsd + "decimal"), Term::Literal("1.e3", xsd + "double"),
        Term::Literal("1.0E-3", xsd + "double"), Term::Literal("true", xsd + "boolean"),
        Term::Literal("1", xsd + "boolean"), Term::Literal("12.", xsd + "decimal"),
        Term::Literal(" two\nlines \"\"\" \\ '"), Term::Literal("\r\t\n"), Term::Literal("\""),
        Term::Literal("\n\"", "http://e/d"), Term::Literal("", xsd + "integer")}) {
    document.terms.push_back(literal);
  }
  const auto all = static_cast<std::uint32_t>(document.terms.size());
  for (int i = 0; i < 25; ++i) {
    Statement statement;
    statement.subject = pick(3) == 0 ? 6 + pick(3) : iris + pick(blanks);
    statement.predicate = pick(5);
    statement.object = pick(2) == 0 ? iris + pick(blanks) : 5 + pick(all - 5);
    if (has_graphs && pick(2) == 0) statement.graph = pick(2) == 0 ? 6 : iris + pick(2);
    document.statements.push_back(statement);
  }
  return document;
}

TEST(RdfWriter, RandomGraphsAreReadBackFromEveryFormat) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Document document = RandomDocument(seed, false);
    for (const Format format : {Format::kRdfXml, Format::kTurtle, Format::kTriG, Format::kNTriples,
                                Format::kNQuads, Format::kJsonLd}) {
      ExpectSameAfter(document, format);
    }
    const Document graphs = RandomDocument(seed, true);
    ExpectSameAfter(graphs, Format::kTriG);
    ExpectSameAfter(graphs, Format::kNQuads);
    ExpectSameAfter(graphs, Format::kJsonLd);
  }
}

}  // namespace
}  // namespace lares::rdf
