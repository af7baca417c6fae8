// Random plans for property tests.
#pragma once

#include <random>

#include "recipes/plan/plan.h"

namespace lares::testing {

// A plan that CheckPlan accepts, of up to `max_states` skill states with random outcomes.
recipes::Plan RandomPlan(std::mt19937& random, int max_states);

// Such a plan with everything else that a plan may hold: retries, limits, fragments, steps side by
// side, claims, settings, a match, and conditions that may or may not be met.
recipes::Plan RandomFullPlan(std::mt19937& random, int max_states);

}  // namespace lares::testing
