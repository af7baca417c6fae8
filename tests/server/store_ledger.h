// What a store has acknowledged, and whether it is still there.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "server/store/store.h"

namespace lares::store::testing {

struct Ledger {
  std::map<std::string, std::vector<std::string>> documents;  // recipe id → bytes by version
  std::map<std::string, bool> deleted;                        // by recipe id
  // Environment → layers (name → SHA-256) by version.
  std::map<std::string, std::vector<std::map<std::string, std::string>>> environments;
  std::map<std::string, std::string> blobs;  // SHA-256 → bytes
  std::set<std::string> of_others;           // ids that somebody else writes: not looked at
};

// One sentence for each acknowledged write that `store` lacks or shows otherwise, and for each
// thing in it that was neither acknowledged nor under way: the documents and environments
// `under_way` may have one version more, or be deleted or not.
std::vector<std::string> Missing(const Store& store, const Ledger& ledger,
                                 const std::set<std::string>& under_way);

// Takes what was under way and is there into the ledger.
void Absorb(const Store& store, const std::set<std::string>& under_way, Ledger& ledger);

}  // namespace lares::store::testing
