#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "recipes/plan/diff.h"

namespace lares::recipes {
namespace {

using nlohmann::json;

json ToJson(const DiffSide& side) {
  if (side.value.empty() && side.why.empty()) return nullptr;
  json value{{"value", side.value}};
  if (!side.why.empty()) value["why"] = side.why;
  return value;
}

// Columns are as wide as their code points.
std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string What(const Difference& difference) {
  std::string what(ToString(difference.kind));
  return difference.name.empty() ? what : what + " " + difference.name;
}

std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void WriteSide(std::ostream& out, const std::string& indent, char mark, const DiffSide& side) {
  out << indent << mark << " ";
  if (side.value.empty() && side.why.empty()) {
    out << "—\n";
    return;
  }
  out << OneLine(side.value);
  if (!side.why.empty()) out << (side.value.empty() ? "" : "   ") << "[" << side.why << "]";
  out << "\n";
}

// The name once, then both sides below each other: values are often long.
void WriteDifference(std::ostream& out, const Difference& difference, std::size_t width) {
  const std::string what = What(difference);
  out << "  " << what << std::string(width - Width(what), ' ');
  WriteSide(out, "  ", 'a', difference.a);
  WriteSide(out, std::string(width + 4, ' '), 'b', difference.b);
}

}  // namespace

json ToJson(const PlanDiff& diff) {
  json differences = json::array();
  for (const Difference& each : diff.differences) {
    json value{{"kind", ToString(each.kind)}, {"a", ToJson(each.a)}, {"b", ToJson(each.b)}};
    if (!each.step.empty()) value["step"] = each.step;
    if (!each.name.empty()) value["name"] = each.name;
    differences.push_back(std::move(value));
  }
  return {{"format", "lares-plan-diff"},
          {"format_version", 1},
          {"a", diff.a},
          {"b", diff.b},
          {"equal", diff.differences.empty()},
          {"differences", differences}};
}

std::string ToText(const PlanDiff& diff) {
  std::ostringstream out;
  out << "a: " << diff.a << "\nb: " << diff.b << "\n";
  if (diff.differences.empty()) out << "The plans are equal.\n";
  std::size_t width = 0;
  for (const Difference& each : diff.differences) width = std::max(width, Width(What(each)));
  width = std::min<std::size_t>(width, 32);
  const std::string* step = nullptr;
  for (const Difference& each : diff.differences) {
    if (step == nullptr || *step != each.step) {
      out << "\n" << (each.step.empty() ? "The plan" : "Step " + each.step) << "\n";
      step = &each.step;
    }
    WriteDifference(out, each, std::max(width, Width(What(each))));
  }
  return out.str();
}

}  // namespace lares::recipes
