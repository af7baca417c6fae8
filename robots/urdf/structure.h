// Whether links and joints are one tree.
#pragma once

#include "robots/urdf/raw.h"
#include "robots/urdf/reading.h"

namespace lares::urdf {

// Adds a finding for each name that is there twice, link that is missing, link with two parents,
// second root, circle, chain beyond limits.max_chain, and reference of a sensor or a mimic to
// nothing.
void CheckStructure(const RawRobot& robot, const Limits& limits, Reading& reading);

}  // namespace lares::urdf
