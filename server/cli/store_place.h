// Where a store is, as commands that open one themselves are told.
#pragma once

#include <memory>
#include <string>

#include "server/store/store.h"

namespace CLI {
class App;
}

namespace lares::cli {

struct StorePlace {
  std::string data;   // folder of a store over SQLite; empty: the default one
  std::string store;  // or a connection to PostgreSQL, with …
  std::string blobs;  // … the folder of its blobs
};

// Whether an option said which.
bool IsNamed(const StorePlace& place);
// --data, --store, --blobs.
void AddStorePlace(CLI::App& command, StorePlace& place);
// Throws as OpenSqliteStore and OpenPostgresStore.
std::unique_ptr<store::Store> OpenStore(const StorePlace& place);
// The folder of a store over SQLite. Throws kInvalid when --store names another one.
std::string DataFolder(const StorePlace& place);
// The options that name it, for hints.
std::string OptionsOf(const StorePlace& place);
// For people; without a password.
std::string Describe(const StorePlace& place);

}  // namespace lares::cli
