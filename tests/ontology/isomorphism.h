// Whether two documents say the same, whatever their blank nodes are called.
#pragma once

#include <string>

#include "ontology/rdf/document.h"

namespace lares::rdf::testing {

// True when a renaming of blank nodes makes the sets of statements (with their graphs) equal.
bool AreIsomorphic(const Document& a, const Document& b);

// The statements as sorted N-Quads lines, for messages.
std::string Lines(const Document& document);

}  // namespace lares::rdf::testing
