// Which terms are used and nowhere declared, and which are used as two things at once.
#pragma once

#include "ontology/rdf/aliases.h"
#include "ontology/triples/view.h"
#include "reasoner/profile/collector.h"
#include "reasoner/profile/document_index.h"

namespace lares::profile {

// Declarations count in the document and in the catalogue, under canonical names.
void CheckDeclarations(const DocumentIndex& index, const rdf::View& catalogue,
                       const rdf::AliasTable& aliases, Collector& found);

}  // namespace lares::profile
