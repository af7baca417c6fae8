// Whether what the database says agrees with itself and with the blobs.
#pragma once

#include <string>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/database.h"

namespace lares::store {

// One sentence for each thing that is wrong. Runs in the caller's transaction; the bytes of blobs
// are BlobFolder::Verify's part.
std::vector<std::string> VerifyRows(Database& database, const BlobFolder& blobs);

}  // namespace lares::store
