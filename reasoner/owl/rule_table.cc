// The rules of W3C OWL 2 Profiles (2012), section 4.3, tables 4 to 9.
//
// Reflexive and trivial conclusions are not stored (see IsTrivial in conclusions.cc) but hold on
// demand (on_demand.h), so eq-ref, scm-cls, scm-op and scm-dp have nothing to add here; where
// another rule would use such a premise, a second row of the same name does without it. The engine
// does without eq-sym, eq-trans and eq-rep-*: it keeps one representative of what is the same.
// Those of table 8, and of table 6 what is true without premises, are in datatypes.cc and
// on_demand.cc.
#include <array>

#include "reasoner/owl/rule.h"

namespace lares::owl {
namespace {

constexpr RuleRow kRules[] = {
    // Table 4: equality.
    {"eq-sym", 4, "", "?x owl:sameAs ?y", "?y owl:sameAs ?x"},
    {"eq-trans", 4, "", "?x owl:sameAs ?y . ?y owl:sameAs ?z", "?x owl:sameAs ?z"},
    {"eq-rep-s", 4, "?s owl:sameAs ?t", "?s ?p ?o", "?t ?p ?o"},
    {"eq-rep-p", 4, "?p owl:sameAs ?q", "?s ?p ?o", "?s ?q ?o"},
    {"eq-rep-o", 4, "?o owl:sameAs ?q", "?s ?p ?o", "?s ?p ?q"},
    {"eq-diff1", 4, "", "?x owl:sameAs ?y . ?x owl:differentFrom ?y", ""},
    {"eq-diff1", 4, "", "?x owl:differentFrom ?x", ""},
    {"eq-diff2", 4, "?x a owl:AllDifferent . ?x owl:members ?l . ?l LIST ?y ?z", "?y owl:sameAs ?z",
     ""},
    {"eq-diff3", 4, "?x a owl:AllDifferent . ?x owl:distinctMembers ?l . ?l LIST ?y ?z",
     "?y owl:sameAs ?z", ""},

    // Table 5: properties.
    {"prp-dom", 5, "?p rdfs:domain ?c", "?x ?p ?y", "?x a ?c"},
    {"prp-rng", 5, "?p rdfs:range ?c", "?x ?p ?y", "?y a ?c"},
    {"prp-fp", 5, "?p a owl:FunctionalProperty", "?x ?p ?y . ?x ?p ?z", "?y owl:sameAs ?z"},
    {"prp-ifp", 5, "?p a owl:InverseFunctionalProperty", "?x ?p ?z . ?y ?p ?z", "?x owl:sameAs ?y"},
    {"prp-irp", 5, "?p a owl:IrreflexiveProperty", "?x ?p ?x", ""},
    {"prp-symp", 5, "?p a owl:SymmetricProperty", "?x ?p ?y", "?y ?p ?x"},
    {"prp-asyp", 5, "?p a owl:AsymmetricProperty", "?x ?p ?y . ?y ?p ?x", ""},
    {"prp-trp", 5, "?p a owl:TransitiveProperty", "?x ?p ?y . ?y ?p ?z", "?x ?p ?z"},
    {"prp-spo1", 5, "?p rdfs:subPropertyOf ?q", "?x ?p ?y", "?x ?q ?y"},
    {"prp-spo2", 5, "?p owl:propertyChainAxiom ?l", "@chain", ""},
    {"prp-eqp1", 5, "?p owl:equivalentProperty ?q", "?x ?p ?y", "?x ?q ?y"},
    {"prp-eqp2", 5, "?p owl:equivalentProperty ?q", "?x ?q ?y", "?x ?p ?y"},
    {"prp-pdw", 5, "?p owl:propertyDisjointWith ?q", "?x ?p ?y . ?x ?q ?y", ""},
    {"prp-adp", 5, "?x a owl:AllDisjointProperties . ?x owl:members ?l . ?l LIST ?p ?q",
     "?u ?p ?v . ?u ?q ?v", ""},
    {"prp-inv1", 5, "?p owl:inverseOf ?q", "?x ?p ?y", "?y ?q ?x"},
    {"prp-inv2", 5, "?p owl:inverseOf ?q", "?x ?q ?y", "?y ?p ?x"},
    {"prp-key", 5, "?c owl:hasKey ?l", "@key", ""},
    {"prp-npa1", 5,
     "?x owl:sourceIndividual ?i . ?x owl:assertionProperty ?p . ?x owl:targetIndividual ?j",
     "?i ?p ?j", ""},
    {"prp-npa2", 5,
     "?x owl:sourceIndividual ?i . ?x owl:assertionProperty ?p . ?x owl:targetValue ?j", "?i ?p ?j",
     ""},

    // Table 6: classes.
    {"cls-nothing2", 6, "", "?x a owl:Nothing", ""},
    {"cls-int1", 6, "?c owl:intersectionOf ?l", "@intersection", ""},
    {"cls-int2", 6, "?c owl:intersectionOf ?l . ?l LIST ?d", "?x a ?c", "?x a ?d"},
    {"cls-uni", 6, "?c owl:unionOf ?l . ?l LIST ?d", "?x a ?d", "?x a ?c"},
    {"cls-com", 6, "?c owl:complementOf ?d", "?x a ?c . ?x a ?d", ""},
    {"cls-svf1", 6, "?x owl:someValuesFrom ?y . ?x owl:onProperty ?p", "?u ?p ?v . ?v a ?y",
     "?u a ?x"},
    {"cls-svf2", 6, "?x owl:someValuesFrom owl:Thing . ?x owl:onProperty ?p", "?u ?p ?v",
     "?u a ?x"},
    {"cls-avf", 6, "?x owl:allValuesFrom ?y . ?x owl:onProperty ?p", "?u a ?x . ?u ?p ?v",
     "?v a ?y"},
    {"cls-hv1", 6, "?x owl:hasValue ?y . ?x owl:onProperty ?p", "?u a ?x", "?u ?p ?y"},
    {"cls-hv2", 6, "?x owl:hasValue ?y . ?x owl:onProperty ?p", "?u ?p ?y", "?u a ?x"},
    {"cls-maxc1", 6, "?x owl:maxCardinality 0 . ?x owl:onProperty ?p", "?u a ?x . ?u ?p ?y", ""},
    {"cls-maxc2", 6, "?x owl:maxCardinality 1 . ?x owl:onProperty ?p",
     "?u a ?x . ?u ?p ?y . ?u ?p ?z", "?y owl:sameAs ?z"},
    {"cls-maxqc1", 6, "?x owl:maxQualifiedCardinality 0 . ?x owl:onProperty ?p . ?x owl:onClass ?c",
     "?u a ?x . ?u ?p ?y . ?y a ?c", ""},
    {"cls-maxqc2", 6,
     "?x owl:maxQualifiedCardinality 0 . ?x owl:onProperty ?p . ?x owl:onClass owl:Thing",
     "?u a ?x . ?u ?p ?y", ""},
    {"cls-maxqc3", 6, "?x owl:maxQualifiedCardinality 1 . ?x owl:onProperty ?p . ?x owl:onClass ?c",
     "?u a ?x . ?u ?p ?y . ?y a ?c . ?u ?p ?z . ?z a ?c", "?y owl:sameAs ?z"},
    {"cls-maxqc4", 6,
     "?x owl:maxQualifiedCardinality 1 . ?x owl:onProperty ?p . ?x owl:onClass owl:Thing",
     "?u a ?x . ?u ?p ?y . ?u ?p ?z", "?y owl:sameAs ?z"},
    {"cls-oo", 6, "?c owl:oneOf ?l . ?l LIST ?y", "", "?y a ?c"},

    // Table 7: class axioms.
    {"cax-sco", 7, "?c rdfs:subClassOf ?d", "?x a ?c", "?x a ?d"},
    {"cax-eqc1", 7, "?c owl:equivalentClass ?d", "?x a ?c", "?x a ?d"},
    {"cax-eqc2", 7, "?c owl:equivalentClass ?d", "?x a ?d", "?x a ?c"},
    {"cax-dw", 7, "?c owl:disjointWith ?d", "?x a ?c . ?x a ?d", ""},
    {"cax-adc", 7, "?x a owl:AllDisjointClasses . ?x owl:members ?l . ?l LIST ?c ?d",
     "?y a ?c . ?y a ?d", ""},

    // Table 9: schema vocabulary.
    {"scm-cls", 9, "", "?c owl:sameAs ?d . ?c a owl:Class",
     "?c rdfs:subClassOf ?d . ?c owl:equivalentClass ?d"},
    {"scm-op", 9, "", "?p owl:sameAs ?q . ?p a owl:ObjectProperty",
     "?p rdfs:subPropertyOf ?q . ?p owl:equivalentProperty ?q"},
    {"scm-dp", 9, "", "?p owl:sameAs ?q . ?p a owl:DatatypeProperty",
     "?p rdfs:subPropertyOf ?q . ?p owl:equivalentProperty ?q"},
    {"scm-sco", 9, "", "?c rdfs:subClassOf ?d . ?d rdfs:subClassOf ?e", "?c rdfs:subClassOf ?e"},
    {"scm-eqc1", 9, "", "?c owl:equivalentClass ?d",
     "?c rdfs:subClassOf ?d . ?d rdfs:subClassOf ?c"},
    {"scm-eqc2", 9, "", "?c rdfs:subClassOf ?d . ?d rdfs:subClassOf ?c",
     "?c owl:equivalentClass ?d"},
    {"scm-spo", 9, "", "?p rdfs:subPropertyOf ?q . ?q rdfs:subPropertyOf ?r",
     "?p rdfs:subPropertyOf ?r"},
    {"scm-eqp1", 9, "", "?p owl:equivalentProperty ?q",
     "?p rdfs:subPropertyOf ?q . ?q rdfs:subPropertyOf ?p"},
    {"scm-eqp2", 9, "", "?p rdfs:subPropertyOf ?q . ?q rdfs:subPropertyOf ?p",
     "?p owl:equivalentProperty ?q"},
    {"scm-dom1", 9, "", "?p rdfs:domain ?c . ?c rdfs:subClassOf ?d", "?p rdfs:domain ?d"},
    {"scm-dom2", 9, "", "?q rdfs:domain ?c . ?p rdfs:subPropertyOf ?q", "?p rdfs:domain ?c"},
    {"scm-rng1", 9, "", "?p rdfs:range ?c . ?c rdfs:subClassOf ?d", "?p rdfs:range ?d"},
    {"scm-rng2", 9, "", "?q rdfs:range ?c . ?p rdfs:subPropertyOf ?q", "?p rdfs:range ?c"},
    {"scm-hv", 9, "",
     "?c owl:hasValue ?i . ?c owl:onProperty ?p . ?d owl:hasValue ?i . ?d owl:onProperty ?q . "
     "?p rdfs:subPropertyOf ?q",
     "?c rdfs:subClassOf ?d"},
    {"scm-hv", 9, "",
     "?c owl:hasValue ?i . ?c owl:onProperty ?p . ?d owl:hasValue ?i . ?d owl:onProperty ?p",
     "?c rdfs:subClassOf ?d"},
    {"scm-svf1", 9, "",
     "?c owl:someValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:someValuesFrom ?z . "
     "?d owl:onProperty ?p . ?y rdfs:subClassOf ?z",
     "?c rdfs:subClassOf ?d"},
    {"scm-svf1", 9, "",
     "?c owl:someValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:someValuesFrom ?y . "
     "?d owl:onProperty ?p",
     "?c rdfs:subClassOf ?d"},
    {"scm-svf2", 9, "",
     "?c owl:someValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:someValuesFrom ?y . "
     "?d owl:onProperty ?q . ?p rdfs:subPropertyOf ?q",
     "?c rdfs:subClassOf ?d"},
    {"scm-avf1", 9, "",
     "?c owl:allValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:allValuesFrom ?z . "
     "?d owl:onProperty ?p . ?y rdfs:subClassOf ?z",
     "?c rdfs:subClassOf ?d"},
    {"scm-avf1", 9, "",
     "?c owl:allValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:allValuesFrom ?y . "
     "?d owl:onProperty ?p",
     "?c rdfs:subClassOf ?d"},
    {"scm-avf2", 9, "",
     "?c owl:allValuesFrom ?y . ?c owl:onProperty ?p . ?d owl:allValuesFrom ?y . "
     "?d owl:onProperty ?q . ?p rdfs:subPropertyOf ?q",
     "?d rdfs:subClassOf ?c"},
    {"scm-int", 9, "?c owl:intersectionOf ?l . ?l LIST ?d", "", "?c rdfs:subClassOf ?d"},
    {"scm-uni", 9, "?c owl:unionOf ?l . ?l LIST ?d", "", "?d rdfs:subClassOf ?c"},
};

constexpr AxiomRow kAxioms[] = {
    {"prp-ap", 5, "rdfs:label", "owl:AnnotationProperty"},
    {"prp-ap", 5, "rdfs:comment", "owl:AnnotationProperty"},
    {"prp-ap", 5, "rdfs:seeAlso", "owl:AnnotationProperty"},
    {"prp-ap", 5, "rdfs:isDefinedBy", "owl:AnnotationProperty"},
    {"prp-ap", 5, "owl:deprecated", "owl:AnnotationProperty"},
    {"prp-ap", 5, "owl:versionInfo", "owl:AnnotationProperty"},
    {"prp-ap", 5, "owl:priorVersion", "owl:AnnotationProperty"},
    {"prp-ap", 5, "owl:backwardCompatibleWith", "owl:AnnotationProperty"},
    {"prp-ap", 5, "owl:incompatibleWith", "owl:AnnotationProperty"},
    {"cls-thing", 6, "owl:Thing", "owl:Class"},
    {"cls-nothing1", 6, "owl:Nothing", "owl:Class"},
};

}  // namespace

std::span<const RuleRow> RuleTable() { return kRules; }

std::span<const AxiomRow> AxiomTable() { return kAxioms; }

}  // namespace lares::owl
