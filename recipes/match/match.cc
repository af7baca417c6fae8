#include "recipes/match/match.h"

#include <algorithm>

#include "recipes/match/assess.h"
#include "recipes/match/explain.h"
#include "recipes/match/repairs.h"

namespace lares::recipes {

namespace {

bool ByLabel(const Finding& a, const Finding& b) {
  return a.what.label != b.what.label ? a.what.label < b.what.label : a.what.iri < b.what.iri;
}

}  // namespace

std::string_view ToString(Availability availability) {
  switch (availability) {
    case Availability::kAvailable:
      return "available";
    case Availability::kOnMakersWord:
      return "on-makers-word";
    case Availability::kDownloadable:
      return "downloadable";
    case Availability::kDerivable:
      return "derivable";
    case Availability::kInsufficient:
      return "insufficient";
    case Availability::kMissing:
      return "missing";
  }
  return "missing";
}

MatchReport Match(const Needs& needs, const RobotProfile& robot, const MatchOptions& options) {
  const Assessment assessment = Assess(needs, robot, options);
  MatchReport report;
  report.task = needs.task;
  report.robot = robot.robot;
  report.feasible = assessment.feasible;
  Explain(needs, robot, options, assessment, report);
  std::sort(report.capabilities.begin(), report.capabilities.end(), ByLabel);
  NamedRepairs repairs = FindRepairs(needs, assessment);
  report.repair_is_smallest = repairs.is_smallest;
  report.repairs = std::move(repairs.repairs);
  if (!report.repairs.empty()) {
    for (const RepairItem& item : report.repairs.front().add) {
      report.smallest_repair.push_back(item.what);
    }
  }
  return report;
}

MatchReport Match(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri,
                  const std::string& robot_iri, const MatchOptions& options) {
  const Needs needs = FindNeeds(engines, view, task_iri, robot_iri);
  return Match(needs, DescribeRobot(engines, view, robot_iri), options);
}

}  // namespace lares::recipes
