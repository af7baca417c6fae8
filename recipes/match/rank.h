// Which robots can do a task, and which with the smallest change.
#pragma once

#include <optional>
#include <vector>

#include "recipes/match/match.h"

namespace lares::recipes {

struct RankedRobot {
  Resource robot;
  bool feasible = false;
  // Of the cheapest repair and the downloads; nothing when no addition makes the robot able.
  std::optional<double> cost;
  Repair repair;                    // empty when feasible
  bool repair_is_smallest = true;   // false: the search for a cheaper one was given up
  std::vector<Resource> downloads;  // what they stand in for
};

RankedRobot Rank(const Needs& needs, const RobotProfile& robot, const MatchOptions& options = {});

// Able ones first, then by cost, then by IRI.
bool RanksBefore(const RankedRobot& a, const RankedRobot& b);

}  // namespace lares::recipes
