#include "server/store/sqlite_store.h"

#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "server/store/blob_uses.h"
#include "server/store/documents.h"
#include "server/store/environments.h"
#include "server/store/schema.h"
#include "server/store/verify.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDatabaseFile = "lares.sqlite";

// `folder` and the folders above it, each durable in the one above.
void MakeFolders(const fs::path& folder, Files& files) {
  if (fs::is_directory(folder)) return;
  const fs::path parent = folder.parent_path();
  if (!parent.empty()) MakeFolders(parent, files);
  files.MakeFolder(folder);
  files.SyncFolder(parent.empty() ? "." : parent);
}

}  // namespace

ReaderPool::ReaderPool(fs::path file, std::string vfs)
    : file_(std::move(file)), vfs_(std::move(vfs)) {}

ReaderPool::Lease::Lease(ReaderPool& pool) : pool_(pool) {
  {
    const std::lock_guard lock(pool_.mutex_);
    if (!pool_.idle_.empty()) {
      database_ = std::move(pool_.idle_.back());
      pool_.idle_.pop_back();
    }
  }
  if (!database_) {
    database_ = std::make_unique<Database>(pool_.file_, Database::Access::kRead, pool_.vfs_);
  }
}

ReaderPool::Lease::~Lease() {
  const std::lock_guard lock(pool_.mutex_);
  pool_.idle_.push_back(std::move(database_));
}

SqliteStore::SqliteStore(const fs::path& folder, const Seams& seams)
    : lock_(folder / "lock"),
      blobs_(folder, *seams.files, health_),
      uploads_(folder, *seams.files, health_, blobs_),
      checkpoint_pages_(seams.checkpoint_pages),
      writer_(folder / kDatabaseFile, Database::Access::kWrite, seams.sqlite_vfs),
      readers_(folder / kDatabaseFile, seams.sqlite_vfs) {
  PrepareForWriting(writer_, folder / kDatabaseFile);
  ForgetInterruptedKeys(writer_);
  // What a crashed or failed process left in the log may be visible without being durable: it is
  // written anew, into the database file, before anything rests on it.
  writer_.CheckpointWhole();
  seams.files->SyncFolder(folder);
}

SqliteStore::~SqliteStore() {
  if (health_.reason().empty()) writer_.TidyOnClose();
}

template <typename Work>
auto SqliteStore::Read(Work work) const {
  const ReaderPool::Lease lease(readers_);
  const Transaction snapshot(*lease, Transaction::Kind::kRead);
  return work(*lease);
}

template <typename Work>
auto SqliteStore::Write(Work work) {
  const std::lock_guard lock(writer_mutex_);
  health_.Check();
  const auto result = health_.Guard([&] {
    Transaction transaction(writer_, Transaction::Kind::kWrite);
    auto done = work(writer_);
    transaction.Commit();
    return done;
  });
  CheckpointIfDue();
  return result;
}

// What was committed stays committed when this fails; only further writes are refused.
void SqliteStore::CheckpointIfDue() {
  if (writer_.log_pages() < checkpoint_pages_) return;
  try {
    writer_.Checkpoint();
  } catch (const Error& error) {
    health_.Fail(error.what());
  }
}

std::unique_ptr<BlobWriter> SqliteStore::NewBlob() { return blobs_.New(); }

fs::path SqliteStore::BlobPath(const std::string& sha256) const { return blobs_.PathOf(sha256); }

std::string SqliteStore::ReadBlob(const std::string& sha256) const { return blobs_.Read(sha256); }

DocumentInfo SqliteStore::PutDocument(const NewDocument& document) {
  CheckNewDocument(document);
  health_.Check();
  const std::string sha256 = Sha256Hex(document.bytes);
  const auto already_stored = [&](Database& database) {
    return AlreadyStored(database, document, sha256);
  };
  // Asked before the bytes are written, so that refusals and repetitions leave nothing behind, and
  // again in the transaction, where it counts.
  if (std::optional<DocumentInfo> same = Read(already_stored)) return *std::move(same);
  const Blob blob = blobs_.Put(document.bytes);
  return Write([&](Database& database) {
    if (std::optional<DocumentInfo> same = already_stored(database)) return *std::move(same);
    return AddDocument(database, document, blob);
  });
}

std::optional<DocumentInfo> SqliteStore::FindDocument(DocumentKind kind,
                                                      const std::string& id) const {
  return Read([&](Database& database) { return store::FindDocument(database, kind, id); });
}

DocumentInfo SqliteStore::GetDocument(DocumentKind kind, const std::string& id, int version) const {
  return Read([&](Database& database) { return store::GetDocument(database, kind, id, version); });
}

std::vector<DocumentInfo> SqliteStore::ListDocuments(DocumentKind kind) const {
  return Read([&](Database& database) { return store::ListDocuments(database, kind); });
}

std::vector<DocumentInfo> SqliteStore::DocumentLog(DocumentKind kind, const std::string& id) const {
  return Read([&](Database& database) { return store::DocumentLog(database, kind, id); });
}

void SqliteStore::DeleteDocument(DocumentKind kind, const std::string& id) {
  Write([&](Database& database) {
    store::DeleteDocument(database, kind, id);
    return true;
  });
}

std::vector<std::pair<DocumentInfo, DocumentName>> SqliteStore::FindByName(
    DocumentKind kind, const std::string& text) const {
  return Read([&](Database& database) { return store::FindByName(database, kind, text); });
}

EnvironmentVersion SqliteStore::PutVersion(const NewVersion& version) {
  CheckNewVersion(version);
  health_.Check();
  NewVersion sized = version;
  for (LayerInfo& layer : sized.layers) {
    layer.blob.size = blobs_.SizeOf(layer.blob.sha256);
    blobs_.MakeDurable(layer.blob.sha256);
  }
  return Write([&](Database& database) {
    EnvironmentVersion added = AddVersion(database, sized);
    MarkWritten(database, version.request_key, version.request_fingerprint,
                added.environment + "/" + std::to_string(added.number));
    return added;
  });
}

std::optional<EnvironmentInfo> SqliteStore::FindEnvironment(const std::string& id) const {
  return Read([&](Database& database) { return store::FindEnvironment(database, id); });
}

std::vector<EnvironmentInfo> SqliteStore::ListEnvironments() const {
  return Read([&](Database& database) { return store::ListEnvironments(database); });
}

EnvironmentVersion SqliteStore::GetVersion(const std::string& id, int number) const {
  return Read([&](Database& database) { return store::GetVersion(database, id, number); });
}

std::vector<EnvironmentVersion> SqliteStore::Log(const std::string& id) const {
  return Read([&](Database& database) { return EnvironmentLog(database, id); });
}

std::vector<BlobUse> SqliteStore::BlobUses(const std::string& sha256) const {
  return Read([&](Database& database) { return store::BlobUses(database, sha256); });
}

KeyRecord SqliteStore::Take(const std::string& key) {
  return Write([&](Database& database) { return TakeKey(database, key, Now(), {}); });
}

void SqliteStore::Finish(const std::string& key, const KeyRecord& answer) {
  Write([&](Database& database) {
    FinishKey(database, key, answer);
    if (finished_keys_++ % 64 == 0) PruneKeys(database, {});
    return true;
  });
}

void SqliteStore::Release(const std::string& key) {
  Write([&](Database& database) {
    ReleaseKey(database, key);
    return true;
  });
}

std::string SqliteStore::health() const { return health_.reason(); }

std::vector<std::string> SqliteStore::Verify() const {
  std::vector<std::string> problems =
      Read([&](Database& database) { return VerifyDatabase(database, blobs_); });
  const std::vector<std::string> damaged = blobs_.Verify();
  problems.insert(problems.end(), damaged.begin(), damaged.end());
  return problems;
}

std::unique_ptr<Store> OpenSqliteStore(const StoreOptions& options, const Seams& seams) {
  try {
    const fs::path folder = fs::absolute(options.folder).lexically_normal();
    MakeFolders(folder, *seams.files);
    return std::make_unique<SqliteStore>(folder, seams);
  } catch (const std::system_error& error) {
    throw Error(Code::kIo, std::string("cannot open the store: ") + error.what());
  }
}

}  // namespace lares::store
