// Grids as the two files that ROS's map_server loads.
#pragma once

#include <string>

#include "mapping/grid/grid.h"

namespace lares::grid {

// Mode trinary, so that occupied is 0, free 254 and unknown 205. `image` is the PGM's name beside
// the YAML: letters, digits, '.', '_' and '-'; throws kInvalid otherwise.
std::string ToMapYaml(const Grid& grid, const std::string& image);

// P5; the first row is that of the largest y.
std::string ToPgm(const Grid& grid);

}  // namespace lares::grid
