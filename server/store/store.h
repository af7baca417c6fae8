// What Lares keeps: documents with all their versions, environments, blobs. SQLite and plain files.
#pragma once

#include <cstdint>
#include <filesystem>
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

struct EnvironmentVersion {
  std::string environment;
  int number = 0;  // 1, 2, …
  Time created{};
  std::string author;  // free text; may be empty
  std::string note;
  std::vector<LayerInfo> layers;  // by name; unchanged layers are carried over from the parent
  std::vector<std::string> changed_layers;  // added, replaced or removed by this version, by name
  std::string type_iri;                     // of the environment when this version was made
  std::string label;
  std::string etag() const { return "\"" + environment + "-" + std::to_string(number) + "\""; }
};

struct EnvironmentInfo {
  std::string id;
  std::string type_iri;  // canonical class of the place; may be empty
  std::string label;
  Time created{};
  int latest = 0;  // number of the newest version
};

struct NewVersion {
  std::string environment;
  std::string type_iri;  // empty keeps the stored one
  std::string label;     // empty keeps the stored one
  std::string author;
  std::string note;
  std::vector<LayerInfo> layers;  // added or replaced; blobs already committed
  std::vector<std::string> removed_layers;
  std::string if_match;  // as in NewDocument
  // The idempotency key of the request that asks for it, and that request's fingerprint: with the
  // version it becomes known that the key's write is done. "": none.
  std::string request_key;
  std::string request_fingerprint;
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
};

struct StoreOptions {
  std::filesystem::path folder;  // lares.sqlite, blobs/, incoming/, lock; created when absent
};
// Opens or creates. Leftovers of interrupted writes are removed. Throws kConflict when another
// process (or this one) has it open, kInvalid when it was made by a newer schema or is no store.
std::unique_ptr<Store> OpenSqliteStore(const StoreOptions& options);

}  // namespace lares::store
