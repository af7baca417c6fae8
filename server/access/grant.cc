#include "server/access/grant.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace lares::access {
namespace {

constexpr Role kRoles[] = {Role::kPublic, Role::kReader, Role::kRobot, Role::kEditor, Role::kAdmin};

}  // namespace

std::string_view ToString(Role role) {
  switch (role) {
    case Role::kPublic:
      return "public";
    case Role::kReader:
      return "reader";
    case Role::kRobot:
      return "robot";
    case Role::kEditor:
      return "editor";
    case Role::kAdmin:
      return "admin";
  }
  return "admin";
}

std::optional<Role> ParseRole(std::string_view name) {
  for (const Role role : kRoles) {
    if (ToString(role) == name) return role;
  }
  return std::nullopt;
}

bool Reaches(const Grant& grant, std::string_view environment) {
  if (grant.environments.empty()) return true;
  return std::any_of(grant.environments.begin(), grant.environments.end(),
                     [&](std::string_view pattern) {
                       if (!pattern.ends_with('*')) return pattern == environment;
                       return environment.starts_with(pattern.substr(0, pattern.size() - 1));
                     });
}

void CheckPattern(std::string_view pattern) {
  std::string_view id = pattern;
  if (id.ends_with('*')) id.remove_suffix(1);
  if (IsIdentifier(id)) return;
  throw Error(Code::kInvalid, "'" + std::string(pattern.substr(0, 200)) +
                                  "' names no environments: an id, or the beginning of one and '*'")
      .WithHint("leave it out for a token that reaches every environment");
}

}  // namespace lares::access
