#include "base/text.h"
#include "recipes/plan/plan.h"

namespace lares::recipes {

std::string ToText(const Fluent& fluent) {
  std::string text = fluent.holds ? fluent.name : "not " + fluent.name;
  if (fluent.argument.empty()) return text;
  const bool is_iri = fluent.argument.find("://") != std::string::npos;
  return text + "(" + std::string(is_iri ? LocalName(fluent.argument) : fluent.argument) + ")";
}

}  // namespace lares::recipes
