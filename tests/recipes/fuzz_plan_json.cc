#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.h"
#include "recipes/plan/diff.h"
#include "recipes/plan/export.h"

// Any bytes: a plan that is written as it was read, or an Error; and whatever plan it is, it can be
// compared and written in every format, or the format is refused with an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lares;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  if (json.is_discarded()) return 0;
  try {
    const recipes::Plan plan = recipes::PlanFromJson(json);
    const recipes::Plan again = recipes::PlanFromJson(recipes::ToJson(plan));
    if (recipes::ToJson(again) != recipes::ToJson(plan)) std::abort();
    if (!recipes::DiffPlans(plan, again).differences.empty()) std::abort();
    recipes::ToText(plan);
    recipes::ToDot(plan);
    recipes::ToPddlDomain(plan);
    recipes::ToPddlProblem(plan);
    recipes::ToBehaviorTreeXml(plan);
  } catch (const Error&) {
  }
  return 0;
}
