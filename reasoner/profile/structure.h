// What is no OWL at all: lists, restrictions and axioms that do not have their parts.
#pragma once

#include "reasoner/profile/collector.h"
#include "reasoner/profile/document_index.h"

namespace lares::profile {

// Against the mapping from RDF graphs (OWL 2 Mapping to RDF, W3C 2012, 3.2), in linear time.
void CheckStructure(const DocumentIndex& index, Collector& found);

}  // namespace lares::profile
