// What Lares keeps: documents and environments with all their versions, tags and pins of those, and
// blobs. In SQLite and plain files, or in PostgreSQL and a folder that several servers share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/time.h"

namespace lares::store {

// --- Blobs: immutable files named by their SHA-256 -------------------------------------------

struct Blob {
  std::string sha256;
  std::uint64_t size = 0;
};

// Receives one blob in pieces, in constant memory. Dropped without Commit it leaves nothing. Used
// by one thread at a time; must not outlive its store.
class BlobWriter {
 public:
  virtual ~BlobWriter() = default;
  // Throws kUnavailable when there is no room: nothing is left of it, and the writer is spent.
  virtual void Append(std::string_view bytes) = 0;
  // Written, synced, renamed to its hash, folders synced. Once; nothing may be appended afterwards.
  // Throws kUnavailable when storage is full or failed.
  virtual Blob Commit() = 0;
  // The temporary file: after Flush and before Commit it holds all that was appended, for format
  // checks.
  virtual std::filesystem::path path() const = 0;
  virtual void Flush() = 0;
};

// --- Documents ------------------------------------------------------------------------------

// kQuarantined: documents of the other kinds that are kept aside.
enum class DocumentKind {
  kOntology,
  kRecipe,
  kRobot,
  kObjectModel,
  kPrior,
  kSkillTemplate,
  kQuarantined
};
// "ontology", "recipe", "robot", "object-model", "prior", "skill-template", "quarantined"
std::string_view ToString(DocumentKind kind);

// A name that a document answers to, beside its id.
struct DocumentName {
  std::string text;    // an IRI or a label
  std::string kind;    // "iri", "label", "local"
  std::string target;  // the IRI it names (a task, a robot instance, a class)
};

struct DocumentInfo {
  DocumentKind kind = DocumentKind::kOntology;
  std::string id;
  int version = 0;  // 1, 2, …: each put of the same id adds one
  std::string media_type;
  std::string file_name;
  Blob blob;  // the bytes as received
  Time received{};
  std::string details_json;  // object: what the reader found out; the store does not interpret it
  std::vector<DocumentName> names;
  std::string etag() const {
    return "\"" + std::to_string(version) + "-" + blob.sha256.substr(0, 16) + "\"";
  }
};

struct NewDocument {
  DocumentKind kind = DocumentKind::kOntology;
  std::string id;
  std::string media_type;
  std::string file_name;
  std::string bytes;
  std::string details_json = "{}";
  std::vector<DocumentName> names;
  // "" no condition; "*" must exist; "none" must not exist; else the etag it must have now. A
  // deleted document does not exist.
  std::string if_match;
};

// --- Environments ---------------------------------------------------------------------------

struct LayerInfo {
  std::string name;       // "semantic", "octomap", …
  std::string file_name;  // as uploaded
  std::string media_type;
  Blob blob;
  std::map<std::string, std::string> facts;
};

// How a version came to be. kMerge has two parents; kRollback has the layers of an older version.
enum class Origin { kPut, kRollback, kMerge };
std::string_view ToString(Origin origin);  // "put", "rollback", "merge"

struct EnvironmentVersion {
  std::string environment;
  int number = 0;  // 1, 2, …
  Time created{};
  std::string author;  // free text, as are these two; each may be empty
  std::string robot;
  std::string mission;
  std::string note;
  std::vector<LayerInfo> layers;  // by name; unchanged layers are carried over from the base
  std::vector<std::string> changed_layers;  // added, replaced or removed against the base, by name
  std::string type_iri;                     // of the environment when this version was made
  std::string label;
  Origin origin = Origin::kPut;
  std::vector<int> parents;  // none: the first; two: a merge
  int base = 0;              // whose layers were carried over: a parent, or what was rolled back to
  bool was_head = true;      // it became the environment's newest; false: a branch off an older one
  std::string etag() const { return "\"" + environment + "-" + std::to_string(number) + "\""; }
};

struct EnvironmentInfo {
  std::string id;
  std::string type_iri;  // canonical class of the place; may be empty
  std::string label;
  Time created{};
  int latest = 0;  // number of the head: what "newest" means
  Time changed{};  // when the head was made
  int count = 0;   // versions are 1 … count; more than `latest` when the last ones are branches
};

// What an environment is found by, beside its id. Values compare without the case of ASCII letters.
struct SearchKey {
  std::string field;  // "room-number", "street", "building", "level", "type", "holds"
  std::string value;
  bool operator==(const SearchKey&) const = default;
};

struct NewVersion {
  std::string environment;
  std::string type_iri;  // empty keeps the stored one
  std::string label;     // empty keeps the stored one
  std::string author;
  std::string robot;
  std::string mission;
  std::string note;
  std::vector<LayerInfo> layers;  // added or replaced; blobs already committed
  std::vector<std::string> removed_layers;
  std::string if_match;  // as in NewDocument, of the head
  // The version that this one was made from; 0: the head. Of another one it becomes a branch: it
  // gets the next number, and the head stays.
  int parent = 0;
  int merged = 0;    // the second parent of a merge; 0: none
  int restored = 0;  // a rollback to that version; 0: none
  // What the semantic layer says of the place, when that layer changes with this version; replaces
  // what was said before. Nothing leaves it.
  std::optional<std::vector<SearchKey>> keys;
  // The idempotency key of the request that asks for it, and that request's fingerprint: with the
  // version it becomes known that the key's write is done. "": none.
  std::string request_key;
  std::string request_fingerprint;
};

struct Tag {
  std::string environment;
  std::string name;
  int number = 0;
  Time created{};
  std::string author;
  std::string note;
};

// A robot that is to use one version of an environment, whatever comes after it.
struct Pin {
  std::string robot;
  std::string environment;
  int number = 0;
  Time created{};
  std::string author;
};

// One of the values, each whole; or, of words, one that begins so.
struct SearchCondition {
  std::string field;  // as in SearchKey; besides "layer" and "word" (of id, label, note, values)
  std::vector<std::string> any_of;
  bool prefix = false;  // `any_of` has beginnings
};

struct EnvironmentSearch {
  std::vector<SearchCondition> all_of;
  std::optional<Time> changed_from;   // the head was made then or later
  std::optional<Time> changed_until;  // … before then
  std::string after;                  // only ids beyond this one
  std::size_t limit = 100;
};

// --- Access ---------------------------------------------------------------------------------

// A token that was given out. Times and limits of 0 are none.
struct TokenRecord {
  std::string id;
  std::string label;                      // whose it is, for people
  std::string role;                       // "reader", "robot", "editor", "admin"
  std::vector<std::string> environments;  // ids, or prefixes that end with '*'; empty: all
  std::string secret_sha256;
  Time created{};
  std::optional<Time> expires;
  std::optional<Time> revoked;
  std::int64_t max_requests_per_minute = 0;
  std::int64_t max_bytes_per_day = 0;
  std::int64_t max_queries = 0;  // that run at the same time
};

// A write that was done or refused.
struct AuditRecord {
  std::string id;  // given by the store; sorts by time
  Time time{};
  std::string token;  // id; "" when none was needed
  std::string label;  // of the token
  std::string operation;
  std::string target;       // path of what was written
  std::string environment;  // id, where it was about one
  int version = 0;          // that was made; 0: none
  int status = 0;           // of the answer
  std::string result;       // "done", or the code of the problem
  std::string request_id;
  std::uint64_t bytes = 0;  // of the request's body
};

struct AuditQuery {
  Time since{};
  std::string token;        // id; "" all
  std::string environment;  // id; "" all
  std::string before;       // id of a record: those that are older than it; "" the newest
  int limit = 100;
};

// --- Who refers to a blob ---------------------------------------------------------------------

// A layer of an environment, or a version of a document.
struct BlobUse {
  std::string media_type;  // "" for a file beside a document, as the next
  std::string file_name;
  std::string environment;    // "" for a document
  std::string document_kind;  // as ToString(DocumentKind); "" for a layer
  std::string document;
};

class Uploads;          // uploads.h
class IdempotencyKeys;  // idempotency.h

// --- The store --------------------------------------------------------------------------------

// Holds something until it is dropped.
class Hold {
 public:
  virtual ~Hold() = default;
};

// Told of long work: bytes done, bytes to do.
using Progress = std::function<void(std::uint64_t, std::uint64_t)>;

struct BackupReport {
  std::string digest;
  std::uint64_t bytes = 0;
  std::size_t documents = 0;     // their versions
  std::size_t environments = 0;  // their versions
  std::size_t blobs = 0;
};

// Every write that has returned survives `kill -9` and a power cut. All members are thread-safe;
// readers never wait for a writer's disk. Throws kInvalid (an id that is no IsIdentifier, text that
// is not UTF-8), kNotFound, kPreconditionFailed (if_match; the message names the current etag),
// kUnavailable (no room for a blob: that write alone fails; a failed sync, rename or write of the
// database: the store then refuses every further write until it is opened again, `health` says
// why, and reading goes on), kIo (reading failed).
class Store {
 public:
  virtual ~Store() = default;

  virtual std::unique_ptr<BlobWriter> NewBlob() = 0;
  virtual std::filesystem::path BlobPath(const std::string& sha256) const = 0;  // kNotFound
  // The whole of it, its hash checked: kIo when the file was damaged.
  virtual std::string ReadBlob(const std::string& sha256) const = 0;

  // Adds a version, unless bytes, media type and file name are those of the current version: then
  // that one comes back and nothing is written (details and names given are not looked at), so
  // that a repeated put does no harm.
  virtual DocumentInfo PutDocument(const NewDocument& document) = 0;
  // The newest version; nothing when there is none or it was deleted.
  virtual std::optional<DocumentInfo> FindDocument(DocumentKind kind,
                                                   const std::string& id) const = 0;
  // Any version, of deleted documents too; 0: the newest.
  virtual DocumentInfo GetDocument(DocumentKind kind, const std::string& id, int version) const = 0;
  virtual std::vector<DocumentInfo> ListDocuments(
      DocumentKind kind) const = 0;  // newest versions, by id
  // Newest first, of deleted documents too.
  virtual std::vector<DocumentInfo> DocumentLog(DocumentKind kind, const std::string& id) const = 0;
  // It disappears from lists and names; its versions stay readable, and a later put continues
  // their numbers.
  virtual void DeleteDocument(DocumentKind kind, const std::string& id) = 0;
  // Newest versions having a name equal to `text` (IRIs exactly, labels and locals ignoring the
  // case of ASCII letters), by id.
  virtual std::vector<std::pair<DocumentInfo, DocumentName>> FindByName(
      DocumentKind kind, const std::string& text) const = 0;

  // The first version creates the environment. A version has at least one layer; its layers' blobs
  // must be stored (kNotFound; their sizes are taken from the files).
  virtual EnvironmentVersion PutVersion(const NewVersion& version) = 0;
  virtual std::optional<EnvironmentInfo> FindEnvironment(const std::string& id) const = 0;
  virtual std::vector<EnvironmentInfo> ListEnvironments() const = 0;                   // by id
  virtual EnvironmentVersion GetVersion(const std::string& id, int number) const = 0;  // 0: latest
  virtual std::vector<EnvironmentVersion> Log(const std::string& id) const = 0;  // newest first
  // The number of what was the head at that time. kNotFound when there was none yet.
  virtual int VersionAsOf(const std::string& id, Time time) const = 0;

  // By id, at most `limit`; the head decides. Throws kInvalid for a field that there is not.
  virtual std::vector<EnvironmentInfo> SearchEnvironments(
      const EnvironmentSearch& search) const = 0;
  // Every value that environments have, or ever had, for a field.
  virtual std::vector<std::string> SearchValues(const std::string& field) const = 0;
  // Environments whose semantic layer was never looked at for keys (an older program put them).
  virtual std::vector<std::string> EnvironmentsWithoutKeys() const = 0;
  // As NewVersion::keys, for the head as it is.
  virtual void PutKeys(const std::string& id, int number, const std::vector<SearchKey>& keys) = 0;

  // A name of a version: an identifier that is no number and not "latest". One that is there is
  // moved only when `move` says so; kConflict otherwise.
  virtual Tag PutTag(const Tag& tag, bool move) = 0;
  virtual void DeleteTag(const std::string& environment, const std::string& name) = 0;
  virtual std::optional<Tag> FindTag(const std::string& environment,
                                     const std::string& name) const = 0;
  virtual std::vector<Tag> Tags(const std::string& environment) const = 0;  // by name

  // One for each robot and environment; a later one replaces it.
  virtual Pin PutPin(const Pin& pin) = 0;
  virtual void DeletePin(const std::string& robot, const std::string& environment) = 0;
  virtual std::optional<Pin> FindPin(const std::string& robot,
                                     const std::string& environment) const = 0;
  virtual std::vector<Pin> Pins(const std::string& robot) const = 0;  // by environment; "": all

  // Whether other servers may write to it too.
  virtual bool shared() const = 0;
  // Another number after each write, of whatever server: what was read before may be outdated.
  virtual std::int64_t Revision() const = 0;
  // Held by one holder at a time among all servers of this store, for writes that rest on what was
  // read of several documents.
  virtual std::unique_ptr<Hold> HoldCatalogue() = 0;

  // A copy of all of it, as it was at one moment, in `folder` (created, or empty), while others
  // read and write: a store over SQLite with backup.json beside it.
  virtual BackupReport Backup(const std::filesystem::path& folder, const Progress& progress) = 0;
  // Puts a backup into this store, which holds nothing yet. Everything is checked against its
  // manifest: kInvalid, and nothing kept, when the backup is damaged; kConflict when the store is
  // not empty. The digest is then that of the backup.
  virtual BackupReport FillFrom(const std::filesystem::path& backup, const Progress& progress) = 0;
  // Of all that is kept, as it is at this moment; equal for equal contents, of either store.
  virtual std::string Digest() const = 0;

  // Each once; empty when nothing refers to it.
  virtual std::vector<BlobUse> BlobUses(const std::string& sha256) const = 0;

  // Both live as long as the store.
  virtual Uploads& uploads() = 0;
  virtual IdempotencyKeys& idempotency_keys() = 0;

  // Empty when writes are accepted; otherwise why not.
  virtual std::string health() const = 0;

  // Reads everything, each blob's bytes too, and checks hashes, references, numbers and the
  // database itself. One sentence for each thing that is wrong.
  virtual std::vector<std::string> Verify() const = 0;

  // --- Access ---
  // Throws kConflict when there is a token of that id.
  virtual void AddToken(const TokenRecord& token) = 0;
  virtual std::optional<TokenRecord> FindToken(const std::string& id) const = 0;
  virtual std::vector<TokenRecord> ListTokens() const = 0;  // by creation
  // Whether one was ever made; tokens are never removed.
  virtual bool HasTokens() const = 0;
  // The time of a token that is revoked already stays. Throws kNotFound.
  virtual TokenRecord RevokeToken(const std::string& id, Time when) = 0;
  virtual void AddAudit(const AuditRecord& record) = 0;
  virtual std::vector<AuditRecord> ListAudit(const AuditQuery& query) const = 0;  // newest first
  // Bytes that done writes of a token took in, since a time.
  virtual std::uint64_t BytesStoredSince(const std::string& token, Time since) const = 0;
};

struct StoreOptions {
  std::filesystem::path folder;  // lares.sqlite, blobs/, incoming/, lock; created when absent
};
// Opens or creates. Leftovers of interrupted writes are removed. Throws kConflict when another
// process (or this one) has it open, kInvalid when it was made by an older schema (the message
// names the command that migrates it) or a newer one, or is no store.
std::unique_ptr<Store> OpenSqliteStore(const StoreOptions& options);

struct MigrationReport {
  int from = 0;
  int to = 0;                       // the same: nothing was to be done
  std::filesystem::path kept_file;  // the database as it was before
};
// Brings the store in a folder to this program's schema; the database as it was is kept beside it.
// Throws as OpenSqliteStore.
MigrationReport MigrateSqliteStore(const StoreOptions& options);

struct PostgresOptions {
  std::string connection;       // "postgresql://user@host/name" or "host=… dbname=…"
  std::filesystem::path blobs;  // shared by every server of this store; created when absent
};
// Opens or creates: an empty database gets the tables. Any number of servers may have it open.
// Throws kInvalid as above, and for a server that does not sync what it commits; kUnavailable when
// it cannot be reached.
std::unique_ptr<Store> OpenPostgresStore(const PostgresOptions& options);

}  // namespace lares::store
