// How far everything is from what is in the way.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/grid/grid.h"

namespace lares::grid {

// What a distance is called that is this long or longer, or where nothing is occupied.
inline constexpr std::uint32_t kFar = UINT32_MAX;

// For each cell, in the order of the grid's cells, the squared distance from its middle to the
// middle of the nearest occupied cell, in cells; exact. Linear in the cells.
// Source: Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, Theory of
// Computing 8 (2012), section 2: first along y, where on cells that are occupied or not the
// transform is two sweeps, then along x by the lower envelope of parabolas.
std::vector<std::uint32_t> SquaredDistances(const Grid& grid);

}  // namespace lares::grid
