// The part of a behaviour tree's document that says what its skills' ports are.
#pragma once

#include <iosfwd>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// <TreeNodesModel>: every skill once, with its ports, their types and what they are for.
void WriteSkillModels(std::ostream& out, const Plan& plan);

}  // namespace lares::recipes
