#include "mapping/grid/grid.h"

#include <algorithm>
#include <cmath>

namespace lares::grid {

Counts Count(const Grid& grid) {
  Counts counts;
  for (const Cell cell : grid.cells) {
    if (cell == Cell::kOccupied) ++counts.occupied;
    if (cell == Cell::kFree) ++counts.free;
    if (cell == Cell::kUnknown) ++counts.unknown;
  }
  return counts;
}

std::array<double, 4> BoundsOf_m(const Grid& grid) {
  const double cosine = std::cos(grid.yaw_rad), sine = std::sin(grid.yaw_rad);
  std::array<double, 4> bounds_m{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (const double x_m : {0.0, grid.width * grid.resolution_m}) {
    for (const double y_m : {0.0, grid.height * grid.resolution_m}) {
      const double x_in_map_m = grid.origin_x_m + cosine * x_m - sine * y_m;
      const double y_in_map_m = grid.origin_y_m + sine * x_m + cosine * y_m;
      bounds_m = {std::min(bounds_m[0], x_in_map_m), std::min(bounds_m[1], y_in_map_m),
                  std::max(bounds_m[2], x_in_map_m), std::max(bounds_m[3], y_in_map_m)};
    }
  }
  return bounds_m;
}

}  // namespace lares::grid
