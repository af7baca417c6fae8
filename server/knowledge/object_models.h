// The stored object models as values.
#pragma once

#include <vector>

#include "server/knowledge/knowledge.h"

namespace lares::server {

// Of kObjectModel. What an older version did not keep is empty.
ObjectModelInfo ReadObjectModel(store::DocumentInfo document);
std::vector<ObjectModelInfo> StoredObjectModels(const store::Store& store);

// As the choice of models sees it.
models::Candidate ToCandidate(const ObjectModelInfo& info);

}  // namespace lares::server
