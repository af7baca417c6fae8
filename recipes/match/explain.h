// An assessment in words.
#pragma once

#include "recipes/match/assess.h"

namespace lares::recipes {

// Fills everything of `report` but its repairs.
void Explain(const Needs& needs, const RobotProfile& robot, const MatchOptions& options,
             const Assessment& assessment, MatchReport& report);

}  // namespace lares::recipes
