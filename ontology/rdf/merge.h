// Several ontologies as one.
#pragma once

#include <vector>

#include "ontology/rdf/document.h"

namespace lares::rdf {

// All statements under the first ontology header that there is. Other headers go: their versions
// are dropped, their imports become the first one's, unless what they import is merged here, and
// what else is said of them stays. Blank nodes of different documents stay apart; a prefix means
// what the first document says.
Document MergeOntologies(const std::vector<Document>& documents);

}  // namespace lares::rdf
