// Sensors and plugins of a URDF, in the three forms that are in use.
#pragma once

#include "robots/urdf/raw.h"
#include "robots/urdf/reading.h"
#include "robots/urdf/xml_tree.h"

namespace lares::urdf {

// Fills robot.sensors and robot.plugins from <gazebo> (SDF's <sensor type=…> in radians, and the
// older <sensor:camera>, <sensor:ray>, … in degrees) and from URDF's own <sensor>.
void ReadSensors(const Element& root, RawRobot& robot, Reading& reading);

}  // namespace lares::urdf
