// The store over SQLite and plain files. Private to this folder and its tests; others include
// store.h.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/files.h"
#include "server/store/folder_lock.h"
#include "server/store/health.h"
#include "server/store/idempotency.h"
#include "server/store/sqlite.h"
#include "server/store/store.h"
#include "server/store/uploads.h"

namespace lares::store {

// Where tests put a disk that fails. Both must outlive the store.
struct Seams {
  Files* files = &RealFiles();
  std::string sqlite_vfs;       // registered name; empty: SQLite's default
  int checkpoint_pages = 1000;  // the log is moved into the database when it is this long
};

std::unique_ptr<Store> OpenSqliteStore(const StoreOptions& options, const Seams& seams);

// Connections for reading, as many as were ever needed at once.
class ReaderPool {
 public:
  ReaderPool(std::filesystem::path file, std::string vfs);

  class Lease {
   public:
    explicit Lease(ReaderPool& pool);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Database& operator*() const { return *database_; }

   private:
    ReaderPool& pool_;
    std::unique_ptr<Database> database_;
  };

 private:
  std::filesystem::path file_;
  std::string vfs_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Database>> idle_;
};

class SqliteStore final : public Store, public IdempotencyKeys {
 public:
  SqliteStore(const std::filesystem::path& folder, const Seams& seams);
  ~SqliteStore() override;

  std::unique_ptr<BlobWriter> NewBlob() override;
  std::filesystem::path BlobPath(const std::string& sha256) const override;
  std::string ReadBlob(const std::string& sha256) const override;

  DocumentInfo PutDocument(const NewDocument& document) override;
  std::optional<DocumentInfo> FindDocument(DocumentKind kind, const std::string& id) const override;
  DocumentInfo GetDocument(DocumentKind kind, const std::string& id, int version) const override;
  std::vector<DocumentInfo> ListDocuments(DocumentKind kind) const override;
  std::vector<DocumentInfo> DocumentLog(DocumentKind kind, const std::string& id) const override;
  void DeleteDocument(DocumentKind kind, const std::string& id) override;
  std::vector<std::pair<DocumentInfo, DocumentName>> FindByName(
      DocumentKind kind, const std::string& text) const override;

  EnvironmentVersion PutVersion(const NewVersion& version) override;
  std::optional<EnvironmentInfo> FindEnvironment(const std::string& id) const override;
  std::vector<EnvironmentInfo> ListEnvironments() const override;
  EnvironmentVersion GetVersion(const std::string& id, int number) const override;
  std::vector<EnvironmentVersion> Log(const std::string& id) const override;

  std::vector<BlobUse> BlobUses(const std::string& sha256) const override;
  Uploads& uploads() override { return uploads_; }
  IdempotencyKeys& idempotency_keys() override { return *this; }

  KeyRecord Take(const std::string& key) override;
  void Finish(const std::string& key, const KeyRecord& answer) override;
  void Release(const std::string& key) override;

  std::string health() const override;
  std::vector<std::string> Verify() const override;

 private:
  // `work(database)` in one snapshot.
  template <typename Work>
  auto Read(Work work) const;
  // `work(database)` in one transaction, durable when this returns.
  template <typename Work>
  auto Write(Work work);
  void CheckpointIfDue();

  FolderLock lock_;
  mutable Health health_;
  BlobFolder blobs_;
  Uploads uploads_;
  const int checkpoint_pages_;
  std::mutex writer_mutex_;
  Database writer_;
  unsigned finished_keys_ = 0;  // with the writer
  mutable ReaderPool readers_;  // closed before the writer, which tidies up
};

}  // namespace lares::store
