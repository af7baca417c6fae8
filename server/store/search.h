// Finding environments by what is said of them. Each function runs in the caller's transaction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// After `head` became the newest version: its own keys (layers, words) anew, and those of its
// semantic layer where they are given.
void UpdateKeys(Database& database, const EnvironmentVersion& head,
                const std::optional<std::vector<SearchKey>>& keys);

// Throws kInvalid when a key or a search cannot be stored or asked.
void CheckKeys(const std::vector<SearchKey>& keys);
void CheckSearch(const EnvironmentSearch& search);

// As the members of Store. PutKeys does nothing when `number` is no longer the head.
std::vector<EnvironmentInfo> SearchEnvironments(Database& database,
                                                const EnvironmentSearch& search);
std::vector<std::string> SearchValues(Database& database, const std::string& field);
std::vector<std::string> EnvironmentsWithoutKeys(Database& database);
void PutKeys(Database& database, const std::string& id, int number,
             const std::vector<SearchKey>& keys);

}  // namespace lares::store
