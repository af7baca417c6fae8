// What a caller may do: a role, the environments it reaches, and how much of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/time.h"

namespace lares::access {

// Each may do what those before it may. kPublic needs no token.
enum class Role { kPublic, kReader, kRobot, kEditor, kAdmin };
// "public", "reader", "robot", "editor", "admin"
std::string_view ToString(Role role);
std::optional<Role> ParseRole(std::string_view name);

// 0: none.
struct Limits {
  std::int64_t max_requests_per_minute = 6'000;
  std::int64_t max_bytes_per_day = std::int64_t{100} << 30;  // that writes take in, from 0:00 UTC
  std::int64_t max_queries = 8;                              // that run at the same time
};

struct Grant {
  std::string token;  // id; "" while the store has no token: everybody may do everything
  std::string label;
  Role role = Role::kAdmin;
  std::vector<std::string> environments;  // ids, or prefixes that end with '*'; empty: all
  Limits limits;
  std::optional<Time> expires;
};

bool Reaches(const Grant& grant, std::string_view environment);

// Throws kInvalid unless `pattern` is an environment's id, or the beginning of one and '*'.
void CheckPattern(std::string_view pattern);

}  // namespace lares::access
