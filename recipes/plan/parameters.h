// From what the rules found for an argument to a Parameter: the arithmetic of poses is here.
#pragma once

#include "ontology/triples/view.h"
#include "reasoner/prolog/value.h"
#include "recipes/plan/plan.h"

namespace lares::recipes {

// Throws kInvalid naming the matrix when it is no rigid motion of finite numbers.
Parameter ToParameter(const rdf::View& view, const prolog::Value& value);

}  // namespace lares::recipes
