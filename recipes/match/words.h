// Words that explanations and repairs are made of.
#pragma once

#include <string>
#include <vector>

#include "recipes/match/match.h"

namespace lares::recipes {

std::string Listed(const std::vector<std::string>& names);  // "A, B and C"
std::string WithArticle(const std::string& name);           // "a camera", "an arm"

// "2 m, 1 m (33 %) too little". `measure` has an actual value.
std::string ShortText(const Measure& measure);

// "a max range of at least 3 m"; several joined by commas and "and".
std::string TextOf(const std::vector<Measure>& measures);

}  // namespace lares::recipes
