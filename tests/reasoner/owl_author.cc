#include "tests/reasoner/owl_author.h"

#include <string_view>
#include <vector>

namespace lares::testing {
namespace {

// I, C, R, P and L stand for a name of that kind.
const std::vector<std::string_view>& Shapes() {
  static const std::vector<std::string_view> shapes = {
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
      "P a owl:IrreflexiveProperty",
      "P a owl:AsymmetricProperty",
      "P owl:propertyDisjointWith P",
      "P owl:propertyChainAxiom ( P P )",
      "P owl:propertyChainAxiom L",
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
      "R owl:someValuesFrom C",
      "R owl:someValuesFrom C",
      "R owl:someValuesFrom owl:Thing",
      "R owl:allValuesFrom C",
      "R owl:allValuesFrom C",
      "R owl:hasValue I",
      "R owl:maxCardinality 0",
      "R owl:maxQualifiedCardinality 0 ; owl:onClass C",
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

const std::vector<std::string_view>& ShapesOfEquality() {
  static const std::vector<std::string_view> shapes = {
      "P a owl:FunctionalProperty",
      "P a owl:InverseFunctionalProperty",
      "C owl:hasKey ( P )",
      "C owl:hasKey ( P P )",
      "I owl:sameAs I",
      "C owl:sameAs C",
      "P owl:sameAs P",
      "R owl:onProperty P ; owl:maxCardinality 1",
      "R owl:onProperty P ; owl:maxQualifiedCardinality 1 ; owl:onClass C",
      "R owl:maxCardinality 1",
      "R owl:maxQualifiedCardinality 1 ; owl:onClass C",
      "R owl:maxQualifiedCardinality 1 ; owl:onClass owl:Thing",
  };
  return shapes;
}

}  // namespace

std::string Author::Statement() {
  const unsigned plain = static_cast<unsigned>(Shapes().size());
  const unsigned all = plain + static_cast<unsigned>(ShapesOfEquality().size());
  const unsigned drawn = Below(equality_ ? all : plain);
  std::string statement;
  for (const char c : drawn < plain ? Shapes()[drawn] : ShapesOfEquality()[drawn - plain]) {
    const bool begins_word = statement.empty() || statement.back() == ' ';
    if (begins_word && std::string_view("ICPRL").find(c) != std::string_view::npos) {
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
