// Names that PDDL can write.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace lares::recipes {

// Lower case, a letter first, then letters, digits, '-' and '_': "Kitchen#2" → "kitchen_2".
std::string PddlName(std::string_view text);

// One name for each thing, different ones for different things: PDDL does not tell cases apart, and
// what is not a letter becomes one and the same. The first that asks gets the plain name.
class PddlNames {
 public:
  // `thing` is what tells it from others, `plain` the name that it would like to have.
  const std::string& Of(const std::string& thing, std::string_view plain);

 private:
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
};

}  // namespace lares::recipes
