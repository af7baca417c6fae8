// What makes a term well-formed, beyond what the parsers check.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ontology/rdf/term.h"

namespace lares::rdf {

// True for "scheme:…" with only characters that an IRI may have (RFC 3987 as RDF 1.1 uses it: none
// of U+0000–U+0020, <, >, ", {, }, |, \, ^, `).
bool IsAbsoluteIri(std::string_view iri);

// What is wrong with `term`, as a sentence without its end; nothing when it is well-formed.
std::optional<std::string> FaultOf(const TermView& term);

// True for a label that Turtle can write after "_:" (in ASCII; a label beyond ASCII counts as not).
bool IsBlankLabel(std::string_view label);

// `text` between quotes for a message, shortened when long, control characters as '?'.
std::string Quoted(std::string_view text);

}  // namespace lares::rdf
