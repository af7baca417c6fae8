// Small graphs for tests, written as text.
#pragma once

#include <string>
#include <string_view>

#include "ontology/rdf/document.h"
#include "ontology/triples/graph.h"
#include "ontology/triples/view.h"

namespace lares::testing {

// A subset of Turtle: statements with ';' and ',', 'a', lists in (), blank nodes _:x, <iri>, rdf:,
// rdfs:, owl:, xsd: names, :x (http://example.org/x), "text", "text"@en, "1"^^xsd:int, 1. Tokens
// are separated by blanks. Throws Error on anything else.
rdf::Document ParseText(std::string_view text);

// N-Triples without escapes or comments: for large files in measurements and tests.
rdf::Document ParseNTriples(std::string_view text);

rdf::Graph GraphOf(std::string_view text, rdf::Dictionary& dictionary,
                   std::string_view name = "test");

// The id of one term written as above; interns it.
rdf::TermId TermOf(std::string_view term, rdf::Dictionary& dictionary);
// One triple, "s p o".
rdf::Triple TripleOf(std::string_view triple, rdf::Dictionary& dictionary);
// "s p o" with N-Triples terms.
std::string ToText(const rdf::Triple& triple, const rdf::Dictionary& dictionary);

}  // namespace lares::testing
