// The reader of the match report inside of a plan's JSON.
#pragma once

#include "recipes/match/match.h"
#include "recipes/plan/export_json_node.h"

namespace lares::recipes {

// A match report as ToJson writes it. Throws kInvalid naming the place. What reports of older plans
// do not have (requirements, downloads, repairs) may be missing.
MatchReport ReadMatch(const JsonNode& node);

}  // namespace lares::recipes
