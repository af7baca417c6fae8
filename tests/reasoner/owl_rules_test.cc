// Each rule of the table on its smallest case.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "reasoner/owl/materialise.h"
#include "reasoner/owl/rule.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TripleOf;

struct Case {
  const char* rule;
  const char* given;
  const char* follows;  // a triple; empty: a contradiction
};

// Where a rule has several rows, or two positions that may be mixed up, there are several cases.
const Case kCases[] = {
    {"eq-sym", ":a owl:sameAs :b .", ":b owl:sameAs :a"},
    {"eq-trans", ":a owl:sameAs :b . :b owl:sameAs :c .", ":a owl:sameAs :c"},
    {"eq-rep-s", ":a owl:sameAs :b . :a :p :c .", ":b :p :c"},
    {"eq-rep-p", ":p owl:sameAs :q . :a :p :c .", ":a :q :c"},
    {"eq-rep-o", ":a owl:sameAs :b . :c :p :a .", ":c :p :b"},
    {"eq-diff1", ":a owl:sameAs :b ; owl:differentFrom :b .", ""},
    {"eq-diff1", ":a owl:differentFrom :a .", ""},
    {"eq-diff2", ":d a owl:AllDifferent ; owl:members ( :x :a :b ) . :b owl:sameAs :a .", ""},
    {"eq-diff3", ":d a owl:AllDifferent ; owl:distinctMembers ( :a :b ) . :a owl:sameAs :b .", ""},
    {"prp-dom", ":p rdfs:domain :C . :a :p :b .", ":a a :C"},
    {"prp-rng", ":p rdfs:range :C . :a :p :b .", ":b a :C"},
    {"prp-fp", ":p a owl:FunctionalProperty . :a :p :b , :c .", ":b owl:sameAs :c"},
    {"prp-ifp", ":p a owl:InverseFunctionalProperty . :b :p :a . :c :p :a .", ":b owl:sameAs :c"},
    {"prp-ifp", ":p a owl:InverseFunctionalProperty . :b :p 7 . :c :p 7 .", ":b owl:sameAs :c"},
    {"prp-irp", ":p a owl:IrreflexiveProperty . :a :p :a .", ""},
    {"prp-symp", ":p a owl:SymmetricProperty . :a :p :b .", ":b :p :a"},
    {"prp-asyp", ":p a owl:AsymmetricProperty . :a :p :b . :b :p :a .", ""},
    {"prp-trp", ":p a owl:TransitiveProperty . :a :p :b . :b :p :c .", ":a :p :c"},
    {"prp-spo1", ":p rdfs:subPropertyOf :q . :a :p :b .", ":a :q :b"},
    {"prp-spo2", ":p owl:propertyChainAxiom ( :q :r :q ) . :a :q :b . :b :r :c . :c :q :d .",
     ":a :p :d"},
    {"prp-eqp1", ":p owl:equivalentProperty :q . :a :p :b .", ":a :q :b"},
    {"prp-eqp2", ":p owl:equivalentProperty :q . :a :q :b .", ":a :p :b"},
    {"prp-pdw", ":p owl:propertyDisjointWith :q . :a :p :b ; :q :b .", ""},
    {"prp-adp", ":d a owl:AllDisjointProperties ; owl:members ( :r :p :q ) . :a :p :b ; :q :b .",
     ""},
    {"prp-inv1", ":p owl:inverseOf :q . :a :p :b .", ":b :q :a"},
    {"prp-inv2", ":p owl:inverseOf :q . :a :q :b .", ":b :p :a"},
    {"prp-key", ":C owl:hasKey ( :p :q ) . :a a :C ; :p 1 ; :q :z . :b a :C ; :p 1 ; :q :z .",
     ":a owl:sameAs :b"},
    {"prp-npa1",
     ":n owl:sourceIndividual :a ; owl:assertionProperty :p ; owl:targetIndividual :b . :a :p :b .",
     ""},
    {"prp-npa2",
     ":n owl:sourceIndividual :a ; owl:assertionProperty :p ; owl:targetValue 5 . :a :p 5 .", ""},
    {"cls-nothing2", ":a a owl:Nothing .", ""},
    {"cls-int1", ":C owl:intersectionOf ( :D :E ) . :a a :D , :E .", ":a a :C"},
    {"cls-int2", ":C owl:intersectionOf ( :D :E ) . :a a :C .", ":a a :E"},
    {"cls-uni", ":C owl:unionOf ( :D :E ) . :a a :E .", ":a a :C"},
    {"cls-com", ":C owl:complementOf :D . :a a :C , :D .", ""},
    {"cls-svf1", ":R owl:someValuesFrom :C ; owl:onProperty :p . :a :p :b . :b a :C .", ":a a :R"},
    {"cls-svf2", ":R owl:someValuesFrom owl:Thing ; owl:onProperty :p . :a :p :b .", ":a a :R"},
    {"cls-avf", ":R owl:allValuesFrom :C ; owl:onProperty :p . :a a :R ; :p :b .", ":b a :C"},
    {"cls-hv1", ":R owl:hasValue 3 ; owl:onProperty :p . :a a :R .", ":a :p 3"},
    {"cls-hv2", ":R owl:hasValue :b ; owl:onProperty :p . :a :p :b .", ":a a :R"},
    {"cls-maxc1", ":R owl:maxCardinality 0 ; owl:onProperty :p . :a a :R ; :p :b .", ""},
    {"cls-maxc2",
     ":R owl:maxCardinality \"01\"^^xsd:int ; owl:onProperty :p . :a a :R ; :p :b , :c .",
     ":b owl:sameAs :c"},
    {"cls-maxqc1",
     ":R owl:maxQualifiedCardinality 0 ; owl:onProperty :p ; owl:onClass :C . :a a :R ; :p :b . "
     ":b a :C .",
     ""},
    {"cls-maxqc2",
     ":R owl:maxQualifiedCardinality 0 ; owl:onProperty :p ; owl:onClass owl:Thing . "
     ":a a :R ; :p :b .",
     ""},
    {"cls-maxqc3",
     ":R owl:maxQualifiedCardinality 1 ; owl:onProperty :p ; owl:onClass :C . "
     ":a a :R ; :p :b , :c . :b a :C . :c a :C .",
     ":c owl:sameAs :b"},
    {"cls-maxqc4",
     ":R owl:maxQualifiedCardinality 1 ; owl:onProperty :p ; owl:onClass owl:Thing . "
     ":a a :R ; :p :b , :c .",
     ":b owl:sameAs :c"},
    {"cls-oo", ":C owl:oneOf ( :a :b ) .", ":b a :C"},
    {"cax-sco", ":C rdfs:subClassOf :D . :a a :C .", ":a a :D"},
    {"cax-eqc1", ":C owl:equivalentClass :D . :a a :C .", ":a a :D"},
    {"cax-eqc2", ":C owl:equivalentClass :D . :a a :D .", ":a a :C"},
    {"cax-dw", ":C owl:disjointWith :D . :a a :C , :D .", ""},
    {"cax-adc", ":d a owl:AllDisjointClasses ; owl:members ( :B :C :D ) . :a a :D , :B .", ""},
    {"scm-sco", ":C rdfs:subClassOf :D . :D rdfs:subClassOf :E .", ":C rdfs:subClassOf :E"},
    {"scm-eqc1", ":C owl:equivalentClass :D .", ":C rdfs:subClassOf :D"},
    {"scm-eqc1", ":C owl:equivalentClass :D .", ":D rdfs:subClassOf :C"},
    {"scm-cls", ":C owl:sameAs :D . :C a owl:Class .", ":D owl:equivalentClass :C"},
    {"scm-op", ":p owl:sameAs :q . :p a owl:ObjectProperty .", ":q owl:equivalentProperty :p"},
    {"scm-dp", ":p owl:sameAs :q . :p a owl:DatatypeProperty .", ":q rdfs:subPropertyOf :p"},
    {"scm-eqc2", ":C rdfs:subClassOf :D . :D rdfs:subClassOf :C .", ":C owl:equivalentClass :D"},
    {"scm-spo", ":p rdfs:subPropertyOf :q . :q rdfs:subPropertyOf :r .",
     ":p rdfs:subPropertyOf :r"},
    {"scm-eqp1", ":p owl:equivalentProperty :q .", ":q rdfs:subPropertyOf :p"},
    {"scm-eqp2", ":p rdfs:subPropertyOf :q . :q rdfs:subPropertyOf :p .",
     ":p owl:equivalentProperty :q"},
    {"scm-dom1", ":p rdfs:domain :C . :C rdfs:subClassOf :D .", ":p rdfs:domain :D"},
    {"scm-dom2", ":q rdfs:domain :C . :p rdfs:subPropertyOf :q .", ":p rdfs:domain :C"},
    {"scm-rng1", ":p rdfs:range :C . :C rdfs:subClassOf :D .", ":p rdfs:range :D"},
    {"scm-rng2", ":q rdfs:range :C . :p rdfs:subPropertyOf :q .", ":p rdfs:range :C"},
    {"scm-hv",
     ":C owl:hasValue :a ; owl:onProperty :p . :D owl:hasValue :a ; owl:onProperty :q . "
     ":p rdfs:subPropertyOf :q .",
     ":C rdfs:subClassOf :D"},
    {"scm-hv", ":C owl:hasValue :a ; owl:onProperty :p . :D owl:hasValue :a ; owl:onProperty :p .",
     ":C rdfs:subClassOf :D"},
    {"scm-svf1",
     ":C owl:someValuesFrom :Y ; owl:onProperty :p . :D owl:someValuesFrom :Z ; owl:onProperty :p ."
     " :Y rdfs:subClassOf :Z .",
     ":C rdfs:subClassOf :D"},
    {"scm-svf1",
     ":C owl:someValuesFrom :Y ; owl:onProperty :p . :D owl:someValuesFrom :Y ; owl:onProperty :p "
     ".",
     ":C rdfs:subClassOf :D"},
    {"scm-svf2",
     ":C owl:someValuesFrom :Y ; owl:onProperty :p . :D owl:someValuesFrom :Y ; owl:onProperty :q ."
     " :p rdfs:subPropertyOf :q .",
     ":C rdfs:subClassOf :D"},
    {"scm-avf1",
     ":C owl:allValuesFrom :Y ; owl:onProperty :p . :D owl:allValuesFrom :Z ; owl:onProperty :p . "
     ":Y rdfs:subClassOf :Z .",
     ":C rdfs:subClassOf :D"},
    {"scm-avf1",
     ":C owl:allValuesFrom :Y ; owl:onProperty :p . :D owl:allValuesFrom :Y ; owl:onProperty :p .",
     ":C rdfs:subClassOf :D"},
    {"scm-avf2",
     ":C owl:allValuesFrom :Y ; owl:onProperty :p . :D owl:allValuesFrom :Y ; owl:onProperty :q . "
     ":p rdfs:subPropertyOf :q .",
     ":D rdfs:subClassOf :C"},
    {"scm-int", ":C owl:intersectionOf ( :D :E ) .", ":C rdfs:subClassOf :E"},
    {"scm-uni", ":C owl:unionOf ( :D :E ) .", ":D rdfs:subClassOf :C"},
};

std::shared_ptr<rdf::Dictionary> NewDictionary() { return std::make_shared<rdf::Dictionary>(); }

bool Finds(const Case& wanted, const std::string& text) {
  const auto dictionary = NewDictionary();
  const auto layer = Materialise(rdf::View(dictionary), {GraphOf(text, *dictionary)});
  if (wanted.follows[0] != '\0') {
    return rdf::View(dictionary).With(layer).Contains(TripleOf(wanted.follows, *dictionary));
  }
  return std::any_of(layer->clashes().begin(), layer->clashes().end(),
                     [&](const rdf::Clash& clash) { return clash.rule == wanted.rule; });
}

std::vector<std::string> StatementsOf(const std::string& text) {
  std::vector<std::string> statements;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(" .", begin), text.size() - 2) + 2;
    statements.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return statements;
}

TEST(OwlRulesTest, EachRuleFindsWhatFollows) {
  for (const Case& each : kCases) {
    EXPECT_TRUE(Finds(each, each.given)) << each.rule << ": " << each.given;
  }
}

TEST(OwlRulesTest, EachRuleNeedsAllItsPremises) {
  for (const Case& each : kCases) {
    const std::vector<std::string> statements = StatementsOf(each.given);
    for (std::size_t left_out = 0; left_out < statements.size(); ++left_out) {
      std::string rest;
      for (std::size_t i = 0; i < statements.size(); ++i) {
        if (i != left_out) rest += statements[i] + " ";
      }
      EXPECT_FALSE(Finds(each, rest)) << each.rule << " without " << statements[left_out];
    }
  }
}

TEST(OwlRulesTest, EveryRowOfTheTableHasItsCase) {
  std::multiset<std::string> cases;
  for (const Case& each : kCases) cases.insert(each.rule);
  std::multiset<std::string> rows;
  for (const RuleRow& row : RuleTable()) rows.insert(row.name);
  for (const std::string& name : std::set<std::string>(rows.begin(), rows.end())) {
    EXPECT_GE(cases.count(name), rows.count(name)) << name;
  }
}

TEST(OwlRulesTest, CardinalityIsReadByValueAndOnlyFromNumbers) {
  using rdf::Term;
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  EXPECT_TRUE(HasValue(Term::Literal("1", xsd + "nonNegativeInteger").view(), 1));
  EXPECT_TRUE(HasValue(Term::Literal(" +01 ", xsd + "integer").view(), 1));
  EXPECT_FALSE(HasValue(Term::Literal("10", xsd + "integer").view(), 1));
  EXPECT_FALSE(HasValue(Term::Literal("1x", xsd + "integer").view(), 1));
  EXPECT_FALSE(HasValue(Term::Literal("1").view(), 1));
  EXPECT_FALSE(HasValue(Term::Literal("1", "http://example.org/integer").view(), 1));
  EXPECT_FALSE(HasValue(Term::Iri("1").view(), 1));
}

}  // namespace
}  // namespace lares::owl
