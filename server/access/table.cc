#include "server/access/table.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace lares::access {
namespace {

using nlohmann::json;

[[noreturn]] void Unknown(const std::string& operation, const char* member,
                          const std::string& word) {
  throw Error(Code::kInternal,
              "operation " + operation + " has '" + word + "' as " + member + ", which is unknown");
}

std::string Word(const json& described, const char* member, const std::string& otherwise) {
  const auto found = described.find(member);
  return found == described.end() ? otherwise : found->get<std::string>();
}

Rule::Kind KindOf(const std::string& operation, const std::string& word) {
  if (word == "read") return Rule::Kind::kRead;
  if (word == "query") return Rule::Kind::kQuery;
  if (word == "write") return Rule::Kind::kWrite;
  Unknown(operation, "x-lares-kind", word);
}

Rule::Environments EnvironmentsOf(const std::string& operation, const std::string& word) {
  if (word == "none") return Rule::Environments::kNone;
  if (word == "path") return Rule::Environments::kPath;
  if (word == "named") return Rule::Environments::kNamed;
  if (word == "listed") return Rule::Environments::kListed;
  Unknown(operation, "x-lares-environments", word);
}

}  // namespace

AccessTable::AccessTable(std::string_view operations_json) {
  const json document = json::parse(operations_json, nullptr, false);
  if (!document.is_object() || !document.contains("operations")) {
    throw Error(Code::kInternal, "the description of the operations cannot be read");
  }
  for (const auto& [operation, described] : document["operations"].items()) {
    if (!described.contains("x-lares-role")) continue;
    Stated stated;
    const std::string role = Word(described, "x-lares-role", "");
    const auto parsed = ParseRole(role);
    if (!parsed) Unknown(operation, "x-lares-role", role);
    stated.rule.role = *parsed;
    stated.has_kind = described.contains("x-lares-kind");
    if (stated.has_kind) stated.rule.kind = KindOf(operation, Word(described, "x-lares-kind", ""));
    stated.rule.environments =
        EnvironmentsOf(operation, Word(described, "x-lares-environments", "none"));
    stated_[operation] = stated;
  }
}

Rule AccessTable::Of(const std::string& operation, std::string_view method) const {
  const auto found = stated_.find(operation);
  Stated stated = found == stated_.end() ? Stated{} : found->second;
  if (!stated.has_kind) {
    stated.rule.kind = method == "GET" || method == "HEAD" ? Rule::Kind::kRead : Rule::Kind::kWrite;
  }
  return stated.rule;
}

}  // namespace lares::access
