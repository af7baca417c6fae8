// The tables of a store and their version; the same in SQLite and PostgreSQL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/store/database.h"

namespace lares::store {

inline constexpr int kSchemaVersion = 3;

// In an empty database; in the caller's transaction.
void CreateTables(Database& database);

int ReadSchemaVersion(Database& database);
// Throws kInvalid unless `version` is kSchemaVersion; of an older one the hint is the command.
void CheckSchemaVersion(int version, const std::string& name, const std::string& migrate_command);
// From an older version, in the caller's transaction.
void MigrateTables(Database& database, int version);

// A table as it is copied and hashed.
struct ContentTable {
  std::string name;
  std::vector<std::string> columns;
  std::string order;     // of its rows, the same in every copy
  bool has_key = false;  // its first column is given by the database
};
// What is kept, tables that others refer to first.
const std::vector<ContentTable>& ContentTables();

}  // namespace lares::store
