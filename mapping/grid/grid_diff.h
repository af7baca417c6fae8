// What changed between two grids of one place.
#pragma once

#include <cstdint>

#include "mapping/grid/grid.h"

namespace lares::grid {

// Counts of cells of the second grid, by what stands there in the first: at the middle of the cell,
// where the two are not cut the same way.
struct GridDiff {
  bool same_cut = false;  // the same resolution, origin, yaw and size
  std::uint64_t same = 0;
  std::uint64_t became_occupied = 0;  // free before
  std::uint64_t became_free = 0;      // occupied before
  std::uint64_t became_known = 0;     // unknown before
  std::uint64_t became_unknown = 0;
  std::uint64_t beyond_before = 0;  // known cells where the first grid has none
  double changed_area_m2 = 0;       // of all of these but `same`
};

GridDiff DiffGrids(const Grid& before, const Grid& after);

}  // namespace lares::grid
