// SQLite as values: a connection, a question with its rows, a transaction. A fault is an Error:
// kUnavailable when the disk is full, kIo when it failed or the file is damaged, kTimeout when
// locked, kInternal when the SQL is wrong.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <variant>

struct sqlite3;
struct sqlite3_stmt;

namespace lares::store {

using Value = std::variant<std::int64_t, std::string_view>;

// The rows that answer one statement. Borrowed from the connection's cache; one thread.
class Query {
 public:
  Query(sqlite3* connection, sqlite3_stmt* statement, std::initializer_list<Value> values);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  bool Next();  // false after the last row
  std::int64_t Int(int column) const;
  std::string Text(int column) const;

 private:
  sqlite3* connection_;
  sqlite3_stmt* statement_;
};

// One connection; used by one thread at a time.
class Database {
 public:
  enum class Access { kRead, kWrite };
  // kWrite creates the file when it is absent. `vfs` empty: SQLite's default.
  Database(const std::filesystem::path& file, Access access, const std::string& vfs);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // Values are copied. Statements are compiled once. The same text may not be asked again while
  // its rows are being read.
  Query Ask(std::string_view sql, std::initializer_list<Value> values = {});
  void Run(std::string_view sql, std::initializer_list<Value> values = {});
  // Several statements, not cached, without values.
  void RunScript(const std::string& sql);
  std::int64_t last_key() const;
  bool in_transaction() const;

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

// Rolled back unless committed.
class Transaction {
 public:
  enum class Kind { kRead, kWrite };
  Transaction(Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void Commit();

 private:
  Database& database_;
};

}  // namespace lares::store
