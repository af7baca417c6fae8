// Plans made anew, from where an earlier run stands.
#pragma once

#include <string>
#include <vector>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// Lets `plan` begin at `from`, or, where that is empty, after the states that are `done`, following
// their successes. A done state that the plan still comes by is passed over, unless it lies on a
// loop: then it is to be done again. States that cannot be reached any more go; what the done ones
// created is given. Throws kInvalid for a state that the plan has not, and when the done ones do
// not tell where to go on.
void Resume(Plan& plan, const std::string& from, const std::vector<std::string>& done);

}  // namespace lares::recipes
