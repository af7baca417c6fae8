#include "server/cli/store_place.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

fs::path DefaultDataFolder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data == '/') {
    return fs::path(data) / "lares" / "store";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return fs::path(home) / ".local" / "share" / "lares" / "store";
  }
  throw Error(Code::kInvalid, "neither HOME nor XDG_DATA_HOME is set")
      .WithHint("say where to keep the data with --data");
}

}  // namespace

bool IsNamed(const StorePlace& place) { return !place.data.empty() || !place.store.empty(); }

void AddStorePlace(CLI::App& command, StorePlace& place) {
  const auto not_empty = [](const std::string& text) {
    return text.empty() ? std::string("names nothing") : std::string();
  };
  auto* data = command
                   .add_option("--data", place.data,
                               "folder that everything is kept in (default: "
                               "~/.local/share/lares/store)")
                   ->check(not_empty);
  auto* store = command
                    .add_option("--store", place.store,
                                "instead, a PostgreSQL database, which several servers may share: "
                                "postgresql://USER@HOST/NAME")
                    ->check(not_empty);
  auto* blobs =
      command
          .add_option("--blobs", place.blobs,
                      "with --store: the folder of the files themselves, the same one for "
                      "every server")
          ->check(not_empty);
  store->needs(blobs)->excludes(data);
  blobs->needs(store);
}

std::unique_ptr<store::Store> OpenStore(const StorePlace& place) {
  if (!place.store.empty()) return store::OpenPostgresStore({place.store, place.blobs});
  return store::OpenSqliteStore({DataFolder(place)});
}

std::string DataFolder(const StorePlace& place) {
  if (!place.store.empty()) throw Error(Code::kInvalid, "this is for a store in a folder (--data)");
  return place.data.empty() ? DefaultDataFolder().string() : place.data;
}

std::string OptionsOf(const StorePlace& place) {
  if (place.store.empty()) return "--data '" + DataFolder(place) + "'";
  return "--store URL --blobs '" + place.blobs + "'";
}

std::string Describe(const StorePlace& place) {
  if (place.store.empty()) return DataFolder(place);
  // postgresql://user:secret@host/name, or host=… password=…
  std::string shown = place.store;
  if (const std::size_t at = shown.rfind('@'); at != std::string::npos) {
    const std::size_t user = shown.find("://");
    const std::size_t colon = user == std::string::npos ? user : shown.find(':', user + 3);
    if (colon < at) shown.replace(colon, at - colon, ":…");
  }
  if (const std::size_t secret = shown.find("password="); secret != std::string::npos) {
    shown.replace(secret, shown.find(' ', secret) - secret, "password=…");
  }
  return "PostgreSQL " + shown + " with blobs in " + place.blobs;
}

}  // namespace lares::cli
