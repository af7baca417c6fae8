// What to add to a robot, from the problem that its assessment left.
#pragma once

#include "recipes/match/assess.h"

namespace lares::recipes {

struct NamedRepairs {
  std::vector<Repair> repairs;  // cheapest first; empty when feasible, or when nothing helps
  bool is_smallest = true;      // false: the search for a cheaper one was given up
};
NamedRepairs FindRepairs(const Needs& needs, const Assessment& assessment,
                         const RepairOptions& options = {});

}  // namespace lares::recipes
