// Which role each operation of the interface needs: the x-lares-… members of operations.json.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/access/grant.h"

namespace lares::access {

struct Rule {
  // x-lares-role; without it nobody but an admin.
  Role role = Role::kAdmin;
  // x-lares-kind: "write" is kept in the audit log, "query" has a place among those that run at
  // once. When absent: "read" for a GET, else "write".
  enum class Kind { kRead, kQuery, kWrite };
  Kind kind = Kind::kWrite;
  // x-lares-environments: where the request names environments that the token has to reach. "path":
  // its {id}; "named": in a query or body, looked at by the handler; "listed": the answer leaves
  // out what the token does not reach; "none".
  enum class Environments { kNone, kPath, kNamed, kListed };
  Environments environments = Environments::kNone;
};

class AccessTable {
 public:
  // Throws kInternal for JSON that cannot be read and for words that are not known.
  explicit AccessTable(std::string_view operations_json);

  // The rule of an operation that `method` asks for; the strictest one when none is stated.
  Rule Of(const std::string& operation, std::string_view method) const;
  bool Has(const std::string& operation) const { return stated_.contains(operation); }

 private:
  struct Stated {
    Rule rule;
    bool has_kind = false;
  };
  std::map<std::string, Stated> stated_;
};

}  // namespace lares::access
