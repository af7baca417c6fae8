// What a check of an ontology document tells, and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "ontology/rdf/reader.h"
#include "ontology/triples/graph.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/profile/check.h"

namespace lares::profile {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kPrefixes =
    "@prefix : <http://e/#> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n";

// A catalogue with :Thing1 ⊓ :Thing2 ⊑ ⊥ and one property.
constexpr const char* kCatalogue =
    ":Solid a owl:Class . :Liquid a owl:Class ; owl:disjointWith :Solid . "
    ":hasPart a owl:ObjectProperty . :stone a :Solid .";

class ProfileTest : public ::testing::Test {
 protected:
  ProfileTest() {
    const rdf::Document document =
        rdf::ReadRdf(kPrefixes + std::string(kCatalogue), rdf::Format::kTurtle, {});
    const rdf::View empty(dictionary_);
    catalogue_ = empty.With(
        owl::Materialise(empty, {rdf::MakeGraph(document, "module:test", aliases_, *dictionary_)}));
  }

  Report Check(const std::string& text, rdf::Format format = rdf::Format::kTurtle) {
    rdf::ReadOptions options;
    options.source = "x";
    options.record_lines = true;
    const rdf::Document document = rdf::ReadRdf(text, format, options);
    return profile::Check({document, text, "x", aliases_, catalogue_});
  }
  Report CheckTurtle(const std::string& text) { return Check(kPrefixes + text); }

  // "kind: message" of each finding, one to a line.
  static std::string Text(const Report& report) {
    std::string text;
    for (const Finding& finding : report.findings) {
      text += ToString(finding.places.at(0)) + ": " + std::string(ToString(finding.kind)) + ": " +
              finding.message + "\n";
    }
    return text;
  }

  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  rdf::AliasTable aliases_;
  rdf::View catalogue_{dictionary_};
};

struct Case {
  const char* turtle;
  const char* finding;  // "" for none
};

TEST_F(ProfileTest, EachConstructIsAllowedWhereRlHasIt) {
  const std::string declared =
      ":A a owl:Class . :B a owl:Class . :i a :A . :p a owl:ObjectProperty . "
      ":d a owl:DatatypeProperty .\n";
  const std::string on = " a owl:Restriction ; owl:onProperty ";
  const auto restriction = [&](const std::string& rest) { return "[" + on + rest + " ]"; };
  const std::pair<std::string, std::string> cases[] = {
      {":A rdfs:subClassOf :B .", ""},
      {":A rdfs:subClassOf " + restriction(":p ; owl:someValuesFrom :B") + " .",
       "owl:someValuesFrom on the side of the superclass"},
      {restriction(":p ; owl:someValuesFrom :B") + " rdfs:subClassOf :A .", ""},
      {restriction(":p ; owl:someValuesFrom owl:Thing") + " rdfs:subClassOf :A .", ""},
      {":A rdfs:subClassOf " + restriction(":p ; owl:allValuesFrom :B") + " .", ""},
      {restriction(":p ; owl:allValuesFrom :B") + " rdfs:subClassOf :A .",
       "owl:allValuesFrom on the side of the subclass"},
      {":A rdfs:subClassOf " + restriction(":p ; owl:hasValue :i") + " .", ""},
      {":A owl:equivalentClass " + restriction(":p ; owl:hasValue :i") + " .", ""},
      {":A owl:equivalentClass " + restriction(":p ; owl:someValuesFrom :B") + " .",
       "owl:someValuesFrom as an equivalent class"},
      {":A rdfs:subClassOf " + restriction(":p ; owl:maxCardinality 1") + " .", ""},
      {":A rdfs:subClassOf " + restriction(":p ; owl:maxCardinality 2") + " .",
       "owl:maxCardinality on the side of the superclass: only 0 and 1 count"},
      {":A rdfs:subClassOf " + restriction(":p ; owl:cardinality 1") + " .", "owl:cardinality on"},
      {":A rdfs:subClassOf " + restriction(":p ; owl:minCardinality 1") + " .",
       "owl:minCardinality on"},
      {":A rdfs:subClassOf " + restriction(":p ; owl:maxQualifiedCardinality 1 ; owl:onClass :B") +
           " .",
       ""},
      {":A rdfs:subClassOf " + restriction(":p ; owl:hasSelf true") + " .", "owl:hasSelf on"},
      {":A rdfs:subClassOf [ a owl:Class ; owl:unionOf (:A :B) ] .",
       "owl:unionOf on the side of the superclass"},
      {"[ a owl:Class ; owl:unionOf (:A :B) ] rdfs:subClassOf :A .", ""},
      {":A rdfs:subClassOf [ a owl:Class ; owl:intersectionOf (:B [ a owl:Class ; owl:unionOf (:A "
       ":B) ]) ] .",
       "owl:unionOf on the side of the superclass"},
      {":A rdfs:subClassOf [ a owl:Class ; owl:complementOf :B ] .", ""},
      {"[ a owl:Class ; owl:complementOf :B ] rdfs:subClassOf :A .",
       "owl:complementOf on the side of the subclass"},
      {":A rdfs:subClassOf [ a owl:Class ; owl:complementOf [ a owl:Class ; owl:unionOf (:B) ] "
       "] "
       ".",
       ""},
      {":A owl:unionOf (:B) .", "owl:unionOf as an equivalent class"},
      {":A rdfs:subClassOf [ a owl:Class ; owl:oneOf (:i) ] .", "owl:oneOf on"},
      {"[ a owl:Class ; owl:oneOf (:i) ] rdfs:subClassOf :A .", ""},
      {":A owl:disjointUnionOf (:B) .", "owl:disjointUnionOf"},
      {":p a owl:ReflexiveProperty .", "owl:ReflexiveProperty"},
      {":p a owl:IrreflexiveProperty .", ""},
      {":p rdfs:domain [ a owl:Class ; owl:unionOf (:A :B) ] .", "owl:unionOf on"},
      {":A owl:hasKey (:p) .", ""},
      {":d rdfs:range xsd:integer .", ""},
      {":d rdfs:range xsd:date .", "the datatype xsd:date"},
      {":d rdfs:range [ a rdfs:Datatype ; owl:oneOf (1 2) ] .", "owl:oneOf as a range of values"},
      {":i :d '2020-01-01'^^xsd:date .", "values of xsd:date"},
      {":i rdfs:comment '2020-01-01'^^xsd:date .", ""},
  };
  for (const auto& [turtle, finding] : cases) {
    const Report report = CheckTurtle(declared + turtle);
    EXPECT_EQ(report.is_owl2_rl, finding.empty()) << turtle << "\n" << Text(report);
    EXPECT_EQ(report.is_clean, finding.empty()) << turtle << "\n" << Text(report);
    EXPECT_THAT(Text(report), HasSubstr(finding)) << turtle;
  }
}

TEST_F(ProfileTest, MalformedStructuresAreNamed) {
  const std::string declared = ":A a owl:Class . :p a owl:ObjectProperty .\n";
  const Case cases[] = {
      {":A rdfs:subClassOf [ a owl:Restriction ; owl:someValuesFrom :A ] .",
       "a restriction without owl:onProperty"},
      {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ] .", "restricts nothing"},
      {":A rdfs:subClassOf [ owl:onProperty :p ; owl:hasValue :A ] .", "not typed owl:Restriction"},
      {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:hasValue :A ; "
       "owl:allValuesFrom :A ] .",
       "several constraints"},
      {":A owl:intersectionOf _:l . _:l rdf:first :A ; rdf:rest _:l .", "runs in a circle"},
      {":A owl:intersectionOf _:l . _:l rdf:first :A .", "without rdf:rest"},
      {"_:l rdf:first :A, :p ; rdf:rest () .", "several rdf:first"},
      {"rdf:nil rdf:first :A ; rdf:rest () .", "rdf:nil"},
      {":A rdfs:subClassOf 'text' .", "leads to a text"},
      {":A rdfs:subClassOf [] .", "nothing describes"},
      {"[] a owl:AllDisjointClasses .", "without owl:members"},
      {"[] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedTarget :A .",
       "without owl:annotatedProperty"},
      {":p a owl:DatatypeProperty .", "both an object and a data property"},
      {":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:maxCardinality 'one' ] .",
       "no number"},
  };
  for (const Case& one : cases) {
    const Report report = CheckTurtle(declared + one.turtle);
    EXPECT_THAT(Text(report), HasSubstr("structure: ")) << one.turtle;
    EXPECT_THAT(Text(report), HasSubstr(one.finding)) << one.turtle;
    EXPECT_FALSE(report.is_owl2_rl);
  }
}

TEST_F(ProfileTest, UndeclaredTermsAreToldWithSimilarNames) {
  const Report report = CheckTurtle(
      ":Cup a owl:Class ;\n  rdfs:subClassOf :Sollid .\n:c a :Cup ;\n  :hasPrat :d .\n"
      ":e :hasPart :stone .\n:f a :Cup ; :hasPart :c .");
  const std::string text = Text(report);
  EXPECT_THAT(text, HasSubstr("x:3:20: undeclared: the class Sollid is declared nowhere; similar "
                              "names: Solid"));
  EXPECT_THAT(text,
              HasSubstr("x:5:4: undeclared: the property hasPrat is declared nowhere; similar "
                        "names: hasPart"));
  EXPECT_THAT(text, HasSubstr("x:6:2: undeclared: individuals of <http://e/#>"));
  EXPECT_EQ(report.findings.size(), 3u) << text;
  EXPECT_TRUE(report.is_owl2_rl);
}

TEST_F(ProfileTest, WordsThatOwlDoesNotHaveAreUndeclared) {
  const Report report = CheckTurtle(":A a owl:Class ; rdfs:subclassOf :Solid .");
  EXPECT_THAT(Text(report), HasSubstr("rdfs:subclassOf is no word of its vocabulary; perhaps "
                                      "rdfs:subClassOf is meant"));
}

TEST_F(ProfileTest, ClassesWithoutMembersAreFoundThroughTheCatalogue) {
  const Report report = CheckTurtle(
      ":Ice a owl:Class ; rdfs:subClassOf :Solid .\n:Water a owl:Class ; rdfs:subClassOf :Liquid "
      ".\n"
      ":Slush a owl:Class ;\n  rdfs:subClassOf :Ice, :Water .\n"
      ":Nil a owl:Class ; rdfs:subClassOf owl:Nothing .");
  const std::string text = Text(report);
  EXPECT_THAT(text, HasSubstr("unsatisfiable: the class can have no member: it would be"));
  EXPECT_THAT(text, HasSubstr("unsatisfiable: the class is below owl:Nothing"));
  std::size_t unsatisfiable = 0;
  for (const Finding& finding : report.findings) {
    if (finding.kind != Kind::kUnsatisfiable) continue;
    ++unsatisfiable;
    EXPECT_EQ(finding.count, 1u);
    EXPECT_THAT(finding.names,
                ::testing::AnyOf(::testing::ElementsAre("Slush"), ::testing::ElementsAre("Nil")));
  }
  EXPECT_EQ(unsatisfiable, 2u) << text;
}

TEST_F(ProfileTest, MembersThatDisturbEachOtherMakeNoClassUnsatisfiable) {
  // One key value for all members of both classes: together they would be one and the same.
  const Report report = CheckTurtle(
      ":k a owl:ObjectProperty, owl:InverseFunctionalProperty . :v a :Solid .\n"
      ":A a owl:Class ; rdfs:subClassOf :Solid, [ a owl:Restriction ; owl:onProperty :k ; "
      "owl:hasValue :v ] .\n"
      ":B a owl:Class ; rdfs:subClassOf :Liquid, [ a owl:Restriction ; owl:onProperty :k ; "
      "owl:hasValue :v ] .");
  EXPECT_TRUE(report.is_clean) << Text(report);
}

TEST_F(ProfileTest, ContradictionsWithTheCatalogueAreTold) {
  const Report report = CheckTurtle(":other a :Solid .\n:stone a :Liquid .");
  EXPECT_THAT(Text(report), HasSubstr("x:3:2: contradiction: is "));
  EXPECT_THAT(report.findings.at(0).names, ::testing::ElementsAre("stone"));
}

TEST_F(ProfileTest, TheSameFaultIsToldOnce) {
  std::string text;
  for (int i = 0; i < 50; ++i) {
    text += ":A" + std::to_string(i) +
            " a owl:Class ; rdfs:subClassOf [ a owl:Class ; owl:unionOf (:Solid :Liquid) ] .\n";
  }
  const Report report = CheckTurtle(text);
  ASSERT_EQ(report.findings.size(), 1u) << Text(report);
  EXPECT_EQ(report.findings[0].count, 50u);
  EXPECT_EQ(report.findings[0].places.size(), 3u);
  EXPECT_EQ(report.findings[0].places[1].line, 3);
}

TEST_F(ProfileTest, PunningIsARemarkAndThingSaysNothing) {
  const Report report =
      CheckTurtle(":A a owl:Class, :B ; rdfs:subClassOf owl:Thing . :B a owl:Class .");
  EXPECT_TRUE(report.is_clean) << Text(report);
  EXPECT_THAT(Text(report), HasSubstr("remark: one name for a class and individual (punning)"));
  EXPECT_THAT(Text(report), HasSubstr("remark: owl:Thing on the side of the superclass"));
}

TEST_F(ProfileTest, PlacesAreKnownInEveryFormat) {
  const std::string xml =
      "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'\n"
      " xmlns:owl='http://www.w3.org/2002/07/owl#'\n"
      " xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#'>\n"
      "<owl:Class rdf:about='http://e/#Cup'>\n"
      " <rdfs:subClassOf rdf:resource='http://e/#Sollid'/>\n</owl:Class>\n</rdf:RDF>";
  const std::string json =
      "{\"@id\": \"http://e/#Cup\",\n \"@type\": \"http://www.w3.org/2002/07/owl#Class\",\n"
      " \"http://www.w3.org/2000/01/rdf-schema#subClassOf\":\n  {\"@id\": \"http://e/#Sollid\"}}";
  EXPECT_THAT(Text(Check(xml, rdf::Format::kRdfXml)), HasSubstr("x:5:43: undeclared: the class"));
  EXPECT_THAT(Text(Check(json, rdf::Format::kJsonLd)), HasSubstr("x:4:22: undeclared: the class"));
}

TEST_F(ProfileTest, EmptyAndHostileDocumentsAreChecked) {
  EXPECT_TRUE(CheckTurtle("").is_clean);
  std::string deep = ":A a owl:Class ; rdfs:subClassOf _:c0 .\n";
  for (int i = 0; i < 3000; ++i) {
    const std::string n = std::to_string(i);
    deep +=
        "_:c" + n + " a owl:Class ; owl:complementOf _:c" + std::to_string((i + 1) % 3000) + " .\n";
  }
  EXPECT_FALSE(CheckTurtle(deep).findings.size() > 10);
}

TEST_F(ProfileTest, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const rdf::Document document = rdf::ReadRdf("", rdf::Format::kTurtle, {});
  EXPECT_THROW(profile::Check({document, "", "x", aliases_, catalogue_}, source.get_token()),
               Error);
}

}  // namespace
}  // namespace lares::profile
