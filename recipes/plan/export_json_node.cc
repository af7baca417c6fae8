#include "recipes/plan/export_json_node.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace lares::recipes {
namespace {

constexpr std::size_t kMaxItems = 10'000;         // of one array or object
constexpr std::size_t kMaxText_bytes = 1u << 16;  // of one text

}  // namespace

void JsonNode::Fail(const std::string& what) const {
  throw Error(Code::kInvalid, (pointer.empty() ? "/" : pointer) + " " + what);
}

JsonNode JsonNode::At(const std::string& name) const {
  std::string escaped;
  for (const char c : name) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return {value.at(name), pointer + "/" + escaped};
}

bool JsonNode::IsNull() const { return value.is_null(); }

JsonMembers::JsonMembers(const JsonNode& node) : node_(node) {
  if (!node.value.is_object()) node.Fail("must be an object");
  if (node.value.size() > kMaxItems) node.Fail("has too many members");
}

JsonNode JsonMembers::Required(const char* name) {
  if (!Has(name)) node_.Fail("lacks \"" + std::string(name) + "\"");
  return node_.At(name);
}

std::optional<JsonNode> JsonMembers::Optional(const char* name) {
  return Has(name) ? std::optional<JsonNode>(node_.At(name)) : std::nullopt;
}

void JsonMembers::RefuseOthers() const {
  for (const auto& item : node_.value.items()) {
    if (known_.count(item.key()) == 0) node_.At(item.key()).Fail("is not known here");
  }
}

bool JsonMembers::Has(const char* name) {
  known_.insert(name);
  return node_.value.contains(name);
}

std::string ReadText(const JsonNode& node) {
  if (!node.value.is_string()) node.Fail("must be a text");
  const auto& text = node.value.get_ref<const std::string&>();
  if (text.size() > kMaxText_bytes) node.Fail("is too long");
  return text;
}

std::string ReadFilledText(const JsonNode& node) {
  std::string text = ReadText(node);
  if (text.empty()) node.Fail("must not be empty");
  return text;
}

bool ReadBoolean(const JsonNode& node) {
  if (!node.value.is_boolean()) node.Fail("must be true or false");
  return node.value.get<bool>();
}

std::int64_t ReadWhole(const JsonNode& node, std::int64_t most) {
  if (!node.value.is_number_integer()) node.Fail("must be a whole number");
  const bool large = node.value.is_number_unsigned() &&
                     node.value.get<std::uint64_t>() > static_cast<std::uint64_t>(most);
  const std::int64_t number = large ? -1 : node.value.get<std::int64_t>();
  if (number < 0 || number > most) node.Fail("must be from 0 to " + std::to_string(most));
  return number;
}

double ReadNumber(const JsonNode& node) {
  if (!node.value.is_number()) node.Fail("must be a number");
  const double number = node.value.get<double>();
  if (!std::isfinite(number)) node.Fail("must be finite");
  return number;
}

Resource ReadResource(const JsonNode& node) {
  JsonMembers members(node);
  Resource resource{ReadText(members.Required("iri")), ReadText(members.Required("label")),
                    ReadText(members.Required("as_written"))};
  members.RefuseOthers();
  return resource;
}

std::vector<JsonNode> JsonItems(const JsonNode& node) {
  if (!node.value.is_array()) node.Fail("must be an array");
  if (node.value.size() > kMaxItems) node.Fail("has too many items");
  std::vector<JsonNode> items;
  items.reserve(node.value.size());
  for (const auto& item : node.value) {
    items.push_back({item, node.pointer + "/" + std::to_string(items.size())});
  }
  return items;
}

std::vector<std::string> JsonNames(const JsonNode& node) {
  if (!node.value.is_object()) node.Fail("must be an object");
  if (node.value.size() > kMaxItems) node.Fail("has too many members");
  std::vector<std::string> names;
  for (const auto& item : node.value.items()) names.push_back(item.key());
  return names;
}

}  // namespace lares::recipes
