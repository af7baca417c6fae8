#include "server/store/postgres.h"

#include <libpq-fe.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

#include "base/error.h"
#include "base/text.h"

namespace lares::store {
namespace {

// Any number that nothing else in the database uses for its advisory locks.
constexpr const char* kWriterLock = "SELECT pg_advisory_xact_lock(6171737301)";
constexpr int kRowsAtOnce = 500;

Code CodeOf(PGconn* connection, const PGresult* result) {
  if (PQstatus(connection) != CONNECTION_OK) return Code::kUnavailable;
  const char* state = result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const std::string_view code = state == nullptr ? "" : state;
  if (code.starts_with("08") || code.starts_with("53") || code.starts_with("57")) {
    return Code::kUnavailable;  // connection, no room or memory, shutting down
  }
  if (code.starts_with("40") || code == "55P03") return Code::kTimeout;  // deadlock, lock
  if (code.starts_with("58") || code.starts_with("XX") || code == "25006") return Code::kIo;
  return Code::kInternal;
}

[[noreturn]] void Throw(PGconn* connection, const PGresult* result, std::string_view what) {
  const std::string message = result != nullptr ? PQresultErrorMessage(result) : "";
  const std::string reason = message.empty() ? PQerrorMessage(connection) : message;
  throw Error(CodeOf(connection, result), "PostgreSQL: " + Join(Split(Trim(reason), '\n'), "; ") +
                                              " (" + std::string(what.substr(0, 200)) + ")");
}

// An answer, freed at its end.
class Result {
 public:
  Result(PGconn* connection, PGresult* result, std::string_view what) : result_(result) {
    const ExecStatusType status = PQresultStatus(result);
    if (status == PGRES_TUPLES_OK || status == PGRES_COMMAND_OK) return;
    try {
      Throw(connection, result, what);
    } catch (...) {
      PQclear(result);
      throw;
    }
  }
  ~Result() { PQclear(result_); }
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  PGresult* get() const { return result_; }

 private:
  PGresult* result_;
};

// All rows are here already.
class PostgresCursor final : public Cursor {
 public:
  explicit PostgresCursor(std::unique_ptr<Result> result)
      : result_(std::move(result)), rows_(PQntuples(result_->get())) {}

  bool Next() override { return ++row_ < rows_; }
  std::int64_t Int(int column) const override {
    const std::string_view text = View(column);
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
  std::string Text(int column) const override { return std::string(View(column)); }

 private:
  std::string_view View(int column) const {
    return {PQgetvalue(result_->get(), row_, column),
            static_cast<std::size_t>(PQgetlength(result_->get(), row_, column))};
  }

  std::unique_ptr<Result> result_;
  int rows_;
  int row_ = -1;
};

std::unique_ptr<Result> Execute(PGconn* connection, const std::string& sql) {
  return std::make_unique<Result>(connection, PQexec(connection, sql.c_str()), sql);
}

// `?` and `?2` become `$1`, `$2`, …; no statement of ours has a question mark in a literal.
std::string WithDollars(std::string_view sql) {
  std::string text;
  int next = 0;
  for (std::size_t i = 0; i < sql.size(); ++i) {
    if (sql[i] != '?') {
      text += sql[i];
      continue;
    }
    const bool numbered = i + 1 < sql.size() && sql[i + 1] >= '0' && sql[i + 1] <= '9';
    text += numbered ? "$" : "$" + std::to_string(++next);
  }
  return text;
}

// Values as the protocol's text.
class Parameters {
 public:
  explicit Parameters(std::span<const Value> values) : texts_(values.size()) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (const auto* number = std::get_if<std::int64_t>(&values[i])) {
        texts_[i] = std::to_string(*number);
      } else {
        texts_[i] = std::get<std::string_view>(values[i]);
      }
      // What is written has no NUL (CheckText); what is looked for and has one is nowhere.
      std::replace(texts_[i].begin(), texts_[i].end(), '\0', '\x1a');
      pointers_.push_back(texts_[i].c_str());
    }
  }
  int count() const { return static_cast<int>(pointers_.size()); }
  const char* const* data() const { return pointers_.data(); }

 private:
  std::vector<std::string> texts_;
  std::vector<const char*> pointers_;
};

}  // namespace

PostgresDatabase::PostgresDatabase(const std::string& connection)
    : connection_(PQconnectdb(connection.c_str())) {
  if (PQstatus(connection_) != CONNECTION_OK) {
    const std::string reason(Trim(PQerrorMessage(connection_)));
    PQfinish(connection_);
    throw Error(Code::kUnavailable,
                "PostgreSQL cannot be reached: " + Join(Split(reason, '\n'), "; "));
  }
  PQsetNoticeProcessor(
      connection_, [](void*, const char*) {}, nullptr);
  try {
    Execute(connection_,
            "SET client_encoding = 'UTF8'; SET synchronous_commit = on; SET lock_timeout = '20s'; "
            "SET statement_timeout = 0; SET idle_in_transaction_session_timeout = '10min'");
  } catch (...) {
    PQfinish(connection_);
    throw;
  }
}

PostgresDatabase::~PostgresDatabase() { PQfinish(connection_); }

const std::string& PostgresDatabase::Prepared(std::string_view sql) {
  if (const auto found = statements_.find(sql); found != statements_.end()) return found->second;
  const std::string name = "s" + std::to_string(statements_.size());
  const Result made(
      connection_, PQprepare(connection_, name.c_str(), WithDollars(sql).c_str(), 0, nullptr), sql);
  return statements_.emplace(sql, name).first->second;
}

Query PostgresDatabase::Ask(std::string_view sql, std::span<const Value> values) {
  const Parameters parameters(values);
  const std::string& name = Prepared(sql);
  auto result =
      std::make_unique<Result>(connection_,
                               PQexecPrepared(connection_, name.c_str(), parameters.count(),
                                              parameters.data(), nullptr, nullptr, 0),
                               sql);
  return Query(std::make_unique<PostgresCursor>(std::move(result)));
}

void PostgresDatabase::Each(const std::string& sql, const std::function<void(const Cursor&)>& row) {
  Execute(connection_, "DECLARE rows_of_each NO SCROLL CURSOR FOR " + sql);
  for (bool more = true; more;) {
    PostgresCursor cursor(
        Execute(connection_, "FETCH " + std::to_string(kRowsAtOnce) + " FROM rows_of_each"));
    more = false;
    while (cursor.Next()) {
      more = true;
      row(cursor);
    }
  }
  Execute(connection_, "CLOSE rows_of_each");
}

void PostgresDatabase::RunScript(const std::string& sql) { Execute(connection_, sql); }

void PostgresDatabase::BeginRead() {
  Execute(connection_, "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
}

void PostgresDatabase::BeginWrite() {
  Execute(connection_, "BEGIN ISOLATION LEVEL READ COMMITTED");
  Execute(connection_, kWriterLock);
}

void PostgresDatabase::Commit() {
  try {
    // A transaction in which something failed answers COMMIT with ROLLBACK, and no error.
    const std::unique_ptr<Result> done = Execute(connection_, "COMMIT");
    if (std::string_view(PQcmdStatus(done->get())) != "COMMIT") {
      throw Error(Code::kInternal, "PostgreSQL rolled a transaction back instead of committing it");
    }
  } catch (const Error& error) {
    if (connected()) throw;
    throw Error(Code::kUnavailable,
                "the connection to PostgreSQL broke while it committed: whether the write is kept "
                "is not known")
        .WithHint("look whether it is there before it is sent again");
  }
}

void PostgresDatabase::RollBack() { Execute(connection_, "ROLLBACK"); }

bool PostgresDatabase::in_transaction() const {
  const PGTransactionStatusType status = PQtransactionStatus(connection_);
  return status == PQTRANS_INTRANS || status == PQTRANS_INERROR;
}

bool PostgresDatabase::connected() const { return PQstatus(connection_) == CONNECTION_OK; }

std::string PostgresDatabase::Setting(const std::string& name) {
  PostgresCursor cursor(Execute(connection_, "SHOW " + name));
  return cursor.Next() ? cursor.Text(0) : "";
}

}  // namespace lares::store
