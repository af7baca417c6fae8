#include "recipes/plan/reading.h"

#include "base/error.h"

namespace lares::recipes {

Reading ReadRecipe(prolog::EnginePool& engines, const rdf::View& view,
                   const std::string& task_iri) {
  auto record = engines.Keep(view, "readings", "reading", {prolog::Value{prolog::Atom{task_iri}}});
  if (record == nullptr) throw Error(Code::kInternal, "readings:reading gave no answer");
  return {std::move(record)};
}

}  // namespace lares::recipes
