// Random repair problems, and their solutions by trying every set of additions.
#pragma once

#include <cstdint>
#include <vector>

#include "recipes/match/repair.h"

namespace lares::testing {

// With coverage, shared things, circles, presence that is in doubt and additions that need more; at
// most 11 additions and 15 things.
recipes::RepairProblem RandomRepairProblem(std::uint32_t seed);

// The indices of the bits of `set` below `count`.
std::vector<std::size_t> Members(std::uint32_t set, std::size_t count);

// By cost, then number of additions, then their indices.
std::vector<recipes::RepairSet> AllRepairs(const recipes::RepairProblem& problem);

}  // namespace lares::testing
