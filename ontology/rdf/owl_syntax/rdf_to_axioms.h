// Triples as OWL 2 axioms (Mapping to RDF Graphs, section 3), without looking at imports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/owl_syntax/owl_node.h"

namespace lares::rdf {

struct LeftOutTriple {
  Statement statement;
  std::string why;  // a clause
};

// Terms are those of the document.
struct OwlOntology {
  std::optional<std::uint32_t> iri, version;
  std::vector<std::uint32_t> imports;
  std::vector<OwlNode> annotations;
  std::vector<OwlNode> axioms;  // in the order of their first triple
};

struct AxiomsOfDocument {
  OwlOntology ontology;
  std::vector<LeftOutTriple> left_out;  // of no axiom, in the document's order
};

// Every triple of the default graph is in an axiom or left out. A property that is nowhere declared
// nor used so that its kind is certain is an object or data property where its subject is an
// individual, by its value, and else an annotation property. OWL 1's ways are understood
// (definitions about a class's own name, owl:DataRange, owl:distinctMembers, redundant rdfs:Class
// and rdf:Property). Throws kTooLarge for graphs built to explode.
AxiomsOfDocument AxiomsOf(const Document& document);

}  // namespace lares::rdf
