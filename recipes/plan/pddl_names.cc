#include "recipes/plan/pddl_names.h"

#include <cctype>

namespace lares::recipes {
namespace {

// What the language itself says: a reader might take it for that.
const std::set<std::string>& Reserved() {
  static const std::set<std::string> words = {
      "and",    "or",     "not",    "imply",   "exists", "forall",   "when",    "either",
      "object", "define", "domain", "problem", "action", "number",   "at",      "over",
      "start",  "end",    "state",  "value",   "assign", "increase", "decrease"};
  return words;
}

}  // namespace

std::string PddlName(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 || c == '-' || c == '_');
    name += plain ? static_cast<char>(std::tolower(byte)) : '_';
  }
  const bool begins = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
  if (!begins) name.insert(0, "x");
  return Reserved().count(name) > 0 ? name + "_" : name;
}

const std::string& PddlNames::Of(const std::string& thing, std::string_view plain) {
  const auto known = names_.find(thing);
  if (known != names_.end()) return known->second;
  const std::string wanted = PddlName(plain);
  std::string name = wanted;
  for (int number = 2; !taken_.insert(name).second; ++number) {
    name = wanted + "-" + std::to_string(number);
  }
  return names_.emplace(thing, name).first->second;
}

}  // namespace lares::recipes
