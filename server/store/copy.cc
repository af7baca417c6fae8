#include "server/store/copy.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/store/schema.h"
#include "server/store/sqlite_file.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "backup.json";
constexpr std::size_t kPieceBytes = 1 << 20;

std::string SelectAll(const ContentTable& table) {
  return "SELECT " + Join(table.columns, ", ") + " FROM " + table.name + " ORDER BY " + table.order;
}

std::string InsertInto(const ContentTable& table) {
  std::string marks;
  for (std::size_t i = 0; i < table.columns.size(); ++i) marks += i == 0 ? "?" : ", ?";
  return "INSERT INTO " + table.name + " (" + Join(table.columns, ", ") + ") VALUES (" + marks +
         ")";
}

void CopyTable(const ContentTable& table, Database& from, Database& into) {
  const std::string insert = InsertInto(table);
  std::vector<std::string> texts(table.columns.size());
  std::vector<Value> values(table.columns.size());
  from.Each(SelectAll(table), [&](const Cursor& row) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
      texts[i] = row.Text(static_cast<int>(i));
      values[i] = std::string_view(texts[i]);
    }
    into.Run(insert, values);
  });
}

// The next row that the database numbers itself gets a number of its own.
void ContinueNumbers(const ContentTable& table, Database& database) {
  if (!table.has_key || database.dialect() != Database::Dialect::kPostgres) return;
  database.Run("SELECT setval(pg_get_serial_sequence('" + table.name +
               "', 'key'), (SELECT coalesce(max(key), 1) FROM " + table.name + "))");
}

void CopyTables(Database& from, Database& into) {
  for (const ContentTable& table : ContentTables()) {
    CopyTable(table, from, into);
    ContinueNumbers(table, into);
  }
}

constexpr const char* kReferredBlobs =
    "SELECT sha256, max(size) FROM (SELECT sha256, size FROM document_versions UNION "
    "SELECT sha256, size FROM layers) AS referred GROUP BY sha256 ORDER BY sha256";

std::uint64_t ReferredBytes(Database& database) {
  return static_cast<std::uint64_t>(
      database.AskInt(std::string("SELECT coalesce(sum(size), 0) FROM (") +
                      "SELECT sha256, max(size) AS size FROM (SELECT sha256, size FROM "
                      "document_versions UNION SELECT sha256, size FROM layers) AS referred GROUP "
                      "BY sha256) AS sized"));
}

// In constant memory; what arrives has the hash that it is named by, or nothing arrives.
void CopyBlob(const fs::path& from, const std::string& sha256, BlobFolder& into) {
  std::ifstream file(BlobPlace(from, sha256), std::ios::binary);
  if (!file) throw Error(Code::kNotFound, "there is no blob '" + sha256 + "'");
  const std::unique_ptr<BlobWriter> writer = into.New();
  std::string piece(kPieceBytes, '\0');
  Sha256 hash;
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const std::string_view got(piece.data(), static_cast<std::size_t>(file.gcount()));
    hash.Update(got);
    writer->Append(got);
  }
  if (hash.FinishHex() != sha256) {
    throw Error(Code::kIo, "blob '" + sha256 + "' is damaged: its bytes have another hash");
  }
  writer->Commit();
}

std::size_t CopyBlobsOf(Database& database, const fs::path& from, BlobFolder& into,
                        const Progress& progress) {
  const std::uint64_t all = ReferredBytes(database);
  std::uint64_t done = 0;
  std::size_t count = 0;
  database.Each(kReferredBlobs, [&](const Cursor& row) {
    CopyBlob(from, row.Text(0), into);
    ++count;
    done += static_cast<std::uint64_t>(row.Int(1));
    if (progress) progress(done, all);
  });
  return count;
}

fs::path NewFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Error(Code::kIo, "cannot create '" + folder.string() + "': " + error.message());
  }
  if (!fs::is_empty(folder, error) || error) {
    throw Error(Code::kConflict, "'" + folder.string() + "' is not empty")
        .WithHint("name a folder that is not there yet");
  }
  return fs::absolute(folder);
}

BackupReport Counts(Database& database) {
  BackupReport report;
  report.digest = DigestOf(database);
  report.bytes = ReferredBytes(database);
  report.documents =
      static_cast<std::size_t>(database.AskInt("SELECT count(*) FROM document_versions"));
  report.environments =
      static_cast<std::size_t>(database.AskInt("SELECT count(*) FROM environment_versions"));
  return report;
}

BackupReport ReadManifest(const fs::path& folder) {
  const fs::path file = folder / kManifest;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw Error(Code::kInvalid,
                "'" + folder.string() + "' is no finished backup: it has no " + kManifest);
  }
  const auto json = nlohmann::json::parse(ReadFile(file), nullptr, false);
  BackupReport report;
  try {
    CheckSchemaVersion(json.at("schema").get<int>(), "the backup in '" + folder.string() + "'",
                       "lares store migrate --data " + folder.string());
    report.digest = json.at("digest").get<std::string>();
    report.bytes = json.at("bytes").get<std::uint64_t>();
    report.documents = json.at("documentVersions").get<std::size_t>();
    report.environments = json.at("environmentVersions").get<std::size_t>();
    report.blobs = json.at("blobs").get<std::size_t>();
  } catch (const nlohmann::json::exception&) {
    throw Error(Code::kInvalid, "'" + file.string() + "' is no manifest of a backup");
  }
  return report;
}

}  // namespace

std::string DigestOf(Database& database) {
  Sha256 hash;
  std::string line;
  for (const ContentTable& table : ContentTables()) {
    hash.Update(table.name + "\n");
    database.Each(SelectAll(table), [&](const Cursor& row) {
      line.clear();
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string text = row.Text(static_cast<int>(i));
        line += std::to_string(text.size()) + ":" + text;
      }
      hash.Update(line + "\n");
    });
  }
  return hash.FinishHex();
}

BackupTarget::BackupTarget(const fs::path& folder)
    : folder_(NewFolder(folder)), blobs_(folder_, RealFiles(), health_) {
  database_ =
      std::make_unique<SqliteDatabase>(folder_ / kDatabaseFile, SqliteDatabase::Access::kWrite, "");
  PrepareForWriting(*database_, folder_ / kDatabaseFile);
}

void BackupTarget::CopyRows(Database& from) {
  Transaction transaction(*database_, Transaction::Kind::kWrite);
  CopyTables(from, *database_);
  transaction.Commit();
}

void BackupTarget::CopyBlobs(const fs::path& from, const Progress& progress) {
  report_.blobs = CopyBlobsOf(*database_, from, blobs_, progress);
}

BackupReport BackupTarget::Finish() {
  const std::size_t blobs = report_.blobs;
  report_ = Counts(*database_);
  report_.blobs = blobs;
  database_->CheckpointWhole();
  database_->TidyOnClose();
  database_.reset();
  RealFiles().SyncFolder(folder_);
  const nlohmann::json manifest{{"schema", kSchemaVersion},
                                {"made", ToRfc3339(Now())},
                                {"digest", report_.digest},
                                {"bytes", report_.bytes},
                                {"documentVersions", report_.documents},
                                {"environmentVersions", report_.environments},
                                {"blobs", report_.blobs}};
  WriteFileAtomically(folder_ / kManifest, manifest.dump(2) + "\n");
  return report_;
}

BackupSource::BackupSource(const fs::path& folder)
    : folder_(folder), report_(ReadManifest(folder)) {
  database_ =
      std::make_unique<SqliteDatabase>(folder / kDatabaseFile, SqliteDatabase::Access::kRead, "");
}

void BackupSource::CopyBlobs(BlobFolder& into, const Progress& progress) const {
  try {
    CopyBlobsOf(*database_, folder_, into, progress);
  } catch (const Error& error) {
    if (error.code() != Code::kNotFound && error.code() != Code::kIo) throw;
    throw Error(Code::kInvalid,
                "the backup in '" + folder_.string() + "' is damaged: " + error.what());
  }
}

BackupReport BackupSource::CopyRows(Database& into) const {
  for (const char* table : {"documents", "environments"}) {
    if (into.AskInt(std::string("SELECT count(*) FROM ") + table) > 0) {
      throw Error(Code::kConflict, "the store is not empty")
          .WithHint("restore into a folder or database that is new");
    }
  }
  CopyTables(*database_, into);
  if (DigestOf(into) != report_.digest) {
    throw Error(Code::kInvalid, "the backup in '" + folder_.string() +
                                    "' is damaged: its rows are not those it was made of");
  }
  return report_;
}

}  // namespace lares::store
