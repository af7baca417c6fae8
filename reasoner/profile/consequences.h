// What follows from a document that should not: contradictions and classes without members.
#pragma once

#include <stop_token>

#include "ontology/rdf/aliases.h"
#include "ontology/triples/view.h"
#include "reasoner/profile/collector.h"
#include "reasoner/profile/document_index.h"

namespace lares::profile {

// Closes the document over the catalogue, and then once more with a new individual for each class
// that the document declares: where that contradicts, the class can have no member. Throws as
// owl::Materialise.
void CheckConsequences(const DocumentIndex& index, const rdf::View& catalogue,
                       const rdf::AliasTable& aliases, Collector& found, std::stop_token stop);

}  // namespace lares::profile
