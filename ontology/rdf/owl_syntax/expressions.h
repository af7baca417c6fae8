// Class, data range and property expressions of a graph as trees (Mapping to RDF Graphs, tables 11
// to 15).
#pragma once

#include <cstdint>
#include <vector>

#include "ontology/rdf/owl_syntax/owl_graph.h"
#include "ontology/rdf/owl_syntax/owl_node.h"
#include "ontology/rdf/owl_syntax/term_kinds.h"

namespace lares::rdf {

// Each function marks the triples that it uses and throws Unwritable for what is no such
// expression.
class Expressions {
 public:
  Expressions(OwlGraph& graph, const std::vector<std::uint8_t>& kinds)
      : graph_(graph), kinds_(kinds) {}

  OwlNode Class(std::uint32_t term);
  OwlNode Range(std::uint32_t term);
  OwlNode ObjectProperty(std::uint32_t term);
  OwlNode DataProperty(std::uint32_t term) const { return Entity(term); }
  OwlNode Individual(std::uint32_t term) const;
  OwlNode Literal(std::uint32_t term) const;
  OwlNode Entity(std::uint32_t term) const;  // an IRI
  // A class whose definition is in triples about its own IRI, as OWL 1 wrote it.
  OwlNode DefinitionOf(std::uint32_t iri, std::uint32_t statement);

  std::vector<OwlNode> Classes(std::uint32_t list);
  std::vector<OwlNode> Individuals(std::uint32_t list);
  std::vector<std::uint32_t> Items(std::uint32_t list);
  bool IsRange(std::uint32_t term) { return IsDataRange(graph_, kinds_, term); }

 private:
  struct Parts;  // the triples about an expression's node

  Parts PartsOf(std::uint32_t node);
  OwlNode Junction(Parts& parts, bool is_data);
  OwlNode Restriction(Parts& parts);
  OwlNode Cardinality(Parts& parts, std::uint32_t property);
  OwlNode RestrictedDatatype(Parts& parts);
  bool IsDataProperty(std::uint32_t property, bool by_filler) const;

  OwlGraph& graph_;
  const std::vector<std::uint8_t>& kinds_;
  int depth_ = 0;
};

}  // namespace lares::rdf
