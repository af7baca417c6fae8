#include "tests/reasoner/random_ontology.h"

#include <iterator>
#include <string_view>
#include <vector>

namespace lares::testing {
namespace {

const std::vector<std::string>& Shapes() {
  static const std::vector<std::string> shapes = {
      "I a C",
      "I a C",
      "I a R",
      "I P I",
      "I P I",
      "I P I",
      "I P I",
      "I P 1",
      "I P \"text\"",
      "C rdfs:subClassOf C",
      "C rdfs:subClassOf C",
      "C rdfs:subClassOf R",
      "R rdfs:subClassOf C",
      "C owl:equivalentClass R",
      "C owl:equivalentClass C",
      "P rdfs:subPropertyOf P",
      "P rdfs:subPropertyOf P",
      "P owl:equivalentProperty P",
      "P rdfs:domain C",
      "P rdfs:range C",
      "P owl:inverseOf P",
      "P a owl:TransitiveProperty",
      "P a owl:SymmetricProperty",
      "P a owl:FunctionalProperty",
      "P a owl:InverseFunctionalProperty",
      "P a owl:IrreflexiveProperty",
      "P a owl:AsymmetricProperty",
      "P owl:propertyDisjointWith P",
      "P owl:propertyChainAxiom ( P P )",
      "P owl:propertyChainAxiom L",
      "C owl:hasKey ( P )",
      "C owl:hasKey ( P P )",
      "I owl:sameAs I",
      "C owl:sameAs C",
      "P owl:sameAs P",
      "I owl:differentFrom I",
      "C owl:disjointWith C",
      "C owl:complementOf C",
      "C owl:intersectionOf ( C R C )",
      "C owl:intersectionOf ( C C )",
      "C owl:intersectionOf L",
      "C owl:unionOf ( C C )",
      "C owl:unionOf L",
      "C owl:oneOf ( I I )",
      "R owl:onProperty P",
      "R owl:onProperty P ; owl:someValuesFrom C",
      "R owl:onProperty P ; owl:allValuesFrom C",
      "R owl:onProperty P ; owl:hasValue I",
      "R owl:onProperty P ; owl:maxCardinality 1",
      "R owl:onProperty P ; owl:maxQualifiedCardinality 1 ; owl:onClass C",
      "R owl:someValuesFrom C",
      "R owl:someValuesFrom C",
      "R owl:someValuesFrom owl:Thing",
      "R owl:allValuesFrom C",
      "R owl:allValuesFrom C",
      "R owl:hasValue I",
      "R owl:maxCardinality 0",
      "R owl:maxCardinality 1",
      "R owl:maxQualifiedCardinality 1 ; owl:onClass C",
      "R owl:maxQualifiedCardinality 0 ; owl:onClass C",
      "R owl:maxQualifiedCardinality 1 ; owl:onClass owl:Thing",
      "_:d a owl:AllDisjointClasses ; owl:members ( C C C )",
      "_:e a owl:AllDisjointProperties ; owl:members ( P P )",
      "_:f a owl:AllDifferent ; owl:members ( I I I )",
      "_:g a owl:AllDifferent ; owl:distinctMembers ( I I )",
      "_:n owl:sourceIndividual I ; owl:assertionProperty P ; owl:targetIndividual I",
      "_:m owl:sourceIndividual I ; owl:assertionProperty P ; owl:targetValue 1",
      "L rdf:first C",
      "L rdf:rest rdf:nil",
      "I a owl:Nothing",
      "I a owl:Thing",
      "C rdfs:subClassOf owl:Thing",
      "C rdfs:subClassOf C ; owl:equivalentClass C",
  };
  return shapes;
}

constexpr std::string_view kShapesOfValues[] = {
    "I P \"01\"^^xsd:integer",
    "I P \"1.0\"^^xsd:decimal",
    "I P \"x\"^^xsd:integer",
    "I owl:sameAs 1",
    "P rdfs:range xsd:integer",
    "R owl:onProperty P ; owl:hasValue \"1.0\"^^xsd:decimal",
    "R owl:someValuesFrom xsd:integer",
    "xsd:integer rdfs:subClassOf C",
    "C a owl:Class",
    "P a owl:ObjectProperty",
};

bool MakesEqual(std::string_view shape) {
  for (const std::string_view word : {"owl:sameAs", "FunctionalProperty", "owl:hasKey",
                                      "owl:maxCardinality 1", "owl:maxQualifiedCardinality 1"}) {
    if (shape.find(word) != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

std::string_view Author::Shape() {
  const std::size_t values = values_ ? std::size(kShapesOfValues) : 0;
  while (true) {
    const std::size_t at = random_() % (Shapes().size() + values);
    const std::string_view shape =
        at < Shapes().size() ? Shapes()[at] : kShapesOfValues[at - Shapes().size()];
    if (equality_ || !MakesEqual(shape)) return shape;
  }
}

std::string Author::Statement() {
  std::string statement;
  for (const char c : Shape()) {
    const bool begins_word = statement.empty() || statement.back() == ' ';
    if (begins_word && std::string("ICPRL").find(c) != std::string::npos) {
      statement += Name(c);
    } else {
      statement += c;
    }
  }
  return statement + " .\n";
}

std::string Author::Text(int statements) {
  std::string text;
  for (int i = 0; i < statements; ++i) text += Statement();
  return text;
}

std::string Author::Name(char kind) {
  const unsigned count = kind == 'L' ? 2 : kind == 'I' ? 5 : 3;
  return std::string(":") + kind + std::to_string(Below(count));
}

}  // namespace lares::testing
