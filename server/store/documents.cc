#include "server/store/documents.h"

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"

namespace lares::store {
namespace {

#define LARES_VERSION_COLUMNS                                                                  \
  "v.key, d.id, v.number, v.media_type, v.file_name, v.sha256, v.size, v.received, v.details " \
  "FROM documents d JOIN document_versions v ON v.document = d.key "
#define LARES_NAME_COLUMNS                                \
  "n.version, n.text, n.kind, n.target FROM documents d " \
  "JOIN document_versions v ON v.document = d.key "       \
  "JOIN document_names n ON n.version = v.key "

struct StoredVersion {
  std::int64_t key = 0;
  DocumentInfo info;
};

StoredVersion ReadVersion(const Query& row, DocumentKind kind) {
  StoredVersion version{row.Int(0), {}};
  DocumentInfo& info = version.info;
  info.kind = kind;
  info.id = row.Text(1);
  info.version = static_cast<int>(row.Int(2));
  info.media_type = row.Text(3);
  info.file_name = row.Text(4);
  info.blob = {row.Text(5), static_cast<std::uint64_t>(row.Int(6))};
  info.received = Time(std::chrono::milliseconds(row.Int(7)));
  info.details_json = row.Text(8);
  return version;
}

DocumentName ReadName(const Query& row) { return {row.Text(1), row.Text(2), row.Text(3)}; }

// Versions and their names, asked separately, in the same order.
std::vector<DocumentInfo> Join(Query& versions, Query& names, DocumentKind kind) {
  std::vector<DocumentInfo> documents;
  bool more_names = names.Next();
  while (versions.Next()) {
    StoredVersion version = ReadVersion(versions, kind);
    for (; more_names && names.Int(0) == version.key; more_names = names.Next()) {
      version.info.names.push_back(ReadName(names));
    }
    documents.push_back(std::move(version.info));
  }
  return documents;
}

struct Row {
  std::int64_t key = 0;
  int latest = 0;
  bool deleted = false;
};

std::optional<Row> FindRow(Database& database, DocumentKind kind, const std::string& id) {
  Query query = database.Ask("SELECT key, latest, deleted FROM documents WHERE kind = ? AND id = ?",
                             {ToString(kind), id});
  if (!query.Next()) return std::nullopt;
  return Row{query.Int(0), static_cast<int>(query.Int(1)), query.Int(2) != 0};
}

Error NoDocument(DocumentKind kind, const std::string& id) {
  return Error(Code::kNotFound,
               "there is no " + std::string(ToString(kind)) + " '" + id.substr(0, 200) + "'");
}

std::optional<DocumentInfo> FindVersion(Database& database, DocumentKind kind, std::int64_t key,
                                        int number) {
  Query versions = database.Ask("SELECT " LARES_VERSION_COLUMNS "WHERE d.key = ? AND v.number = ?",
                                {key, number});
  Query names = database.Ask("SELECT " LARES_NAME_COLUMNS
                             "WHERE d.key = ? AND v.number = ? ORDER BY n.position",
                             {key, number});
  std::vector<DocumentInfo> documents = Join(versions, names, kind);
  if (documents.empty()) return std::nullopt;
  return std::move(documents.front());
}

std::string Described(DocumentKind kind, const std::string& id) {
  return std::string(ToString(kind)) + " '" + id + "'";
}

// The names of `number` no longer lead to the document.
void RetireNames(Database& database, std::int64_t document, int number) {
  database.Run(
      "UPDATE document_names SET current = 0 WHERE current = 1 AND version = "
      "(SELECT key FROM document_versions WHERE document = ? AND number = ?)",
      {document, number});
}

// The document's row, standing at the number that its next version will have.
Row Advance(Database& database, DocumentKind kind, const std::string& id) {
  const std::optional<Row> row = FindRow(database, kind, id);
  if (!row) {
    const std::int64_t key =
        database.AskInt("INSERT INTO documents (kind, id, latest) VALUES (?, ?, 1) RETURNING key",
                        {ToString(kind), id});
    return {key, 1};
  }
  RetireNames(database, row->key, row->latest);
  database.Run("UPDATE documents SET latest = latest + 1, deleted = 0 WHERE key = ?", {row->key});
  return {row->key, row->latest + 1};
}

void AddNames(Database& database, std::int64_t version, const std::vector<DocumentName>& names) {
  int position = 0;
  for (const DocumentName& name : names) {
    database.Run("INSERT INTO document_names VALUES (?, ?, ?, ?, ?, ?, 1)",
                 {version, position++, name.text, ToLower(name.text), name.kind, name.target});
  }
}

}  // namespace

void CheckNewDocument(const NewDocument& document) {
  CheckId(document.id, ToString(document.kind));
  CheckText(document.media_type, "the media type");
  CheckText(document.file_name, "the file name");
  CheckText(document.details_json, "the details");
  for (const DocumentName& name : document.names) {
    CheckText(name.text, "a name");
    CheckText(name.kind, "the kind of a name");
    CheckText(name.target, "the target of a name");
  }
}

std::optional<DocumentInfo> AlreadyStored(Database& database, const NewDocument& document,
                                          const std::string& sha256) {
  std::optional<DocumentInfo> current = FindDocument(database, document.kind, document.id);
  CheckIfMatch(document.if_match,
               current ? std::optional<std::string>(current->etag()) : std::nullopt,
               Described(document.kind, document.id));
  const bool same = current && current->blob.sha256 == sha256 &&
                    current->media_type == document.media_type &&
                    current->file_name == document.file_name;
  return same ? std::move(current) : std::nullopt;
}

DocumentInfo AddDocument(Database& database, const NewDocument& document, const Blob& blob) {
  const Row row = Advance(database, document.kind, document.id);
  const DocumentInfo info{document.kind,      document.id, row.latest, document.media_type,
                          document.file_name, blob,        Now(),      document.details_json,
                          document.names};
  const std::int64_t key = database.AskInt(
      "INSERT INTO document_versions (document, number, media_type, file_name, sha256, size, "
      "received, details) VALUES (?, ?, ?, ?, ?, ?, ?, ?) RETURNING key",
      {row.key, info.version, info.media_type, info.file_name, blob.sha256,
       static_cast<std::int64_t>(blob.size), info.received.time_since_epoch().count(),
       info.details_json});
  AddNames(database, key, document.names);
  return info;
}

std::optional<DocumentInfo> FindDocument(Database& database, DocumentKind kind,
                                         const std::string& id) {
  const std::optional<Row> row = FindRow(database, kind, id);
  if (!row || row->deleted) return std::nullopt;
  return FindVersion(database, kind, row->key, row->latest);
}

DocumentInfo GetDocument(Database& database, DocumentKind kind, const std::string& id,
                         int version) {
  const std::optional<Row> row = FindRow(database, kind, id);
  if (!row) throw NoDocument(kind, id);
  const int number = version == 0 ? row->latest : version;
  std::optional<DocumentInfo> info = FindVersion(database, kind, row->key, number);
  if (!info) {
    throw Error(Code::kNotFound, Described(kind, id) + " has versions 1 to " +
                                     std::to_string(row->latest) + ", not " +
                                     std::to_string(number));
  }
  return *std::move(info);
}

std::vector<DocumentInfo> ListDocuments(Database& database, DocumentKind kind) {
  Query versions = database.Ask("SELECT " LARES_VERSION_COLUMNS
                                "AND v.number = d.latest "
                                "WHERE d.kind = ? AND d.deleted = 0 ORDER BY d.id",
                                {ToString(kind)});
  Query names = database.Ask("SELECT " LARES_NAME_COLUMNS
                             "WHERE v.number = d.latest AND d.kind = ? AND d.deleted = 0 "
                             "ORDER BY d.id, n.position",
                             {ToString(kind)});
  return Join(versions, names, kind);
}

std::vector<DocumentInfo> DocumentLog(Database& database, DocumentKind kind,
                                      const std::string& id) {
  Query versions = database.Ask("SELECT " LARES_VERSION_COLUMNS
                                "WHERE d.kind = ? AND d.id = ? ORDER BY v.number DESC",
                                {ToString(kind), id});
  Query names = database.Ask("SELECT " LARES_NAME_COLUMNS
                             "WHERE d.kind = ? AND d.id = ? ORDER BY v.number DESC, n.position",
                             {ToString(kind), id});
  std::vector<DocumentInfo> log = Join(versions, names, kind);
  if (log.empty()) throw NoDocument(kind, id);
  return log;
}

void DeleteDocument(Database& database, DocumentKind kind, const std::string& id) {
  const std::optional<Row> row = FindRow(database, kind, id);
  if (!row || row->deleted) throw NoDocument(kind, id);
  RetireNames(database, row->key, row->latest);
  database.Run("UPDATE documents SET deleted = 1 WHERE key = ?", {row->key});
}

std::vector<std::pair<DocumentInfo, DocumentName>> FindByName(Database& database, DocumentKind kind,
                                                              const std::string& text) {
  Query query = database.Ask("SELECT " LARES_NAME_COLUMNS
                             "WHERE n.current = 1 AND n.lowered = ? AND d.kind = ? "
                             "AND (n.kind <> 'iri' OR n.text = ?) ORDER BY d.id, n.position",
                             {ToLower(text), ToString(kind), text});
  std::vector<std::pair<std::int64_t, DocumentName>> found;
  while (query.Next()) found.emplace_back(query.Int(0), ReadName(query));

  std::vector<std::pair<DocumentInfo, DocumentName>> matches;
  for (auto& [version, name] : found) {
    Query versions = database.Ask("SELECT " LARES_VERSION_COLUMNS "WHERE v.key = ?", {version});
    Query names =
        database.Ask("SELECT " LARES_NAME_COLUMNS "WHERE v.key = ? ORDER BY n.position", {version});
    matches.emplace_back(std::move(Join(versions, names, kind).front()), std::move(name));
  }
  return matches;
}

}  // namespace lares::store
