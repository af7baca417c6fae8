// An assessment in words.
#pragma once

#include <string>
#include <vector>

#include "recipes/match/assess.h"

namespace lares::recipes {

// Fills everything of `report` but its repairs.
void Explain(const Needs& needs, const RobotProfile& robot, const MatchOptions& options,
             const Assessment& assessment, MatchReport& report);

// "a max range of at least 3 m"; several joined by commas and "and".
std::string TextOf(const std::vector<Measure>& measures);

}  // namespace lares::recipes
