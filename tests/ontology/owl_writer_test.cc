// Triples as axioms: what is guessed, what OWL 1 wrote otherwise, what cannot be said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ontology/owl_mapping_table.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Document Turtle(std::string_view statements) {
  return ReadRdf(TurtleText(statements), Format::kTurtle, Named("x"));
}

std::string Functional(std::string_view statements) {
  return WriteRdf(Turtle(statements), Format::kOwlFunctional);
}

std::string MessageOfWriting(std::string_view statements) {
  try {
    return "written: " + Functional(statements);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    return error.what();
  }
}

TEST(OwlWriter, FunctionalSyntaxIsWrittenInTheOrderOfTheStatements) {
  EXPECT_EQ(Functional("<http://e/o> owl:imports <http://e/x> ; rdfs:comment \"a \\\"b\\\"\"@en . "
                       ":A a owl:Class ; rdfs:subClassOf :B . :i a :A ; rdfs:label \"5\"^^:T ."),
            "Prefix(:=<http://e/>)\n"
            "Prefix(owl:=<http://www.w3.org/2002/07/owl#>)\n"
            "Prefix(rdf:=<http://www.w3.org/1999/02/22-rdf-syntax-ns#>)\n"
            "Prefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)\n"
            "Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\n\n"
            "Ontology(<http://e/o>\n"
            "Import(<http://e/x>)\n"
            "Annotation(rdfs:comment \"a \\\"b\\\"\"@en)\n"
            "Declaration(Class(:A))\n"
            "SubClassOf(:A :B)\n"
            "ClassAssertion(:A :i)\n"
            "AnnotationAssertion(rdfs:label :i \"5\"^^:T)\n"
            ")\n");
}

TEST(OwlWriter, OwlXmlNamesWhatEachIriIs) {
  const std::string text =
      WriteRdf(Turtle(":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; "
                      "owl:minCardinality \"1\"^^xsd:nonNegativeInteger ] ."),
               Format::kOwlXml);
  EXPECT_THAT(text, HasSubstr("    <SubClassOf>\n"
                              "        <Class abbreviatedIRI=\":A\"/>\n"
                              "        <ObjectMinCardinality cardinality=\"1\">\n"
                              "            <ObjectProperty abbreviatedIRI=\":p\"/>\n"
                              "        </ObjectMinCardinality>\n"
                              "    </SubClassOf>\n"));
}

TEST(OwlWriter, AnIriThatIsAWholeNamespaceIsWrittenInFull) {
  EXPECT_THAT(Functional("<http://e/> a owl:Class ."), HasSubstr("Class(<http://e/>)"));
}

TEST(OwlWriter, KindsOfUndeclaredPropertiesFollowFromTheirUse) {
  const std::string text = Functional(
      ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:someValuesFrom xsd:int ] ."
      ":e rdfs:subPropertyOf :d . :f owl:equivalentProperty :e . :g rdfs:range xsd:string ; "
      "rdfs:domain :A . :p owl:inverseOf :q . :q a owl:FunctionalProperty . "
      ":i a :A ; :r :j ; :s 5 . :A :t :B .");
  for (const char* axiom : {"DataSomeValuesFrom(:d xsd:int)", "SubDataPropertyOf(:e :d)",
                            "EquivalentDataProperties(:f :e)", "DataPropertyDomain(:g :A)",
                            "FunctionalObjectProperty(:q)", "ObjectPropertyAssertion(:r :i :j)",
                            "DataPropertyAssertion(:s :i ", "AnnotationAssertion(:t :A :B)"}) {
    EXPECT_THAT(text, HasSubstr(axiom));
  }
}

TEST(OwlWriter, OneNameMayBeAClassAndAnIndividual) {
  const std::string text = Functional(":A a owl:Class , :B ; :p :A . :p a owl:ObjectProperty .");
  EXPECT_THAT(text, HasSubstr("ClassAssertion(:B :A)"));
  EXPECT_THAT(text, HasSubstr("ObjectPropertyAssertion(:p :A :A)"));
}

TEST(OwlWriter, WaysOfOwl1AreUnderstood) {
  const std::string text = Functional(
      ":A a owl:Class , rdfs:Class ; owl:intersectionOf ( :B :C ) ; owl:complementOf :D . "
      ":E owl:oneOf ( :i :j ) . :p a rdf:Property , owl:ObjectProperty . "
      "[] a owl:AllDifferent ; owl:distinctMembers ( :i :j :k ) . "
      ":d a owl:DatatypeProperty ; rdfs:range [ a owl:DataRange ; owl:oneOf ( 1 2 ) ] .");
  for (const char* axiom :
       {"EquivalentClasses(:A ObjectIntersectionOf(:B :C))",
        "EquivalentClasses(:A ObjectComplementOf(:D))", "EquivalentClasses(:E ObjectOneOf(:i :j))",
        "DifferentIndividuals(:i :j :k)", "DataPropertyRange(:d DataOneOf("}) {
    EXPECT_THAT(text, HasSubstr(axiom));
  }
}

TEST(OwlWriter, ExpressionOfSeveralAxiomsIsWrittenInEach) {
  const std::string text = Functional(
      ":A rdfs:subClassOf _:x . :B rdfs:subClassOf _:x . "
      "_:x a owl:Class ; owl:complementOf :C .");
  EXPECT_THAT(text, HasSubstr("SubClassOf(:A ObjectComplementOf(:C))"));
  EXPECT_THAT(text, HasSubstr("SubClassOf(:B ObjectComplementOf(:C))"));
}

TEST(OwlWriter, AnAxiomWithTwoReificationsIsTwoAxioms) {
  const Document document = Turtle(
      ":A rdfs:subClassOf :B . [] a owl:Axiom ; owl:annotatedSource :A ; "
      "owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget :B ; :n 1 . "
      "[] a owl:Axiom ; owl:annotatedSource :A ; "
      "owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget :B ; :n 2 .");
  const std::string text = WriteRdf(document, Format::kOwlFunctional);
  EXPECT_THAT(text, HasSubstr("SubClassOf(Annotation(:n \"1\"^^xsd:integer) :A :B)"));
  EXPECT_THAT(text, HasSubstr("SubClassOf(Annotation(:n \"2\"^^xsd:integer) :A :B)"));
  EXPECT_TRUE(AreIsomorphic(document, ReadRdf(text, Format::kOwlFunctional, Named("y"))));
}

TEST(OwlWriter, TheFirstTripleOfNoAxiomIsNamed) {
  const std::string subject = "no axiom of OWL 2 says ";
  const std::string e = "<http://e/";
  struct Case {
    std::string turtle, message;
  };
  for (const Case& wrong : std::initializer_list<Case>{
           {":i a :A . :a rdf:value :b . :a rdf:value :c .",
            e + "a> <http://www.w3.org/1999/02/22-rdf-syntax-ns#value> " + e + "b> . ("},
           {":p a owl:ObjectProperty . :i :p 5 .",
            "(the value of an object property that is a literal)"},
           {":d a owl:DatatypeProperty . :i :d :j .",
            "(the value of a data property that is no literal)"},
           {":A rdfs:subClassOf \"B\" .", "('B' is no IRI)"},
           {":A rdfs:subClassOf [] .", "(a blank node is no class or data range)"},
           {":A rdfs:subClassOf [ a owl:Class ] .",
            "(a blank node is no class or data range of one kind)"},
           {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ] .",
            "(a restriction that restricts nothing)"},
           {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p , :q ; "
            "owl:someValuesFrom :B ] .",
            "(an expression has two of <http://www.w3.org/2002/07/owl#onProperty>)"},
           {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:maxCardinality -1 ] "
            ".",
            "(a cardinality that is no number)"},
           {":A rdfs:subClassOf [ owl:unionOf [ rdf:first :B ] ] .", "(a list breaks off)"},
           {":A rdfs:subClassOf [ owl:unionOf _:l ] . _:l rdf:first :B ; rdf:rest _:l .",
            "(a list runs in a circle)"},
           {":A rdfs:subClassOf [ owl:unionOf _:l ] . _:l rdf:first :B ; rdf:rest () , ( :C ) .",
            "(a list forks)"},
           {":A rdfs:subClassOf _:x . _:x a owl:Class ; owl:complementOf _:x .",
            "(an expression nests too deep, or is part of itself)"},
           {"[] a owl:AllDisjointClasses ; owl:members ( :A ) .",
            "(an axiom with fewer than two members)"},
           {"_:x a owl:Class ; owl:complementOf :A .", "(it is part of no axiom)"},
           {":i :p _:x . _:x a owl:Class ; owl:complementOf :A .",
            "(a blank node is no individual)"},
           {":A a owl:DeprecatedClass .", "is of the reserved vocabulary"},
           {"[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty :p ; "
            "owl:annotatedTarget :B ; :n 1 .",
            "(it is part of no axiom)"},
       }) {
    const std::string message = MessageOfWriting(wrong.turtle);
    EXPECT_THAT(message, ::testing::StartsWith(subject)) << wrong.turtle;
    EXPECT_THAT(message, HasSubstr(wrong.message)) << wrong.turtle;
  }
}

TEST(OwlWriter, WhatIsNoAxiomCanBeLeftOutAndIsListed) {
  const OwlText text = WriteAxioms(
      Turtle(":A rdfs:subClassOf :B , [ a owl:Class ] . :B rdf:value 1 ."), Format::kOwlFunctional);
  EXPECT_THAT(text.text, HasSubstr("SubClassOf(:A :B)"));
  EXPECT_THAT(text.text, Not(HasSubstr("value")));
  EXPECT_EQ(text.left_out.size(), 3u);
  EXPECT_THAT(WriteAxioms(Turtle(":A rdfs:subClassOf :B ."), Format::kOwlXml).left_out, IsEmpty());
}

TEST(OwlWriter, GraphsBuiltToExplodeEndInAnError) {
  std::string turtle = ":A rdfs:subClassOf _:x0 . ";
  for (int i = 0; i < 60; ++i) {
    const std::string x = "_:x" + std::to_string(i);
    const std::string next = "_:x" + std::to_string(i + 1);
    turtle += x + " a owl:Class ; owl:intersectionOf ( " + next + " " + next + " ) . ";
  }
  turtle += "_:x60 a owl:Class ; owl:complementOf :B .";
  EXPECT_THAT(MessageOfWriting(turtle), HasSubstr("shared so often"));
}

TEST(OwlWriter, NamedGraphsAreRefused) {
  const Document document =
      ReadRdf("<http://e/g> { <http://e/a> a <http://e/b> }", Format::kTriG, Named("x"));
  EXPECT_THROW(WriteRdf(document, Format::kOwlFunctional), Error);
  EXPECT_THROW(WriteAxioms(document, Format::kOwlXml), Error);
}

TEST(OwlWriter, CharactersThatXmlCannotHoldAreRefusedInXmlOnly) {
  const Document document = Turtle(":A rdfs:label \"\\u0001\" .");
  EXPECT_THROW(WriteRdf(document, Format::kOwlXml), Error);
  const std::string text = WriteRdf(document, Format::kOwlFunctional);
  EXPECT_TRUE(AreIsomorphic(document, ReadRdf(text, Format::kOwlFunctional, Named("y"))));
}

}  // namespace
}  // namespace lares::rdf::testing
