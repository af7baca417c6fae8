// A small reader of N-Triples for facts of tests, independent of the project's own readers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ontology/triples/dictionary.h"
#include "ontology/triples/graph.h"

namespace lares::testing {

// Sorted and distinct. One triple a line; blank lines and comments may be between. Prefixed names
// as in Turtle are read too, for the prefixes of the rules' table (rdf, rdfs, owl, xsd, lares) and
// `x:`, which is http://x/. Throws kInvalid with the line.
std::vector<rdf::Triple> ReadNTriples(std::string_view text, const std::string& source,
                                      rdf::Dictionary& dictionary);

}  // namespace lares::testing
