#include "recipes/match/capabilities.h"

#include <algorithm>
#include <utility>

#include "recipes/match/assess.h"
#include "recipes/match/explain.h"

namespace lares::recipes {

CapabilityReport Capabilities(prolog::EnginePool& engines, const rdf::View& view,
                              const std::string& robot_iri, const MatchOptions& options) {
  const RobotProfile robot = DescribeRobot(engines, view, robot_iri);
  const Needs needs = FindCapabilityNeeds(engines, view, robot_iri);
  MatchReport report;
  Explain(needs, robot, options, Assess(needs, robot, options), report);
  std::sort(report.capabilities.begin(), report.capabilities.end(),
            [](const Finding& a, const Finding& b) {
              return a.what.label != b.what.label ? a.what.label < b.what.label
                                                  : a.what.iri < b.what.iri;
            });
  return {robot.robot, std::move(report.capabilities)};
}

}  // namespace lares::recipes
