// A database as values: a question with its rows, a transaction. SQLite (sqlite.h) and PostgreSQL
// (postgres.h) stand behind it; every statement of this folder is written so that both take it:
// `?` or `?1` for values, no function that only one of them has. A fault is an Error: kUnavailable
// when there is no room or no connection, kIo when storage failed or is damaged, kTimeout when
// locked, kInternal when the SQL is wrong.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace lares::store {

using Value = std::variant<std::int64_t, std::string_view>;

// The rows of one answer, one at a time. NULL reads as 0 and as "".
class Cursor {
 public:
  virtual ~Cursor() = default;
  virtual bool Next() = 0;  // false after the last row
  virtual std::int64_t Int(int column) const = 0;
  virtual std::string Text(int column) const = 0;
};

// Used by one thread, while its database lives.
class Query {
 public:
  explicit Query(std::unique_ptr<Cursor> cursor) : cursor_(std::move(cursor)) {}
  bool Next() { return cursor_->Next(); }
  std::int64_t Int(int column) const { return cursor_->Int(column); }
  std::string Text(int column) const { return cursor_->Text(column); }

 private:
  std::unique_ptr<Cursor> cursor_;
};

// One connection; used by one thread at a time.
class Database {
 public:
  virtual ~Database() = default;

  // Values are copied. Statements are compiled once. The same text may not be asked again while
  // its rows are being read.
  Query Ask(std::string_view sql, std::initializer_list<Value> values = {}) {
    return Ask(sql, std::span<const Value>(values.begin(), values.size()));
  }
  virtual Query Ask(std::string_view sql, std::span<const Value> values) = 0;
  void Run(std::string_view sql, std::initializer_list<Value> values = {}) {
    Run(sql, std::span<const Value>(values.begin(), values.size()));
  }
  void Run(std::string_view sql, std::span<const Value> values) {
    Query query = Ask(sql, values);
    while (query.Next()) {
    }
  }
  // The one number that an INSERT … RETURNING or a count gives.
  std::int64_t AskInt(std::string_view sql, std::initializer_list<Value> values = {}) {
    Query query = Ask(sql, values);
    return query.Next() ? query.Int(0) : 0;
  }
  // Rows of any number in constant memory, given to `row` one by one, in a transaction; not to be
  // nested.
  virtual void Each(const std::string& sql, const std::function<void(const Cursor&)>& row) = 0;
  // Several statements, not cached, without values.
  virtual void RunScript(const std::string& sql) = 0;

  // One snapshot for reading.
  virtual void BeginRead() = 0;
  // Alone among writers, of other processes too.
  virtual void BeginWrite() = 0;
  virtual void Commit() = 0;
  virtual void RollBack() = 0;
  virtual bool in_transaction() const = 0;

  enum class Dialect { kSqlite, kPostgres };
  virtual Dialect dialect() const = 0;
};

// Rolled back unless committed.
class Transaction {
 public:
  enum class Kind { kRead, kWrite };
  Transaction(Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void Commit() { database_.Commit(); }

 private:
  Database& database_;
};

}  // namespace lares::store
