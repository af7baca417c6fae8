// Each construct of OWL 2 in functional syntax, in OWL/XML and as the triples that the mapping to
// RDF gives it (OWL 2 Mapping to RDF Graphs, W3C 2012, table 1 and sections 2.2 and 2.3).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lares::rdf::testing {

struct MappingRow {
  std::string_view name;
  std::string_view functional;
  // {C a}, {P a}, {D a}, {A a}, {T a}, {I a}: Class, ObjectProperty, DataProperty,
  // AnnotationProperty, Datatype, NamedIndividual; {N a}: AnonymousIndividual; {L a}: Literal;
  // {U a}: AbbreviatedIRI.
  std::string_view xml;
  std::string_view turtle;
  // What the reverse mapping needs to know which properties hold data: declarations in Turtle.
  std::string_view declarations = "";
};

const std::vector<MappingRow>& MappingTable();

// Whole documents around a row's text.
std::string FunctionalText(std::string_view axioms);
std::string OwlXmlText(std::string_view axioms);
std::string TurtleText(std::string_view statements);

}  // namespace lares::rdf::testing
