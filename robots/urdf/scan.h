// The bounded pass over a URDF before any library sees it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/urdf/finding.h"
#include "robots/urdf/limits.h"
#include "robots/urdf/raw.h"

namespace lares::urdf {

struct Scanned {
  RawRobot robot;
  // In order of place. Without errors among them the links and joints are one tree, their names
  // are unique and every number is finite.
  std::vector<Finding> findings;
};

// Throws, as ReadXmlTree does, only where nothing can be made of the text. Meshes are never opened.
Scanned Scan(std::string_view bytes, const std::string& source, const Limits& limits = {});

}  // namespace lares::urdf
