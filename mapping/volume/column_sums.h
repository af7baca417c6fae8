// For each cell of a grid, a sum over the voxels above it, from boxes of voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lares::volume {

// Voxels from `begin` on, up to `end` without it.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

// A cell is `voxels_per_cell` squared columns. A box is entered at its corners only (a summed-area
// table, Crow 1984, the other way round): adding is constant in time, Finish linear in the cells.
class ColumnSums {
 public:
  // `voxels_per_cell` ≤ kMaxVoxelsPerCell, so that no sum exceeds 32 bits.
  ColumnSums(std::uint32_t width, std::uint32_t height, std::uint32_t voxels_per_cell);

  // A box of voxels, x and y counted from the lowest corner of cell (0, 0) and inside the grid.
  void Add(Span x, Span y, std::uint32_t layers);
  // Once: the voxels above each cell, row by row.
  std::vector<std::uint32_t> Finish() &&;

  static constexpr std::uint32_t kMaxVoxelsPerCell = 255;

 private:
  void AddCells(Span x, Span y, std::uint32_t amount);

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t voxels_per_cell_;
  std::vector<std::uint32_t> changes_;  // one row and column more than the grid, modulo 2³²
};

}  // namespace lares::volume
