// SQLite behind Database.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "server/store/database.h"

struct sqlite3;
struct sqlite3_stmt;

namespace lares::store {

class SqliteDatabase final : public Database {
 public:
  enum class Access { kRead, kWrite };
  // kWrite creates the file when it is absent. `vfs` empty: SQLite's default.
  SqliteDatabase(const std::filesystem::path& file, Access access, const std::string& vfs);
  ~SqliteDatabase() override;
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  using Database::Ask;
  Query Ask(std::string_view sql, std::span<const Value> values) override;
  void Each(const std::string& sql, const std::function<void(const Cursor&)>& row) override;
  void RunScript(const std::string& sql) override;
  void BeginRead() override { Run("BEGIN"); }
  void BeginWrite() override { Run("BEGIN IMMEDIATE"); }
  void Commit() override { Run("COMMIT"); }
  void RollBack() override { Run("ROLLBACK"); }
  bool in_transaction() const override;
  Dialect dialect() const override { return Dialect::kSqlite; }

  // Pages in the write-ahead log after this connection's last commit.
  int log_pages() const { return log_pages_; }
  // Moves what it can of the log into the database file without waiting for readers.
  void Checkpoint();
  // The same, waiting for readers, and empties the log.
  void CheckpointWhole();
  // The last connection moves the log into the file and removes it when closing. (By default the
  // log stays as it is: a store whose disk failed must not touch its files again.)
  void TidyOnClose();

 private:
  sqlite3_stmt* Compiled(std::string_view sql);
  void RunCheckpoint(int mode);

  sqlite3* connection_ = nullptr;
  std::map<std::string, sqlite3_stmt*, std::less<>> statements_;
  int log_pages_ = 0;
};

}  // namespace lares::store
