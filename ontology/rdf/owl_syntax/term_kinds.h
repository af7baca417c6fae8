// What kind of entity each term is, where declarations are missing too: an ontology often uses
// terms that only its imports declare.
#pragma once

#include <cstdint>
#include <vector>

#include "ontology/rdf/owl_syntax/owl_graph.h"

namespace lares::rdf {

enum TermKindBit : std::uint8_t {
  kIsClass = 1,
  kIsDatatype = 2,
  kIsObjectProperty = 4,
  kIsDataProperty = 8,
  kIsAnnotationProperty = 16,
  kIsIndividual = 32,
};

// By term index. Declared kinds, those that axioms leave no choice about, and for properties
// without any that of the properties they are sub-property of, equivalent or disjoint to.
std::vector<std::uint8_t> FindTermKinds(OwlGraph& graph);

// True for a datatype's IRI and for a blank node that is a data range.
bool IsDataRange(OwlGraph& graph, const std::vector<std::uint8_t>& kinds, std::uint32_t term);

}  // namespace lares::rdf
