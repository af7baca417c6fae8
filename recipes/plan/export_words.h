// Words that the writers for people share.
#pragma once

#include <string>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// "up to 3 times, 60 s each"; empty for one attempt without a limit.
std::string AttemptsText(const State& state);

std::string_view ToString(Measure::Verdict verdict);  // "met", "unknown", "insufficient"

}  // namespace lares::recipes
