#include "server/store/schema.h"

#include "base/error.h"
#include "server/store/blob_uses.h"
#include "server/store/idempotency.h"

namespace lares::store {
namespace {

// Times are milliseconds since 1970. KEY stands for a row's number, given by the database. `latest`
// is the newest version of a document, the head of an environment. A name is `current` when it
// belongs to the newest version of a document that is not deleted; only those are looked up.
// `changed` is a version's layers, `parents` its one or two parents, both separated by spaces.
constexpr std::string_view kDocumentTables = R"sql(
CREATE TABLE documents (
  key KEY,
  kind TEXT NOT NULL,
  id TEXT NOT NULL,
  latest BIGINT NOT NULL,
  deleted BIGINT NOT NULL DEFAULT 0,
  UNIQUE (kind, id)
);
CREATE TABLE document_versions (
  key KEY,
  document BIGINT NOT NULL REFERENCES documents,
  number BIGINT NOT NULL,
  media_type TEXT NOT NULL,
  file_name TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size BIGINT NOT NULL,
  received BIGINT NOT NULL,
  details TEXT NOT NULL,
  UNIQUE (document, number)
);
CREATE TABLE document_names (
  version BIGINT NOT NULL REFERENCES document_versions,
  position BIGINT NOT NULL,
  text TEXT NOT NULL,
  lowered TEXT NOT NULL,
  kind TEXT NOT NULL,
  target TEXT NOT NULL,
  current BIGINT NOT NULL,
  PRIMARY KEY (version, position)
) CLUSTERED;
CREATE INDEX current_names ON document_names (lowered) WHERE current = 1;
)sql";

constexpr std::string_view kEnvironmentTables = R"sql(
CREATE TABLE environments (
  key KEY,
  id TEXT NOT NULL UNIQUE,
  type_iri TEXT NOT NULL,
  label TEXT NOT NULL,
  created BIGINT NOT NULL,
  latest BIGINT NOT NULL,
  count BIGINT NOT NULL DEFAULT 0,
  changed_at BIGINT NOT NULL DEFAULT 0,
  has_keys BIGINT NOT NULL DEFAULT 0
);
CREATE INDEX environments_changed ON environments (changed_at);
CREATE TABLE environment_versions (
  key KEY,
  environment BIGINT NOT NULL REFERENCES environments,
  number BIGINT NOT NULL,
  created BIGINT NOT NULL,
  author TEXT NOT NULL,
  note TEXT NOT NULL,
  changed TEXT NOT NULL,
  type_iri TEXT NOT NULL DEFAULT '',
  label TEXT NOT NULL DEFAULT '',
  robot TEXT NOT NULL DEFAULT '',
  mission TEXT NOT NULL DEFAULT '',
  origin TEXT NOT NULL DEFAULT 'put',
  parents TEXT NOT NULL DEFAULT '',
  base BIGINT NOT NULL DEFAULT 0,
  was_head BIGINT NOT NULL DEFAULT 1,
  UNIQUE (environment, number)
);
CREATE TABLE layers (
  version BIGINT NOT NULL REFERENCES environment_versions,
  name TEXT NOT NULL,
  file_name TEXT NOT NULL,
  media_type TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size BIGINT NOT NULL,
  facts TEXT NOT NULL,
  PRIMARY KEY (version, name)
) CLUSTERED;
)sql";

// A key's `source` is "semantic" (of the semantic layer) or "version" (of everything else).
constexpr std::string_view kVersionTables = R"sql(
CREATE TABLE tags (
  environment TEXT NOT NULL REFERENCES environments (id),
  name TEXT NOT NULL,
  number BIGINT NOT NULL,
  created BIGINT NOT NULL,
  author TEXT NOT NULL,
  note TEXT NOT NULL,
  PRIMARY KEY (environment, name)
) CLUSTERED;
CREATE TABLE pins (
  robot TEXT NOT NULL,
  environment TEXT NOT NULL REFERENCES environments (id),
  number BIGINT NOT NULL,
  created BIGINT NOT NULL,
  author TEXT NOT NULL,
  PRIMARY KEY (robot, environment)
) CLUSTERED;
CREATE TABLE environment_keys (
  field TEXT NOT NULL,
  value TEXT NOT NULL,
  environment TEXT NOT NULL REFERENCES environments (id),
  source TEXT NOT NULL,
  PRIMARY KEY (field, value, environment, source)
) CLUSTERED;
CREATE INDEX keys_of_environment ON environment_keys (environment);
CREATE TABLE environment_values (
  field TEXT NOT NULL,
  value TEXT NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY (field, value)
) CLUSTERED;
CREATE TABLE store_state (
  name TEXT PRIMARY KEY,
  value BIGINT NOT NULL
);
INSERT INTO store_state VALUES ('revision', 1);
)sql";

constexpr std::string_view kAccessTables = R"sql(
CREATE TABLE tokens (
  id TEXT PRIMARY KEY,
  label TEXT NOT NULL,
  role TEXT NOT NULL,
  environments TEXT NOT NULL,
  secret_sha256 TEXT NOT NULL,
  created BIGINT NOT NULL,
  expires BIGINT NOT NULL,
  revoked BIGINT NOT NULL,
  max_requests_per_minute BIGINT NOT NULL,
  max_bytes_per_day BIGINT NOT NULL,
  max_queries BIGINT NOT NULL
);
CREATE TABLE audit (
  id TEXT PRIMARY KEY,
  time BIGINT NOT NULL,
  token TEXT NOT NULL,
  label TEXT NOT NULL,
  operation TEXT NOT NULL,
  target TEXT NOT NULL,
  environment TEXT NOT NULL,
  version BIGINT NOT NULL,
  status BIGINT NOT NULL,
  result TEXT NOT NULL,
  request_id TEXT NOT NULL,
  bytes BIGINT NOT NULL
);
CREATE INDEX audit_of_tokens ON audit (token, time);
)sql";

// From schema 1, whose versions took type and label from their environment.
constexpr std::string_view kFromSchema1 = R"sql(
ALTER TABLE environment_versions ADD COLUMN type_iri TEXT NOT NULL DEFAULT '';
ALTER TABLE environment_versions ADD COLUMN label TEXT NOT NULL DEFAULT '';
UPDATE environment_versions SET
  type_iri = (SELECT e.type_iri FROM environments e WHERE e.key = environment),
  label = (SELECT e.label FROM environments e WHERE e.key = environment);
)sql";

// From schema 2, whose versions stood in one line.
constexpr std::string_view kFromSchema2 = R"sql(
ALTER TABLE environments ADD COLUMN count BIGINT NOT NULL DEFAULT 0;
ALTER TABLE environments ADD COLUMN changed_at BIGINT NOT NULL DEFAULT 0;
ALTER TABLE environments ADD COLUMN has_keys BIGINT NOT NULL DEFAULT 0;
ALTER TABLE environment_versions ADD COLUMN robot TEXT NOT NULL DEFAULT '';
ALTER TABLE environment_versions ADD COLUMN mission TEXT NOT NULL DEFAULT '';
ALTER TABLE environment_versions ADD COLUMN origin TEXT NOT NULL DEFAULT 'put';
ALTER TABLE environment_versions ADD COLUMN parents TEXT NOT NULL DEFAULT '';
ALTER TABLE environment_versions ADD COLUMN base BIGINT NOT NULL DEFAULT 0;
ALTER TABLE environment_versions ADD COLUMN was_head BIGINT NOT NULL DEFAULT 1;
UPDATE environment_versions SET base = number - 1, parents = CAST(number - 1 AS TEXT)
  WHERE number > 1;
UPDATE environments SET count = latest, changed_at = (SELECT v.created FROM environment_versions v
  WHERE v.environment = environments.key AND v.number = environments.latest);
CREATE INDEX environments_changed ON environments (changed_at);
)sql";

std::string ReplaceAll(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

// CLUSTERED: rows lie in the order of the primary key, where the database has such tables. Text is
// ordered by its bytes.
std::string ForDialect(std::string_view sql, Database::Dialect dialect) {
  if (dialect == Database::Dialect::kSqlite) {
    return ReplaceAll(ReplaceAll(std::string(sql), "key KEY", "key INTEGER PRIMARY KEY"),
                      ") CLUSTERED;", ") WITHOUT ROWID;");
  }
  std::string text = ReplaceAll(std::string(sql), "key KEY",
                                "key BIGINT GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY");
  text = ReplaceAll(std::move(text), ") CLUSTERED;", ");");
  return ReplaceAll(std::move(text), " TEXT ", " TEXT COLLATE \"C\" ");
}

void AddTransferTables(Database& database) {
  database.RunScript(ForDialect(kIdempotencyTables, database.dialect()));
  database.RunScript(kBlobUseIndexes);
}

}  // namespace

const std::vector<ContentTable>& ContentTables() {
  static const std::vector<ContentTable> kTables = {
      {"documents", {"key", "kind", "id", "latest", "deleted"}, "key", true},
      {"document_versions",
       {"key", "document", "number", "media_type", "file_name", "sha256", "size", "received",
        "details"},
       "key",
       true},
      {"document_names",
       {"version", "position", "text", "lowered", "kind", "target", "current"},
       "version, position",
       false},
      {"environments",
       {"key", "id", "type_iri", "label", "created", "latest", "count", "changed_at", "has_keys"},
       "key",
       true},
      {"environment_versions",
       {"key", "environment", "number", "created", "author", "note", "changed", "type_iri", "label",
        "robot", "mission", "origin", "parents", "base", "was_head"},
       "key",
       true},
      {"layers",
       {"version", "name", "file_name", "media_type", "sha256", "size", "facts"},
       "version, name",
       false},
      {"tags",
       {"environment", "name", "number", "created", "author", "note"},
       "environment, name",
       false},
      {"pins",
       {"robot", "environment", "number", "created", "author"},
       "robot, environment",
       false},
      {"environment_keys",
       {"field", "value", "environment", "source"},
       "field, value, environment, source",
       false},
      {"environment_values", {"field", "value", "text"}, "field, value", false},
      {"tokens",
       {"id", "label", "role", "environments", "secret_sha256", "created", "expires", "revoked",
        "max_requests_per_minute", "max_bytes_per_day", "max_queries"},
       "id",
       false},
      {"audit",
       {"id", "time", "token", "label", "operation", "target", "environment", "version", "status",
        "result", "request_id", "bytes"},
       "id",
       false},
  };
  return kTables;
}

void CreateTables(Database& database) {
  database.RunScript(
      ForDialect("CREATE TABLE schema_version (version BIGINT NOT NULL);", database.dialect()));
  for (const std::string_view tables :
       {kDocumentTables, kEnvironmentTables, kVersionTables, kAccessTables}) {
    database.RunScript(ForDialect(tables, database.dialect()));
  }
  AddTransferTables(database);
  database.Run("INSERT INTO schema_version VALUES (?)", {kSchemaVersion});
}

int ReadSchemaVersion(Database& database) {
  return static_cast<int>(database.AskInt("SELECT version FROM schema_version"));
}

void CheckSchemaVersion(int version, const std::string& name, const std::string& migrate_command) {
  if (version == kSchemaVersion) return;
  const std::string message = name + " has schema " + std::to_string(version) +
                              "; this program uses schema " + std::to_string(kSchemaVersion);
  if (version >= 1 && version < kSchemaVersion) {
    throw Error(Code::kInvalid, message).WithHint("run: " + migrate_command);
  }
  throw Error(Code::kInvalid, message)
      .WithHint("use the version of Lares that wrote it, or a newer one");
}

void MigrateTables(Database& database, int version) {
  if (version < 2) database.RunScript(ForDialect(kFromSchema1, database.dialect()));
  if (version < 3) {
    database.RunScript(ForDialect(kFromSchema2, database.dialect()));
    database.RunScript(ForDialect(kVersionTables, database.dialect()));
    database.RunScript(ForDialect(kAccessTables, database.dialect()));
    AddTransferTables(database);
  }
  database.Run("UPDATE schema_version SET version = ?", {kSchemaVersion});
}

}  // namespace lares::store
