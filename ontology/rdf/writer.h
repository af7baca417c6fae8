// Writing RDF.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ontology/rdf/document.h"

namespace lares::rdf {

// Whether the format has named graphs.
bool HoldsGraphs(Format format);

// `document` in `format`: statements grouped by subject, prefixes used where they shorten, blank
// nodes used once written inline in Turtle. Reading the result gives the same graph (up to blank
// node labels). RDF/XML: throws kInvalid for a predicate that no XML name can spell. OWL's own
// syntaxes: throws kInvalid with the first triple that is part of no axiom, and reading the result
// gives the same graph but for an ontology header and types of expressions where there are none, an
// expression that several axioms share, which each gets of its own, and OWL 1's ways of saying
// something, which become OWL 2's.
std::string WriteRdf(const Document& document, Format format);

// True for OWL's own syntaxes, which hold axioms and not any graph.
bool HoldsOnlyAxioms(Format format);

struct OwlText {
  std::string text;
  std::vector<std::string> left_out;  // the triples of no axiom, as N-Triples, each with the reason
};

// The axioms of `document` in one of OWL's own syntaxes, whatever else it says.
OwlText WriteAxioms(const Document& document, Format format);

}  // namespace lares::rdf
