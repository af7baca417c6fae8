#include "server/store/tokens.h"

#include "base/error.h"
#include "base/text.h"
#include "server/store/conditions.h"

namespace lares::store {
namespace {

#define LARES_TOKEN_COLUMNS                                                          \
  "SELECT id, label, role, environments, secret_sha256, created, expires, revoked, " \
  "max_requests_per_minute, max_bytes_per_day, max_queries FROM tokens "

// 0 in the table: never.
std::optional<Time> TimeOrNever(std::int64_t milliseconds) {
  if (milliseconds == 0) return std::nullopt;
  return Time(std::chrono::milliseconds(milliseconds));
}

std::int64_t Milliseconds(const std::optional<Time>& time) {
  return time ? time->time_since_epoch().count() : 0;
}

TokenRecord ReadToken(const Query& row) {
  TokenRecord token;
  token.id = row.Text(0);
  token.label = row.Text(1);
  token.role = row.Text(2);
  if (const std::string environments = row.Text(3); !environments.empty()) {
    token.environments = Split(environments, ' ');
  }
  token.secret_sha256 = row.Text(4);
  token.created = Time(std::chrono::milliseconds(row.Int(5)));
  token.expires = TimeOrNever(row.Int(6));
  token.revoked = TimeOrNever(row.Int(7));
  token.max_requests_per_minute = row.Int(8);
  token.max_bytes_per_day = row.Int(9);
  token.max_queries = row.Int(10);
  return token;
}

}  // namespace

void AddToken(Database& database, const TokenRecord& token) {
  CheckId(token.id, "token");
  CheckText(token.label, "the token's label");
  if (FindToken(database, token.id)) {
    throw Error(Code::kConflict, "there is a token '" + token.id + "' already");
  }
  database.Run(
      "INSERT INTO tokens (id, label, role, environments, secret_sha256, created, expires, "
      "revoked, max_requests_per_minute, max_bytes_per_day, max_queries) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {token.id, token.label, token.role, Join(token.environments, " "), token.secret_sha256,
       token.created.time_since_epoch().count(), Milliseconds(token.expires),
       Milliseconds(token.revoked), token.max_requests_per_minute, token.max_bytes_per_day,
       token.max_queries});
}

std::optional<TokenRecord> FindToken(Database& database, const std::string& id) {
  Query query = database.Ask(LARES_TOKEN_COLUMNS "WHERE id = ?", {id});
  if (!query.Next()) return std::nullopt;
  return ReadToken(query);
}

std::vector<TokenRecord> ListTokens(Database& database) {
  std::vector<TokenRecord> tokens;
  Query query = database.Ask(LARES_TOKEN_COLUMNS "ORDER BY created, id");
  while (query.Next()) tokens.push_back(ReadToken(query));
  return tokens;
}

bool HasTokens(Database& database) { return database.Ask("SELECT 1 FROM tokens LIMIT 1").Next(); }

TokenRecord RevokeToken(Database& database, const std::string& id, Time when) {
  database.Run("UPDATE tokens SET revoked = ? WHERE id = ? AND revoked = 0",
               {when.time_since_epoch().count(), id});
  if (auto token = FindToken(database, id)) return *std::move(token);
  throw Error(Code::kNotFound, "there is no token '" + id.substr(0, 200) + "'");
}

}  // namespace lares::store
