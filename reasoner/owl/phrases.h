// Triples as people would say them.
#pragma once

#include <string>

#include "ontology/triples/view.h"

namespace lares::owl {

// A label; literals in quotes; anonymous classes as what they say: "(hasPart some Wheel)",
// "(Cup and Metal)", nested three deep.
std::string PhraseOf(rdf::TermId term, const rdf::View& view);
// "Cup1 a Container", "Cup subClassOf Container"; "contradiction" for the empty triple.
std::string PhraseOf(const rdf::Triple& triple, const rdf::View& view);

// One term of N-Triples.
std::string ToNTriples(rdf::TermId term, const rdf::View& view);

// rdf:first or rdf:rest: what a picture of a proof does without.
bool IsListCell(const rdf::Triple& triple, const rdf::View& view);

}  // namespace lares::owl
