// OWL functional syntax: the text around the axioms, faults with their places, limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/owl_mapping_table.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr Format kFormat = Format::kOwlFunctional;

Document Read(const std::string& text) { return ReadRdf(text, kFormat, Named("x")); }

TEST(OwlFunctional, HeaderGivesPrefixesImportsAndVersion) {
  const Document document = Read(
      "\xEF\xBB\xBF# first\r\nPrefix( a: = <http://a/> ) # a comment ( \" <\n"
      "Prefix(:=<http://e/>)\n"
      "Ontology( a:o <http://a/o/1>\n Import(<http://e/x>) Import(a:y)\n)#last");
  EXPECT_THAT(document.prefixes, ElementsAre(Pair("", "http://e/"), Pair("a", "http://a/")));
  EXPECT_THAT(document.imports, ElementsAre("http://e/x", "http://a/y"));
  EXPECT_EQ(document.format, kFormat);
  EXPECT_TRUE(AreIsomorphic(
      document, ReadRdf("<http://a/o> a <http://www.w3.org/2002/07/owl#Ontology> ; "
                        "<http://www.w3.org/2002/07/owl#versionIRI> <http://a/o/1> ; "
                        "<http://www.w3.org/2002/07/owl#imports> <http://e/x> , <http://a/y> .",
                        Format::kTurtle, Named("y"))));
}

TEST(OwlFunctional, OntologyWithoutANameIsABlankNode) {
  EXPECT_THAT(Lines(Read("Ontology()")), ::testing::StartsWith("_:"));
}

TEST(OwlFunctional, StandardPrefixesNeedNoDeclaration) {
  EXPECT_EQ(Read("Ontology(SubClassOf(owl:Thing owl:Thing))").statements.size(), 2u);
}

TEST(OwlFunctional, StringsKeepLineBreaksHashesAndNextStrings) {
  const Document document = Read(FunctionalText(
      "DataPropertyAssertion(:d :i \"a # b\n(c)\"@en) SubClassOf(:A DataAllValuesFrom(:d "
      "DataOneOf(\"\\\"1\" \"\\\\2\"^^xsd:anyURI \"\\\"3\")))"));
  const std::string lines = Lines(document);
  for (const char* text : {"\"a # b\\n(c)\"@en", "\"\\\"1\"", "\"\\\\2\"^^<", "\"\\\"3\""}) {
    EXPECT_THAT(lines, HasSubstr(text));
  }
}

TEST(OwlFunctional, NodesOfTheTextAreNotThoseThatTheMappingMakes) {
  const Document document =
      Read(FunctionalText("ClassAssertion(ObjectComplementOf(:A) _:genid1) "
                          "ClassAssertion(:B _:Lgenid1) ClassAssertion(:C _:genid1)"));
  EXPECT_TRUE(AreIsomorphic(
      document, ReadRdf(TurtleText("_:x a [ a owl:Class ; owl:complementOf :A ] , :C . _:y a :B ."),
                        Format::kTurtle, Named("y"))));
}

TEST(OwlFunctional, GivenBaseResolvesRelativeIris) {
  ReadOptions options = Named("x");
  options.base_iri = "http://base/a";
  EXPECT_THAT(Lines(ReadRdf("Ontology(SubClassOf(<b> <#c>))", kFormat, options)),
              HasSubstr("<http://base/b> <http://www.w3.org/2000/01/rdf-schema#subClassOf> "
                        "<http://base/a#c>"));
}

TEST(OwlFunctional, RulesAreLeftOutWithAWarning) {
  const Document document = Read(FunctionalText(
      "SubClassOf(:A :B)\n  DLSafeRule(Body(ClassAtom(:A Variable(<urn:x>))) Head())\n"
      "SubClassOf(:B :C)"));
  EXPECT_EQ(document.statements.size(), 3u);
  ASSERT_EQ(document.remarks.size(), 1u);
  EXPECT_EQ(document.remarks[0].kind, Remark::Kind::kWarning);
  EXPECT_EQ(ToString(document.remarks[0].place), "x:4:3");
  EXPECT_THAT(document.remarks[0].message, HasSubstr("DLSafeRule"));
}

struct Fault {
  std::string text, message;
};

TEST(OwlFunctional, FaultsAreRefusedWithTheirPlace) {
  const std::string head = "Prefix(:=<http://e/>)\nOntology(\n";
  for (const Fault& fault : std::initializer_list<Fault>{
           {"", "x:1:1: expected Prefix(…) or Ontology(…), not the end of the text"},
           {"Namespace(a)", "x:1:1: expected Prefix(…) or Ontology(…), not 'Namespace'"},
           {"Prefix(:=http://e/)", "x:1:10: expected an IRI in < and >, not 'http://e/'"},
           {"Prefix(:=<e>)", "x:1:10: the IRI 'e' is not absolute"},
           {"Prefix(a:b=<http://e/>)", "x:1:8: the prefix 'a:b' does not end with ':'"},
           {"Prefix(a:=<http://e/>)\nPrefix(a:=<http://f/>)",
            "x:2:8: the prefix 'a:' means <http://e/> already"},
           {"Prefix(owl:=<http://e/>)",
            "x:1:8: the prefix 'owl:' means <http://www.w3.org/2002/07/owl#> already"},
           {head, "x:2:1: the ontology that begins here does not end"},
           {head + ") x", "x:3:3: expected nothing after the ontology, not 'x'"},
           {head + "SubClassOf(:A :B", "x:3:1: the SubClassOf that begins here does not end"},
           {head + "SubClassOf(:A :B :C))", "x:3:1: SubClassOf has 2 arguments, not 3"},
           {head + "EquivalentClasses(:A))",
            "x:3:1: EquivalentClasses has at least 2 arguments, not 1"},
           {head + "SubClassOf(:A ObjectMinCardinality(1)))",
            "x:3:15: ObjectMinCardinality has 2 or 3 arguments, not 1"},
           {head + "SubClasOf(:A :B))", "x:3:1: 'SubClasOf' is no construct of OWL 2"},
           {head + "ObjectUnionOf(:A :B))", "x:3:1: expected an axiom, not ObjectUnionOf"},
           {head + "SubClassOf(:Ä \"ö\" )",
            "x:3:15: expected a class expression in SubClassOf, not a literal"},
           {head + "SubClassOf(:A DataOneOf(\"a\")))",
            "x:3:15: expected a class expression in SubClassOf, not DataOneOf"},
           {head + "SubClassOf(:A _:b))",
            "x:3:15: expected a class expression in SubClassOf, not an anonymous individual"},
           {head + "DataPropertyRange(ObjectInverseOf(:p) xsd:string))",
            "x:3:19: expected a data property in DataPropertyRange, not ObjectInverseOf"},
           {head + "Declaration(:A))",
            "x:3:13: expected an entity such as Class(…) in Declaration, not an IRI"},
           {head + "SubClassOf(:A Annotation(:n :i) :B))",
            "x:3:15: annotations come before the arguments of SubClassOf"},
           {head + "SubClassOf(:A ObjectComplementOf(Annotation(:n :i) :B)))",
            "x:3:34: ObjectComplementOf takes no annotation"},
           {head + "SubClassOf(:A (:B)))", "x:3:15: '(' without a name before it"},
           {head + "HasKey(:A () ()))", "x:3:1: HasKey names no property"},
           {head + "HasKey(:A :p))", "x:3:1: HasKey has 3 arguments, not 2"},
           {head + "DatatypeDefinition(:T DatatypeRestriction(xsd:int xsd:minInclusive)))",
            "x:3:51: FacetRestriction has 2 arguments, not 1"},
           {head + "SubClassOf(é:A :B))", "x:3:12: the prefix 'é:' is not declared"},
           {head + "SubClassOf(<http://e/a b> :B))", "x:3:23: white space in an IRI"},
           {head + "SubClassOf(<http://e/{> :B))",
            "x:3:12: the IRI 'http://e/{' has the "
            "character '{' in it"},
           {head + "SubClassOf(<b> :B))",
            "x:3:12: the IRI 'b' is relative, and no base IRI is known"},
           {head + "SubClassOf(<http://e", "x:3:21: an IRI that '<' begins does not end"},
           {head + "AnnotationAssertion(:n :A \"a\\n\"))",
            "x:3:29: only \\\" and \\\\ are escapes in functional syntax"},
           {head + "AnnotationAssertion(:n :A \"a))",
            "x:3:27: the string that begins here does "
            "not end"},
           {head + "AnnotationAssertion(:n :A \"a\"@))", "x:3:30: '@' begins no language tag"},
           {head + "AnnotationAssertion(:n :A \"a\"@toolonglanguage))",
            "x:3:27: 'toolonglanguage' is not a language tag"},
           {head + "AnnotationAssertion(:n :A \"a\"^^\"b\"))",
            "x:3:32: expected a datatype, not a string"},
           {head + "SameIndividual(_:a, _:b))", "x:3:19: the character ',' has no meaning here"},
           {head + "SubClassOf(:A :\xFF))", "x:3:16: a byte that is not UTF-8"},
           {head + "DLSafeRule(Body(", "x:3:1: the DLSafeRule that begins here does not end"},
       }) {
    EXPECT_EQ(MessageOf(fault.text, kFormat), fault.message) << fault.text;
    EXPECT_EQ(FaultOf(fault.text, kFormat, Named("x")).code(), Code::kInvalid) << fault.text;
  }
}

TEST(OwlFunctional, MisspeltConstructsBringNearOnes) {
  EXPECT_THAT(FaultOf(FunctionalText("SubClasOf(:A :B)"), kFormat, Named("x")).hint(),
              HasSubstr("SubClassOf"));
}

TEST(OwlFunctional, AHundredThousandNestedConstructsAreTooDeep) {
  std::string text = "Ontology(SubClassOf(<http://e/A>";
  for (int i = 0; i < 100000; ++i) text += " ObjectComplementOf(";
  const Error error = FaultOf(text, kFormat, Named("x"));
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_THAT(error.FullMessage(), HasSubstr("constructs nest deeper than 256"));
  EXPECT_GT(error.place()->column, 5000);
}

TEST(OwlFunctional, LimitsNameTheirPlace) {
  ReadOptions options = Named("x");
  options.max_statements = 3;
  const Error many = FaultOf(
      FunctionalText("SubClassOf(:A :B)\nSubClassOf(:B :C)\n SubClassOf(:C :D)"), kFormat, options);
  EXPECT_EQ(many.code(), Code::kTooLarge);
  EXPECT_EQ(ToString(*many.place()), "x:5:2");
  options.max_statements = 100;
  options.max_term_bytes = 40;
  const Error large =
      FaultOf(FunctionalText("DataPropertyAssertion(:d :i \"" + std::string(50, 'a') + "\")"),
              kFormat, options);
  EXPECT_EQ(large.code(), Code::kTooLarge);
}

}  // namespace
}  // namespace lares::rdf::testing
