// PostgreSQL behind Database.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "server/store/database.h"

struct pg_conn;
struct pg_result;

namespace lares::store {

class PostgresDatabase final : public Database {
 public:
  // `connection` as libpq takes it. Throws kUnavailable when the server cannot be reached.
  explicit PostgresDatabase(const std::string& connection);
  ~PostgresDatabase() override;
  PostgresDatabase(const PostgresDatabase&) = delete;
  PostgresDatabase& operator=(const PostgresDatabase&) = delete;

  using Database::Ask;
  Query Ask(std::string_view sql, std::span<const Value> values) override;
  void Each(const std::string& sql, const std::function<void(const Cursor&)>& row) override;
  void RunScript(const std::string& sql) override;
  void BeginRead() override;
  // One writer at a time among all that have the database open.
  void BeginWrite() override;
  // kUnavailable when the connection broke: then nobody knows whether it was committed.
  void Commit() override;
  void RollBack() override;
  bool in_transaction() const override;
  Dialect dialect() const override { return Dialect::kPostgres; }

  // False once the connection broke: it is of no further use.
  bool connected() const;
  std::string Setting(const std::string& name);  // as SHOW gives it

 private:
  const std::string& Prepared(std::string_view sql);

  pg_conn* connection_ = nullptr;
  std::map<std::string, std::string, std::less<>> statements_;  // text → name
};

}  // namespace lares::store
