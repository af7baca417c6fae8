// The store over SQLite and plain files. Private to this folder and its tests; others include
// store.h.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/store/files.h"
#include "server/store/sql_store.h"
#include "server/store/sqlite.h"

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
    std::unique_ptr<SqliteDatabase> database_;
  };

 private:
  std::filesystem::path file_;
  std::string vfs_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<SqliteDatabase>> idle_;
};

class SqliteStore final : public SqlStore {
 public:
  SqliteStore(const std::filesystem::path& folder, const Seams& seams);
  ~SqliteStore() override;

  bool shared() const override { return false; }
  std::unique_ptr<Hold> HoldCatalogue() override;

 private:
  void Reading(const Work& work) const override;
  void Writing(const Work& work) override;
  std::vector<std::string> VerifyFile(Database& database) const override;
  void CheckpointIfDue();

  const int checkpoint_pages_;
  std::mutex writer_mutex_;
  SqliteDatabase writer_;
  mutable ReaderPool readers_;  // closed before the writer, which tidies up
};

}  // namespace lares::store
