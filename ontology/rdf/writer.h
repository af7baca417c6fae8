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
// node labels). RDF/XML: throws kInvalid for a predicate that no XML name can spell.
std::string WriteRdf(const Document& document, Format format);

}  // namespace lares::rdf
