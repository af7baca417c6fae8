#include "mapping/grid/read_grid.h"

#include <algorithm>

#include "base/error.h"
#include "mapping/environment/grid_format.h"

namespace lares::grid {

Grid ReadGrid(const std::function<environment::TarReader()>& open, const std::string& name) {
  Grid grid;
  const auto [map, image] = environment::ReadGridImage(open, name, [&](Cell cell) {
    if (grid.cells.size() == kMaxCells) {
      throw Error(Code::kTooLarge, name + " has more than " + std::to_string(kMaxCells) + " cells");
    }
    grid.cells.push_back(cell);
  });
  grid.resolution_m = map.resolution_m;
  grid.origin_x_m = map.origin[0];
  grid.origin_y_m = map.origin[1];
  grid.yaw_rad = map.origin[2];
  grid.width = image.width;
  grid.height = image.height;
  for (std::size_t low = 0, high = grid.height; low + 1 < high--; ++low) {
    std::swap_ranges(grid.cells.begin() + static_cast<std::ptrdiff_t>(low * grid.width),
                     grid.cells.begin() + static_cast<std::ptrdiff_t>((low + 1) * grid.width),
                     grid.cells.begin() + static_cast<std::ptrdiff_t>(high * grid.width));
  }
  return grid;
}

}  // namespace lares::grid
