// The kinematic tree as a picture.
#pragma once

#include <string>

#include "robots/urdf/body.h"
#include "robots/urdf/model.h"

namespace lares::urdf {

// One row for each link, from the root down, indented by its depth: a box for the link, an edge
// with the joint's kind, the joint's name behind the box, and what the link is to the robot (base,
// sensor, arm, gripper) as marks. Stands alone: no
// scripts, nothing from elsewhere.
std::string ToSvg(const Model& model, const Body& body);

// The same for Graphviz.
std::string ToDot(const Model& model, const Body& body);

}  // namespace lares::urdf
