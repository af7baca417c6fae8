// Random plans for property tests.
#pragma once

#include <random>

#include "recipes/plan/plan.h"

namespace lares::testing {

// A plan that CheckPlan accepts, of up to `max_states` skill states with random outcomes.
recipes::Plan RandomPlan(std::mt19937& random, int max_states);

}  // namespace lares::testing
