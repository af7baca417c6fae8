// Whether links and joints are one tree.
#pragma once

#include <cstddef>

#include "robots/urdf/raw.h"
#include "robots/urdf/reading.h"

namespace lares::urdf {

inline constexpr std::size_t kMostSuggested = 5;  // names for which a document learns of alike ones

// Adds a finding for each name that is there twice, link that is missing, link with two parents,
// second root, circle, chain beyond limits.max_chain, and reference of a sensor or a mimic to
// nothing; what a missing name may have stood for is said of the first kMostSuggested.
void CheckStructure(const RawRobot& robot, const Limits& limits, Reading& reading);

}  // namespace lares::urdf
