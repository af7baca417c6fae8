// Backups: all rows and blobs of one moment, as a store over SQLite of its own, and back.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/sqlite.h"
#include "server/store/store.h"

namespace lares::store {

// SHA-256 over every row of every table that is kept, in the caller's transaction.
std::string DigestOf(Database& database);

// A backup in the making. Dropped before Finish it leaves a folder without backup.json, which
// nothing takes for a backup.
class BackupTarget {
 public:
  // Throws kConflict unless `folder` is absent or empty.
  explicit BackupTarget(const std::filesystem::path& folder);

  // In the caller's transaction on `from`.
  void CopyRows(Database& from);
  // Every blob that the rows refer to, from below the folder `from`. Throws kIo for a damaged one.
  void CopyBlobs(const std::filesystem::path& from, const Progress& progress);
  // Syncs, and writes backup.json.
  BackupReport Finish();

 private:
  std::filesystem::path folder_;
  Health health_;
  BlobFolder blobs_;
  std::unique_ptr<SqliteDatabase> database_;
  BackupReport report_;
};

// A finished backup. Throws kInvalid where there is none, or one of another schema.
class BackupSource {
 public:
  explicit BackupSource(const std::filesystem::path& folder);

  // Throws kInvalid for a blob that is absent or damaged.
  void CopyBlobs(BlobFolder& into, const Progress& progress) const;
  // In the caller's transaction on `into`, which has the tables. Throws kConflict when it has rows,
  // kInvalid when the rows are not those that the backup was made of.
  BackupReport CopyRows(Database& into) const;

 private:
  std::filesystem::path folder_;
  BackupReport report_;  // as backup.json has it
  std::unique_ptr<SqliteDatabase> database_;
};

}  // namespace lares::store
