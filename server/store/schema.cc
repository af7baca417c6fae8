#include "server/store/schema.h"

#include <string>

#include "base/error.h"
#include "server/store/blob_uses.h"
#include "server/store/idempotency.h"

namespace lares::store {
namespace {

constexpr int kSchemaVersion = 3;

// Times are milliseconds since 1970. `latest` is the number of the newest version. A name is
// `current` when it belongs to the newest version of a document that is not deleted; only those
// are looked up.
constexpr const char* kSchema = R"sql(
CREATE TABLE schema_version (version INTEGER NOT NULL);

CREATE TABLE documents (
  key INTEGER PRIMARY KEY,
  kind TEXT NOT NULL,
  id TEXT NOT NULL,
  latest INTEGER NOT NULL,
  deleted INTEGER NOT NULL DEFAULT 0,
  UNIQUE (kind, id)
);
CREATE TABLE document_versions (
  key INTEGER PRIMARY KEY,
  document INTEGER NOT NULL REFERENCES documents,
  number INTEGER NOT NULL,
  media_type TEXT NOT NULL,
  file_name TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size INTEGER NOT NULL,
  received INTEGER NOT NULL,
  details TEXT NOT NULL,
  UNIQUE (document, number)
);
CREATE TABLE document_names (
  version INTEGER NOT NULL REFERENCES document_versions,
  position INTEGER NOT NULL,
  text TEXT NOT NULL,
  lowered TEXT NOT NULL,
  kind TEXT NOT NULL,
  target TEXT NOT NULL,
  current INTEGER NOT NULL,
  PRIMARY KEY (version, position)
) WITHOUT ROWID;
CREATE INDEX current_names ON document_names (lowered) WHERE current = 1;

CREATE TABLE environments (
  key INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE,
  type_iri TEXT NOT NULL,
  label TEXT NOT NULL,
  created INTEGER NOT NULL,
  latest INTEGER NOT NULL
);
CREATE TABLE environment_versions (
  key INTEGER PRIMARY KEY,
  environment INTEGER NOT NULL REFERENCES environments,
  number INTEGER NOT NULL,
  created INTEGER NOT NULL,
  author TEXT NOT NULL,
  note TEXT NOT NULL,
  changed TEXT NOT NULL,
  type_iri TEXT NOT NULL DEFAULT '',
  label TEXT NOT NULL DEFAULT '',
  UNIQUE (environment, number)
);
CREATE TABLE layers (
  version INTEGER NOT NULL REFERENCES environment_versions,
  name TEXT NOT NULL,
  file_name TEXT NOT NULL,
  media_type TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size INTEGER NOT NULL,
  facts TEXT NOT NULL,
  PRIMARY KEY (version, name)
) WITHOUT ROWID;
)sql";

// From schema 1, whose versions took type and label from their environment.
constexpr const char* kFromSchema1 = R"sql(
ALTER TABLE environment_versions ADD COLUMN type_iri TEXT NOT NULL DEFAULT '';
ALTER TABLE environment_versions ADD COLUMN label TEXT NOT NULL DEFAULT '';
UPDATE environment_versions SET
  type_iri = (SELECT e.type_iri FROM environments e WHERE e.key = environment),
  label = (SELECT e.label FROM environments e WHERE e.key = environment);
UPDATE schema_version SET version = 2;
)sql";

// What schema 3 has more than schema 2.
const std::string kTransferTables = std::string(kIdempotencyTables) + kBlobUseIndexes;

bool HasTables(Database& database) {
  Query query = database.Ask("SELECT count(*) FROM sqlite_master");
  return query.Next() && query.Int(0) > 0;
}

bool HasTable(Database& database, std::string_view name) {
  return database.Ask("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", {name})
      .Next();
}

void CreateTables(Database& database) {
  Transaction transaction(database, Transaction::Kind::kWrite);
  database.RunScript(kSchema);
  database.RunScript(kTransferTables);
  database.Run("INSERT INTO schema_version VALUES (?)", {kSchemaVersion});
  transaction.Commit();
}

// The schema that the file has, one that this program can use or migrate.
std::int64_t CheckVersion(Database& database, const std::filesystem::path& file) {
  const std::string name = "'" + file.string() + "'";
  if (!HasTable(database, "schema_version")) {
    throw Error(Code::kInvalid, name + " is a database, but not a store of Lares");
  }
  Query query = database.Ask("SELECT version FROM schema_version");
  const std::int64_t version = query.Next() ? query.Int(0) : 0;
  if (version >= 1 && version <= kSchemaVersion) return version;
  throw Error(Code::kInvalid, name + " has schema " + std::to_string(version) +
                                  "; this program knows schema " + std::to_string(kSchemaVersion))
      .WithHint("use the version of Lares that wrote it, or a newer one");
}

void Migrate(Database& database, std::int64_t version) {
  if (version == kSchemaVersion) return;
  Transaction transaction(database, Transaction::Kind::kWrite);
  if (version == 1) database.RunScript(kFromSchema1);
  database.RunScript(kTransferTables);
  database.Run("UPDATE schema_version SET version = ?", {kSchemaVersion});
  transaction.Commit();
}

void UseLog(Database& database, const std::filesystem::path& file) {
  Query query = database.Ask("PRAGMA journal_mode = WAL");
  std::string mode;
  // To the last row: the change is written after the row that announces it.
  while (query.Next()) mode = query.Text(0);
  if (mode == "wal") return;
  throw Error(Code::kIo, "'" + file.string() + "' cannot use a write-ahead log here")
      .WithHint("put the store on a local file system");
}

}  // namespace

void PrepareForWriting(Database& database, const std::filesystem::path& file) {
  // Looked at before anything is changed: a file of somebody else stays as it is.
  const bool created = !HasTables(database);
  const std::int64_t version = created ? kSchemaVersion : CheckVersion(database, file);
  UseLog(database, file);
  database.Run("PRAGMA synchronous = FULL");
  database.Run("PRAGMA foreign_keys = ON");
  database.Run("PRAGMA temp_store = MEMORY");
  if (created) CreateTables(database);
  Migrate(database, version);
}

}  // namespace lares::store
