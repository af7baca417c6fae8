// Where the data values of literals decide what follows.
#pragma once

#include "ontology/triples/view.h"

namespace lares::owl {

// Whether rules over `view` may conclude something from what literals mean, rather than from which
// terms they are: because a datatype is used as a class, a literal is a subject, or rules compare
// literals of which some are written in several ways. May be true needlessly.
bool DependsOnValues(const rdf::View& view);

}  // namespace lares::owl
