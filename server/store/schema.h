// The tables of lares.sqlite and their version.
#pragma once

#include <filesystem>

#include "server/store/sqlite.h"

namespace lares::store {

// Sets the connection up for durable writing (WAL, synchronous FULL) and creates the tables in an
// empty database. Throws kInvalid when a newer schema made it, or when it is not a store.
void PrepareForWriting(Database& database, const std::filesystem::path& file);

}  // namespace lares::store
