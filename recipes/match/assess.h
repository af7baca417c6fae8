// What of a task's needs one robot meets: the one judgement that reports, repairs and rankings
// show.
#pragma once

#include <cstddef>
#include <vector>

#include "recipes/match/match.h"
#include "recipes/match/repair.h"

namespace lares::recipes {

struct Assessment {
  struct Node {
    std::vector<std::size_t> parts;   // components: the robot's parts that are it
    std::vector<std::size_t> claims;  // capabilities: the most specific claims that are it
    std::vector<std::size_t> offers;  // indices into MatchOptions::offers
    bool is_there = false;
  };
  // A group of bounds, by the part that meets it best.
  struct Group {
    enum class Verdict { kMet, kUnknown, kInsufficient, kAbsent };
    Verdict verdict = Verdict::kAbsent;
    std::size_t part = 0;           // unless kAbsent; of the robot itself without a meaning
    std::vector<Measure> measures;  // one for each bound
    bool is_there = false;
  };
  // What an addition of `problem` stands for.
  struct Added {
    std::size_t node = 0;
    std::vector<std::size_t> groups;  // whose bounds it keeps
  };
  std::vector<Node> nodes;
  std::vector<Group> groups;
  bool feasible = false;
  // Things are the nodes, then the groups.
  RepairProblem problem;
  std::vector<Added> additions;
};

Assessment Assess(const Needs& needs, const RobotProfile& robot, const MatchOptions& options);

// The nodes that downloads stand in for, each once; what a missing part would bring is among them.
std::vector<std::size_t> Downloaded(const Needs& needs, const Assessment& assessment,
                                    const MatchOptions& options);

// Costs of RepairProblem are whole: these many to 1 of additionCost.
inline constexpr double kCostScale = 1000;
inline constexpr double kDownloadCost = 0.1;

}  // namespace lares::recipes
