// Occupancy grids: what is in the way of a robot, seen from above.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapping/environment/map_yaml.h"

namespace lares::grid {

using Cell = environment::Occupancy;

// Cell (x, y) is the square from x to x + 1 and from y to y + 1 cells from the origin, along axes
// that are those of the map frame turned by `yaw_rad`.
struct Grid {
  double resolution_m = 0;  // side of a cell
  double origin_x_m = 0;    // lowest corner of cell (0, 0) in the map frame
  double origin_y_m = 0;
  double yaw_rad = 0;
  std::uint32_t width = 0;   // cells along x
  std::uint32_t height = 0;  // cells along y
  std::vector<Cell> cells;   // row by row from y = 0 upwards, each row from x = 0

  std::size_t IndexOf(std::uint32_t x, std::uint32_t y) const {
    return static_cast<std::size_t>(y) * width + x;
  }
  Cell At(std::uint32_t x, std::uint32_t y) const { return cells[IndexOf(x, y)]; }
};

// The largest grid that anything here makes or reads: 4096 × 4096, or 204.8 m a side at 5 cm.
inline constexpr std::uint64_t kMaxCells = std::uint64_t{1} << 24;

struct Counts {
  std::uint64_t occupied = 0, free = 0, unknown = 0;
};
Counts Count(const Grid& grid);

// The box around the grid in the map frame: min x, min y, max x, max y.
std::array<double, 4> BoundsOf_m(const Grid& grid);

}  // namespace lares::grid
