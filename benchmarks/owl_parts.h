// Which axioms of an ontology are valid OWL 2 DL together, and which of those are OWL 2 RL.
#pragma once

#include <string>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/owl_syntax/rdf_to_axioms.h"

namespace lares::bench {

struct OwlParts {
  std::vector<rdf::OwlNode> dl;     // logical axioms and declarations, without annotations
  std::vector<rdf::OwlNode> rl;     // those of `dl` that keep to OWL 2 Profiles, section 4.2
  std::vector<std::string> not_dl;  // a line for each axiom left out, with the reason
  std::vector<std::string> punned;  // a line for each term used as several kinds of thing
};

// What DL asks beyond the structure (OWL 2 Structural Specification, 11.2 and 5.9.2): simple
// properties where they are due, no property of two kinds, no class that is a datatype.
OwlParts PartsOf(const rdf::Document& document, const std::vector<rdf::OwlNode>& axioms);

}  // namespace lares::bench
