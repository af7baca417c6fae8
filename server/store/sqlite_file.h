// The file of a store over SQLite.
#pragma once

#include <filesystem>

#include "server/store/sqlite.h"

namespace lares::store {

inline constexpr const char* kDatabaseFile = "lares.sqlite";

// Sets the connection up for durable writing (WAL, synchronous FULL) and creates the tables in an
// empty database. Throws kInvalid when an older or newer schema made it, or when it is not a store.
void PrepareForWriting(SqliteDatabase& database, const std::filesystem::path& file);

// What SQLite finds wrong with the file; one sentence for each.
std::vector<std::string> VerifySqliteFile(Database& database);

}  // namespace lares::store
