// OWL/XML: the document around the axioms, faults with their places, what XML can hide.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/owl_mapping_table.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr Format kFormat = Format::kOwlXml;

Document Read(const std::string& text) { return ReadRdf(text, kFormat, Named("x")); }

Document Turtle(std::string_view statements) {
  return ReadRdf(TurtleText(statements), Format::kTurtle, Named("y"));
}

const std::string kHead = "<Ontology xmlns='http://www.w3.org/2002/07/owl#'>\n";

TEST(OwlXml, HeaderGivesBasePrefixesImportsAndVersion) {
  const Document document = Read(
      "<?xml version='1.0'?><o:Ontology xmlns:o='http://www.w3.org/2002/07/owl#' "
      "xml:base='http://e/o#' ontologyIRI='o' versionIRI='o/1'><o:Prefix name='a' "
      "IRI='http://a/'/><o:Import> x </o:Import></o:Ontology>");
  EXPECT_EQ(document.base_iri, "http://e/o");
  EXPECT_THAT(document.prefixes, ElementsAre(Pair("a", "http://a/")));
  EXPECT_THAT(document.imports, ElementsAre("http://e/x"));
  EXPECT_TRUE(AreIsomorphic(document, Turtle("<http://e/o> owl:versionIRI <http://e/o/1> ; "
                                             "owl:imports <http://e/x> .")));
}

TEST(OwlXml, EntitiesCommentsAndCdataAreText) {
  const Document document = Read(
      "<!DOCTYPE Ontology [ <!ENTITY e 'http://e/'> <!ENTITY t 'b&amp;c'> ]>"
      "<Ontology xmlns='http://www.w3.org/2002/07/owl#' ontologyIRI='&e;o'>"
      "<AnnotationAssertion><!-- <x> --><AnnotationProperty IRI='&e;n'/><IRI>&e;A</IRI>"
      "<Literal>a&t;<![CDATA[<d>]]><!-- e --> f&#10;</Literal></AnnotationAssertion></Ontology>");
  EXPECT_TRUE(AreIsomorphic(document, Turtle(":A :n \"ab&c<d> f\\n\" .")));
}

TEST(OwlXml, LanguageInScopeIsThatOfUntypedLiterals) {
  const Document document = Read(
      "<Ontology xmlns='http://www.w3.org/2002/07/owl#' ontologyIRI='http://e/o' xml:lang='de'>"
      "<DataPropertyAssertion><DataProperty IRI='http://e/d'/><NamedIndividual IRI='http://e/i'/>"
      "<Literal>x</Literal></DataPropertyAssertion>"
      "<DataPropertyAssertion><DataProperty IRI='http://e/d'/><NamedIndividual IRI='http://e/i'/>"
      "<Literal datatypeIRI='http://www.w3.org/2001/XMLSchema#string'>y</Literal>"
      "</DataPropertyAssertion></Ontology>");
  EXPECT_TRUE(AreIsomorphic(document, Turtle(":i :d \"x\"@de , \"y\" .")));
}

TEST(OwlXml, RulesAreLeftOutWithAWarning) {
  const Document document = Read(
      kHead + "  <DLSafeRule><Body><x xmlns='http://y/'>text</x></Body></DLSafeRule></Ontology>");
  EXPECT_EQ(document.statements.size(), 1u);
  ASSERT_EQ(document.remarks.size(), 1u);
  EXPECT_EQ(ToString(document.remarks[0].place), "x:2:3");
}

struct Fault {
  std::string text, message;
};

TEST(OwlXml, FaultsAreRefusedWithTheirPlace) {
  const std::string a = "<Class IRI='http://e/A'/>";
  for (const Fault& fault : std::initializer_list<Fault>{
           {"", "x:1:1: the document is empty"},
           {"<Ontology/>", "x:1:1: the element 'Ontology' is not of OWL's namespace"},
           {"<Class xmlns='http://www.w3.org/2002/07/owl#'/>",
            "x:1:1: expected the element Ontology, not 'Class'"},
           {kHead + "<!-- ü --> <SubClas/></Ontology>",
            "x:2:12: 'SubClas' is no construct of OWL 2"},
           {kHead + "<SubClassOf>" + a + "</SubClassOf></Ontology>",
            "x:2:1: SubClassOf has 2 arguments, not 1"},
           {kHead + "<SubClassOf>" + a + "\n<Datatype IRI='http://e/T'\n/></SubClassOf></Ontology>",
            "x:3:1: expected a class expression in SubClassOf, not Datatype"},
           {kHead + "<SubClassOf>" + a + "<Class/></SubClassOf></Ontology>",
            "x:2:38: the element Class has neither of the attributes IRI and abbreviatedIRI"},
           {kHead + "<SubClassOf>" + a + "<Class abbreviatedIRI='q:A'/></SubClassOf></Ontology>",
            "x:2:38: the prefix 'q:' is not declared"},
           {kHead + "<SubClassOf>" + a + "<Class IRI='A'/></SubClassOf></Ontology>",
            "x:2:38: the IRI 'A' is relative, and no base IRI is known"},
           {kHead + "<SubClassOf>" + a + "äö</SubClassOf></Ontology>",
            "x:2:13: the text 'äö' after this tag is in the wrong place"},
           {kHead + "<SubClassOf><ObjectMinCardinality cardinality='-1'/></SubClassOf></Ontology>",
            "x:2:13: the cardinality '-1' is no number"},
           {kHead + "<SubClassOf><ObjectMinCardinality/></SubClassOf></Ontology>",
            "x:2:13: the element ObjectMinCardinality has no attribute cardinality"},
           {kHead + "<SubClassOf><Class IRI='http://e/A'><x/></Class></SubClassOf></Ontology>",
            "x:2:37: the element 'x' is no part of OWL/XML here"},
           {kHead + "<Class IRI='http://e/A'/></Ontology>", "x:2:1: expected an axiom, not Class"},
           {kHead + "<Literal>x</Literal></Ontology>",
            "x:2:1: the element Literal in the wrong place"},
           {kHead + "<SubClassOf><Import>http://e/x</Import></SubClassOf></Ontology>",
            "x:2:13: the element Import in the wrong place"},
           {kHead + "<ClassAssertion>" + a +
                "<AnonymousIndividual nodeID='a b'/></ClassAssertion>"
                "</Ontology>",
            "x:2:42: 'a b' is no node's label"},
       }) {
    EXPECT_EQ(MessageOf(fault.text, kFormat), fault.message) << fault.text;
    EXPECT_EQ(FaultOf(fault.text, kFormat, Named("x")).code(), Code::kInvalid) << fault.text;
  }
}

TEST(OwlXml, MalformedXmlIsRefusedWhereItBreaks) {
  const Error error = FaultOf(kHead + "<SubClassOf></Ontology>", kFormat, Named("x"));
  EXPECT_EQ(error.code(), Code::kInvalid);
  EXPECT_EQ(error.place()->line, 2);
}

TEST(OwlXml, OtherFilesAndExplodingEntitiesAreRefused) {
  const Error outside = FaultOf("<!DOCTYPE Ontology [ <!ENTITY e SYSTEM 'file:///etc/passwd'> ]>" +
                                    kHead + "<Import>&e;</Import></Ontology>",
                                kFormat, Named("x"));
  EXPECT_EQ(outside.code(), Code::kUnsupported);
  std::string bomb = "<!DOCTYPE Ontology [ <!ENTITY a0 'aaaaaaaaaa'> ";
  for (int i = 1; i < 12; ++i) {
    const std::string before = "&a" + std::to_string(i - 1) + ";";
    bomb += "<!ENTITY a" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) bomb += before;
    bomb += "'> ";
  }
  const Error large =
      FaultOf(bomb + "]>" + kHead + "<Import>&a11;</Import></Ontology>", kFormat, Named("x"));
  EXPECT_EQ(large.code(), Code::kTooLarge);
}

TEST(OwlXml, NestingBeyondTheLimitIsTooDeep) {
  std::string text = kHead + "<SubClassOf>";
  for (int i = 0; i < 300; ++i) text += "<ObjectComplementOf>";
  EXPECT_EQ(FaultOf(text, kFormat, Named("x")).code(), Code::kTooLarge);
}

TEST(OwlXml, Latin1IsReadAndItsFaultsHaveALine) {
  const std::string head = "<?xml version='1.0' encoding='ISO-8859-1'?>\n" + kHead;
  const Document document =
      Read(head +
           "<Annotation><AnnotationProperty IRI='http://e/n'/><Literal>\xE4</Literal>"
           "</Annotation></Ontology>");
  EXPECT_THAT(Lines(document), HasSubstr("\"ä\""));
  const Error error = FaultOf(head + "\n<SubClas/></Ontology>", kFormat, Named("x"));
  EXPECT_EQ(error.place()->line, 4);
}

}  // namespace
}  // namespace lares::rdf::testing
