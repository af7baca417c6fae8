#include "recipes/match/capabilities.h"

#include <algorithm>

#include "base/error.h"
#include "recipes/naming.h"

namespace lares::recipes {

using prolog::Value;

CapabilityReport Capabilities(prolog::EnginePool& engines, const rdf::View& view,
                              const std::string& robot_iri, const MatchOptions& options) {
  const auto answer = engines.Once(
      view, "capabilities", "robot_capabilities",
      {Value{prolog::Atom{robot_iri}}, Value{prolog::Atom{options.strict ? "true" : "false"}}});
  if (!answer) throw Error(Code::kInternal, "the question for capabilities gave no answer");
  if (const auto* failure = std::get_if<prolog::Compound>(&answer->data)) {
    throw Error(Code::kNotFound, MakeSentence(view, failure->arguments.at(0)));
  }
  CapabilityReport report;
  report.robot = MakeResource(view, robot_iri);
  for (const Value& finding : answer->list()) {
    report.capabilities.push_back(MakeFinding(view, finding));
  }
  std::sort(report.capabilities.begin(), report.capabilities.end(),
            [](const Finding& a, const Finding& b) {
              return a.what.label != b.what.label ? a.what.label < b.what.label
                                                  : a.what.iri < b.what.iri;
            });
  return report;
}

}  // namespace lares::recipes
