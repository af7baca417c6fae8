#include "mapping/grid/inflate.h"

#include <cmath>

#include "base/error.h"
#include "mapping/grid/distance.h"

namespace lares::grid {

Grid Inflate(const Grid& grid, double radius_m) {
  if (!std::isfinite(radius_m) || radius_m < 0) {
    throw Error(Code::kInvalid, "a radius to inflate by must be a finite number from 0");
  }
  // 0.3 m are 6 cells of 0.05 m although 0.3 / 0.05 is a little less.
  const double radius_cells = radius_m / grid.resolution_m * (1 + 1e-9);
  const double squared = radius_cells * radius_cells;
  Grid inflated = grid;
  const std::vector<std::uint32_t> distances = SquaredDistances(grid);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] != kFar && distances[i] <= squared) inflated.cells[i] = Cell::kOccupied;
  }
  return inflated;
}

}  // namespace lares::grid
