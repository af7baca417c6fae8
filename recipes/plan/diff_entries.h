// The things of a plan as lists that can be compared.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"
#include "recipes/plan/diff.h"

namespace lares::recipes {

// What something is told apart by, and how it reads.
struct Entry {
  std::string key;    // equal in both plans: the same thing
  std::string name;   // for people
  std::string exact;  // everything there is to it; equal: no difference
  DiffSide side;
  std::string fuller;  // said instead of side.why where that leaves both sides reading the same
};
using Entries = std::vector<Entry>;

Entries TextEntries(const std::vector<std::string>& texts);
Entries FluentEntries(const std::vector<Fluent>& fluents);
Entries EffectEntries(const std::vector<Effect>& effects);
Entries SettingEntries(const Plan& plan);
Entries NeedEntries(const Plan& plan);
Entries RequirementEntries(const Plan& plan);
Entries DownloadEntries(const Plan& plan);
Entries FindingEntries(const Plan& plan);
Entries InputEntries(const State& state);
Entries OutputEntries(const State& state);
Entries ClaimEntries(const State& state);

// For people: "cup <Cup>", or one of them where they are the same.
std::string NameOf(const Resource& resource);
std::string NumberText(double number);

template <typename Items, typename ItemText>
std::string Listed(const Items& items, const ItemText& text) {
  std::vector<std::string> parts;
  for (const auto& item : items) parts.push_back(text(item));
  return Join(parts, ", ");
}

}  // namespace lares::recipes
