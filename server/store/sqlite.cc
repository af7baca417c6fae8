#include "server/store/sqlite.h"

#include <sqlite3.h>

#include <cstring>

#include "base/error.h"

namespace lares::store {
namespace {

constexpr int kBusyTimeoutMs = 10000;

Code CodeOf(int result) {
  switch (result & 0xff) {
    case SQLITE_FULL:
      return Code::kUnavailable;
    case SQLITE_IOERR:
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return Code::kIo;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return Code::kTimeout;
    case SQLITE_TOOBIG:
      return Code::kTooLarge;
    default:
      return Code::kInternal;
  }
}

[[noreturn]] void Throw(sqlite3* connection, int result, std::string_view what) {
  const char* file = connection == nullptr ? nullptr : sqlite3_db_filename(connection, "main");
  std::string message = "database";
  if (file != nullptr && *file != '\0') message += std::string(" '") + file + "'";
  message += ": ";
  message += connection == nullptr ? sqlite3_errstr(result) : sqlite3_errmsg(connection);
  const int system_error = connection == nullptr ? 0 : sqlite3_system_errno(connection);
  if ((result & 0xff) == SQLITE_IOERR && system_error != 0) {
    message += std::string(": ") + std::strerror(system_error);
  }
  throw Error(CodeOf(result),
              message + " (" + std::to_string(result) + ", " + std::string(what) + ")");
}

void Bind(sqlite3* connection, sqlite3_stmt* statement, int index, const Value& value) {
  int result = SQLITE_OK;
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    result = sqlite3_bind_int64(statement, index, *number);
  } else {
    const auto text = std::get<std::string_view>(value);
    // A null pointer would be NULL, not "".
    result = sqlite3_bind_text64(statement, index, text.empty() ? "" : text.data(), text.size(),
                                 SQLITE_TRANSIENT, SQLITE_UTF8);
  }
  if (result != SQLITE_OK) Throw(connection, result, "binding");
}

// Borrows a statement of the connection's cache.
class SqliteCursor final : public Cursor {
 public:
  SqliteCursor(sqlite3* connection, sqlite3_stmt* statement, std::span<const Value> values)
      : connection_(connection), statement_(statement) {
    if (static_cast<int>(values.size()) != sqlite3_bind_parameter_count(statement_)) {
      throw Error(Code::kInternal,
                  std::string("wrong number of values for: ") + sqlite3_sql(statement_));
    }
    int index = 0;
    for (const Value& value : values) Bind(connection_, statement_, ++index, value);
  }
  ~SqliteCursor() override {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }
  SqliteCursor(const SqliteCursor&) = delete;
  SqliteCursor& operator=(const SqliteCursor&) = delete;

  bool Next() override {
    const int result = sqlite3_step(statement_);
    if (result == SQLITE_ROW) return true;
    if (result != SQLITE_DONE) Throw(connection_, result, sqlite3_sql(statement_));
    return false;
  }
  std::int64_t Int(int column) const override { return sqlite3_column_int64(statement_, column); }
  std::string Text(int column) const override {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    if (text == nullptr) return "";
    return {text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
  }

 private:
  sqlite3* connection_;
  sqlite3_stmt* statement_;
};

}  // namespace

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file, Access access,
                               const std::string& vfs) {
  const int flags =
      SQLITE_OPEN_NOMUTEX |
      (access == Access::kRead ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const int result =
      sqlite3_open_v2(file.c_str(), &connection_, flags, vfs.empty() ? nullptr : vfs.c_str());
  if (result != SQLITE_OK) {
    const std::string message = sqlite3_errstr(result);
    sqlite3_close_v2(connection_);
    throw Error(CodeOf(result), "cannot open '" + file.string() + "': " + message);
  }
  sqlite3_extended_result_codes(connection_, 1);
  sqlite3_busy_timeout(connection_, kBusyTimeoutMs);
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  // Also replaces SQLite's own checkpoints, which swallow their faults.
  sqlite3_wal_hook(
      connection_,
      [](void* self, sqlite3*, const char*, int pages) {
        static_cast<SqliteDatabase*>(self)->log_pages_ = pages;
        return SQLITE_OK;
      },
      this);
}

SqliteDatabase::~SqliteDatabase() {
  for (const auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close_v2(connection_);
}

sqlite3_stmt* SqliteDatabase::Compiled(std::string_view sql) {
  if (const auto found = statements_.find(sql); found != statements_.end()) return found->second;
  sqlite3_stmt* statement = nullptr;
  const int result = sqlite3_prepare_v3(connection_, sql.data(), static_cast<int>(sql.size()),
                                        SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (result != SQLITE_OK) Throw(connection_, result, sql);
  statements_.emplace(sql, statement);
  return statement;
}

Query SqliteDatabase::Ask(std::string_view sql, std::span<const Value> values) {
  sqlite3_stmt* statement = Compiled(sql);
  if (sqlite3_stmt_busy(statement) != 0) {
    throw Error(Code::kInternal, "asked again while being read: " + std::string(sql));
  }
  return Query(std::make_unique<SqliteCursor>(connection_, statement, values));
}

void SqliteDatabase::Each(const std::string& sql, const std::function<void(const Cursor&)>& row) {
  SqliteCursor cursor(connection_, Compiled(sql), {});
  while (cursor.Next()) row(cursor);
}

void SqliteDatabase::RunScript(const std::string& sql) {
  const int result = sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr);
  if (result != SQLITE_OK) Throw(connection_, result, "script");
}

bool SqliteDatabase::in_transaction() const { return sqlite3_get_autocommit(connection_) == 0; }

void SqliteDatabase::Checkpoint() { RunCheckpoint(SQLITE_CHECKPOINT_PASSIVE); }

void SqliteDatabase::CheckpointWhole() { RunCheckpoint(SQLITE_CHECKPOINT_TRUNCATE); }

void SqliteDatabase::RunCheckpoint(int mode) {
  const int result = sqlite3_wal_checkpoint_v2(connection_, nullptr, mode, nullptr, nullptr);
  // Busy only means that a reader still needs a part of the log.
  if (result != SQLITE_OK && (result & 0xff) != SQLITE_BUSY) {
    Throw(connection_, result, "checkpoint");
  }
}

void SqliteDatabase::TidyOnClose() {
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr);
}

}  // namespace lares::store
