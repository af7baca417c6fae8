// Tokens as rows: who they are, never what they are. Free functions over a connection; the caller
// holds the transaction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// Throws kConflict when there is one of that id, kInvalid for an id that is no identifier or text
// that is no UTF-8.
void AddToken(Database& database, const TokenRecord& token);
std::optional<TokenRecord> FindToken(Database& database, const std::string& id);
std::vector<TokenRecord> ListTokens(Database& database);  // by creation
bool HasTokens(Database& database);
// The time of a token that is revoked already stays. Throws kNotFound.
TokenRecord RevokeToken(Database& database, const std::string& id, Time when);

}  // namespace lares::store
