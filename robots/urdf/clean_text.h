// A scanned robot as URDF again: the only text that the parsing library is given.
#pragma once

#include <string>

#include "robots/urdf/raw.h"

namespace lares::urdf {

// Names become "l0", "l1", … and "j0", … by index, meshes a placeholder, numbers are written in
// full. Links and joints only.
std::string CleanText(const RawRobot& robot);

}  // namespace lares::urdf
