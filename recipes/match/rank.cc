#include "recipes/match/rank.h"

#include <limits>
#include <tuple>

#include "recipes/match/assess.h"
#include "recipes/match/repairs.h"

namespace lares::recipes {

RankedRobot Rank(const Needs& needs, const RobotProfile& robot, const MatchOptions& options) {
  const Assessment assessment = Assess(needs, robot, options);
  RankedRobot ranked;
  ranked.robot = robot.robot;
  ranked.feasible = assessment.feasible;
  for (const std::size_t node : Downloaded(needs, assessment, options)) {
    ranked.downloads.push_back(needs.nodes[node].what);
  }
  const double download_cost = kDownloadCost * static_cast<double>(ranked.downloads.size());
  if (assessment.feasible) {
    ranked.cost = download_cost;
    return ranked;
  }
  RepairOptions repair_options;
  repair_options.sets = 1;
  NamedRepairs repairs = FindRepairs(needs, assessment, repair_options);
  ranked.repair_is_smallest = repairs.is_smallest;
  if (repairs.repairs.empty()) return ranked;
  ranked.repair = std::move(repairs.repairs.front());
  ranked.cost = ranked.repair.cost + download_cost;
  return ranked;
}

bool RanksBefore(const RankedRobot& a, const RankedRobot& b) {
  const double none = std::numeric_limits<double>::infinity();
  return std::forward_as_tuple(b.feasible, a.cost.value_or(none), a.robot.iri) <
         std::forward_as_tuple(a.feasible, b.cost.value_or(none), b.robot.iri);
}

}  // namespace lares::recipes
