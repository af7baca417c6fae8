// Why a document is not OWL 2 RL (OWL 2 Profiles, W3C 2012, 4.2).
#pragma once

#include "reasoner/profile/collector.h"
#include "reasoner/profile/document_index.h"

namespace lares::profile {

// Class expressions where RL's grammar does not have them, data ranges, datatypes and axioms that
// it lacks. Linear in the document.
void CheckProfile(const DocumentIndex& index, Collector& found);

}  // namespace lares::profile
