// What refers to a blob: only such blobs are given to those who know their hash.
#pragma once

#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// As the member of Store, in the caller's transaction.
std::vector<BlobUse> BlobUses(Database& database, const std::string& sha256);

// Finds them by the hash.
inline constexpr const char* kBlobUseIndexes = R"sql(
CREATE INDEX IF NOT EXISTS layers_by_blob ON layers (sha256);
CREATE INDEX IF NOT EXISTS document_versions_by_blob ON document_versions (sha256);
)sql";

}  // namespace lares::store
