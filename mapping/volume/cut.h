// Occupancy grids out of OctoMap trees: what is in the way of a body of some height.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "mapping/environment/byte_reader.h"
#include "mapping/grid/grid.h"

namespace lares::volume {

struct HeightRange {
  double low_m = 0;
  double high_m = 0;
};

struct CutOptions {
  // Above the floor: from what the robot rolls over to its own height.
  HeightRange heights{0.05, 1.5};
  double floor_z_m = 0;  // of the floor in the map frame
  // Where a voxel must be known to be free for its cell to be; all of `heights` without it.
  std::optional<HeightRange> free_heights;
  double resolution_m = 0;  // of the grid, made a whole number of voxels; 0: the tree's
  std::uint64_t max_cells = grid::kMaxCells;

  // Throws kInvalid naming the field.
  void Check() const;
};

struct GridCut {
  grid::Grid grid;
  double voxel_m = 0;
  // The whole layers of voxels that were looked at, in the map frame.
  HeightRange layers;
  HeightRange free_layers;
};

// A horizontal grid along the axes of the map frame, as large as what the tree knows at these
// heights. Voxels come in layers; those looked at are from the first that begins at heights.low or
// above it, to the last that begins below heights.high. (So the layer that the floor lies in is
// never looked at; what is lower than the first layer cannot be told from it.) A cell is
//   occupied: when any voxel above it in these layers is;
//   free:     else, when every voxel above it in the free layers is known to be free;
//   unknown:  else.
// `open` begins the file (.bt or .ot) anew each time: it is read twice, leaf by leaf, so that
// memory is that of the grid, whatever the tree's size, and a leaf costs the same whatever its own.
// Throws as environment::ReadOctomap; kInvalid when no layer lies between the heights or nothing is
// known there; kTooLarge for more than max_cells.
GridCut CutOctomap(const std::function<environment::ByteReader()>& open, const CutOptions& options);

}  // namespace lares::volume
