#include "server/store/sqlite_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "server/store/files.h"
#include "server/store/folder_lock.h"
#include "server/store/schema.h"
#include "server/store/store.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

std::string Named(const fs::path& file) { return "'" + file.string() + "'"; }

bool HasTables(Database& database) {
  return database.AskInt("SELECT count(*) FROM sqlite_master") > 0;
}

void CheckIsStore(Database& database, const fs::path& file) {
  if (database.AskInt("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND "
                      "name = 'schema_version'") == 0) {
    throw Error(Code::kInvalid, Named(file) + " is a database, but not a store of Lares");
  }
}

void UseLog(Database& database, const fs::path& file) {
  Query query = database.Ask("PRAGMA journal_mode = WAL");
  std::string mode;
  // To the last row: the change is written after the row that announces it.
  while (query.Next()) mode = query.Text(0);
  if (mode == "wal") return;
  throw Error(Code::kIo, Named(file) + " cannot use a write-ahead log here")
      .WithHint("put the store on a local file system");
}

void SetUp(Database& database, const fs::path& file) {
  UseLog(database, file);
  database.Run("PRAGMA synchronous = FULL");
  database.Run("PRAGMA foreign_keys = ON");
  database.Run("PRAGMA temp_store = MEMORY");
}

void SyncFile(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = fd >= 0 && ::fsync(fd) == 0;
  const int error = errno;
  if (fd >= 0) ::close(fd);
  if (!synced) throw Error(Code::kIo, "cannot sync " + Named(file) + ": " + std::strerror(error));
}

// The database, whole, beside itself.
fs::path KeepOld(SqliteDatabase& database, const fs::path& file, int version) {
  fs::path kept = file;
  kept += ".schema-" + std::to_string(version);
  for (int n = 2; fs::exists(kept); ++n) {
    kept = file;
    kept += ".schema-" + std::to_string(version) + "-" + std::to_string(n);
  }
  database.CheckpointWhole();
  database.Run("VACUUM INTO ?", {kept.string()});
  SyncFile(kept);
  RealFiles().SyncFolder(file.parent_path());
  return kept;
}

}  // namespace

void PrepareForWriting(SqliteDatabase& database, const fs::path& file) {
  // Looked at before anything is changed: a file of somebody else stays as it is.
  const bool created = !HasTables(database);
  if (!created) {
    CheckIsStore(database, file);
    CheckSchemaVersion(ReadSchemaVersion(database), Named(file),
                       "lares store migrate --data " + file.parent_path().string());
  }
  SetUp(database, file);
  if (!created) return;
  Transaction transaction(database, Transaction::Kind::kWrite);
  CreateTables(database);
  transaction.Commit();
}

std::vector<std::string> VerifySqliteFile(Database& database) {
  std::vector<std::string> problems;
  Query pages = database.Ask("PRAGMA integrity_check");
  while (pages.Next()) {
    if (pages.Text(0) != "ok") problems.push_back("database: " + pages.Text(0));
  }
  Query keys = database.Ask("PRAGMA foreign_key_check");
  while (keys.Next()) {
    problems.push_back("database: a row of " + keys.Text(0) + " refers to no row of " +
                       keys.Text(2));
  }
  return problems;
}

MigrationReport MigrateSqliteStore(const StoreOptions& options) {
  const fs::path folder = fs::absolute(options.folder).lexically_normal();
  const fs::path file = folder / kDatabaseFile;
  if (!fs::is_regular_file(file)) {
    throw Error(Code::kNotFound, "there is no store in " + Named(folder));
  }
  const FolderLock lock(folder / "lock");
  SqliteDatabase database(file, SqliteDatabase::Access::kWrite, "");
  CheckIsStore(database, file);
  MigrationReport report{ReadSchemaVersion(database), kSchemaVersion, {}};
  if (report.from == kSchemaVersion) return report;
  if (report.from < 1 || report.from > kSchemaVersion) {
    CheckSchemaVersion(report.from, Named(file), "");
  }
  SetUp(database, file);
  report.kept_file = KeepOld(database, file, report.from);
  Transaction transaction(database, Transaction::Kind::kWrite);
  MigrateTables(database, report.from);
  transaction.Commit();
  database.CheckpointWhole();
  database.TidyOnClose();
  return report;
}

}  // namespace lares::store
