// An ontology's axioms in OWL 2's own syntaxes.
#pragma once

#include <string>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/owl_syntax/rdf_to_axioms.h"

namespace lares::rdf {

// `ontology` is of `document`, whose terms are well-formed.
std::string PrintFunctional(const Document& document, const OwlOntology& ontology);
// Throws kInvalid for a literal with a character that XML cannot hold.
std::string PrintOwlXml(const Document& document, const OwlOntology& ontology);

}  // namespace lares::rdf
