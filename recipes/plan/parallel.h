// Steps that a recipe leaves unordered, side by side.
#pragma once

#include <functional>
#include <vector>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// How many parts of a kind (an IRI) the robot has.
using CountParts = std::function<int(const std::string& kind)>;

// Puts neighbours of `plan` that are in one of `unordered` (ids of states) into parallel states, as
// long as they only succeed or fail, do not use what another creates, claim no more parts than
// there are, use no part in common, and no effect of one is about what another needs or changes.
void RunSideBySide(Plan& plan, const std::vector<std::vector<std::string>>& unordered,
                   const CountParts& count_parts);

}  // namespace lares::recipes
