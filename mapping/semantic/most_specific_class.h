// Which of its classes says most about a thing.
#pragma once

#include <optional>

#include "mapping/semantic/names.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// A class asserted of `thing` of which no other of its classes, asserted or inferred, is a strict
// subclass; owl:NamedIndividual, owl:Thing and MapObject do not count. Of several the first by IRI.
// Without an asserted one that qualifies, an inferred one; nothing when it has no class.
std::optional<rdf::TermId> MostSpecificClass(const rdf::View& view, const Names& names,
                                             rdf::TermId thing);

}  // namespace lares::semantic
