// Strict reading of JSON: every value knows where it stands, every fault names its JSON pointer.
// All of it throws kInvalid.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "recipes/resource.h"

namespace lares::recipes {

constexpr std::int64_t kMaxWhole = 1'000'000'000;

// A value and where it stands: "/states/0/inputs/2/value".
struct JsonNode {
  const nlohmann::json& value;
  std::string pointer;

  [[noreturn]] void Fail(const std::string& what) const;
  JsonNode At(const std::string& name) const;  // a member that is there
  bool IsNull() const;
};

// The members of an object: those asked for are the known ones.
class JsonMembers {
 public:
  explicit JsonMembers(const JsonNode& node);

  JsonNode Required(const char* name);
  std::optional<JsonNode> Optional(const char* name);
  void RefuseOthers() const;

 private:
  bool Has(const char* name);

  JsonNode node_;
  std::set<std::string> known_;
};

std::string ReadText(const JsonNode& node);        // at most 64 KiB
std::string ReadFilledText(const JsonNode& node);  // not empty
bool ReadBoolean(const JsonNode& node);
std::int64_t ReadWhole(const JsonNode& node, std::int64_t most);  // from 0
double ReadNumber(const JsonNode& node);                          // finite
Resource ReadResource(const JsonNode& node);

std::vector<JsonNode> JsonItems(const JsonNode& node);     // of an array, at most 10 000
std::vector<std::string> JsonNames(const JsonNode& node);  // of an object's members, as many

template <typename Read>
auto ReadArray(const JsonNode& node, const Read& read) {
  std::vector<decltype(read(node))> items;
  for (const JsonNode& item : JsonItems(node)) items.push_back(read(item));
  return items;
}

// Nothing where there is no such member.
template <typename Read>
auto ReadArrayIfThere(JsonMembers& members, const char* name, const Read& read) {
  const std::optional<JsonNode> node = members.Optional(name);
  return node ? ReadArray(*node, read) : decltype(ReadArray(*node, read)){};
}

inline std::vector<std::string> ReadTexts(const JsonNode& node) {
  return ReadArray(node, ReadText);
}
inline std::vector<Resource> ReadResources(const JsonNode& node) {
  return ReadArray(node, ReadResource);
}

// The value whose name it is; `name` gives the names.
template <typename Value, std::size_t n>
Value ReadOneOf(const JsonNode& node, const std::array<Value, n>& values,
                std::string_view (*name)(Value)) {
  const std::string text = ReadText(node);
  std::string known;
  for (const Value value : values) {
    if (name(value) == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  node.Fail("must be one of " + known);
}

}  // namespace lares::recipes
