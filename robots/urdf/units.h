// Figures that look like another unit than URDF's metres, kilograms, seconds and radians.
#pragma once

#include "robots/urdf/raw.h"
#include "robots/urdf/reading.h"

namespace lares::urdf {

// Adds a warning for each suspicion; what is meant is for a person to say.
void SuspectUnits(const RawRobot& robot, Reading& reading);

}  // namespace lares::urdf
