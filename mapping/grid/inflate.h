// Grids for a body that is no point.
#pragma once

#include "mapping/grid/grid.h"

namespace lares::grid {

// Every cell becomes occupied whose middle is `radius_m` or less from the middle of an occupied one
// (as nav2's inflation layer measures); unknown ones too. All others stay as they are. With the
// radius of the smallest circle around a robot's centre that holds its footprint, the centre may be
// on any cell that is then free, however the robot is turned. Throws kInvalid for a radius that is
// negative or no finite number.
Grid Inflate(const Grid& grid, double radius_m);

}  // namespace lares::grid
