#include "server/store/sqlite_store.h"

#include <utility>

#include "base/error.h"
#include "server/store/folder_lock.h"
#include "server/store/idempotency.h"
#include "server/store/sqlite_file.h"

namespace lares::store {
namespace {

namespace fs = std::filesystem;

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
    database_ =
        std::make_unique<SqliteDatabase>(pool_.file_, SqliteDatabase::Access::kRead, pool_.vfs_);
  }
}

ReaderPool::Lease::~Lease() {
  const std::lock_guard lock(pool_.mutex_);
  pool_.idle_.push_back(std::move(database_));
}

SqliteStore::SqliteStore(const fs::path& folder, const Seams& seams)
    : SqlStore(folder, *seams.files, std::make_unique<FolderLock>(folder / "lock")),
      checkpoint_pages_(seams.checkpoint_pages),
      writer_(folder / kDatabaseFile, SqliteDatabase::Access::kWrite, seams.sqlite_vfs),
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

void SqliteStore::Reading(const Work& work) const {
  const ReaderPool::Lease lease(readers_);
  const Transaction snapshot(*lease, Transaction::Kind::kRead);
  work(*lease);
}

void SqliteStore::Writing(const Work& work) {
  const std::lock_guard lock(writer_mutex_);
  health_.Check();
  health_.Guard([&] {
    Transaction transaction(writer_, Transaction::Kind::kWrite);
    work(writer_);
    transaction.Commit();
  });
  CheckpointIfDue();
}

std::vector<std::string> SqliteStore::VerifyFile(Database& database) const {
  return VerifySqliteFile(database);
}

// This process alone has the store open, and it has locks of its own.
std::unique_ptr<Hold> SqliteStore::HoldCatalogue() { return std::make_unique<Hold>(); }

// What was committed stays committed when this fails; only further writes are refused.
void SqliteStore::CheckpointIfDue() {
  if (writer_.log_pages() < checkpoint_pages_) return;
  try {
    writer_.Checkpoint();
  } catch (const Error& error) {
    health_.Fail(error.what());
  }
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
