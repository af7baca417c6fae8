#include "mapping/volume/column_sums.h"

#include <array>
#include <utility>

namespace lares::volume {
namespace {

// Neighbouring cells that a span covers by equally many voxels each.
struct Piece {
  Span cells;
  std::uint32_t voxels = 0;
};
struct Pieces {
  std::array<Piece, 3> pieces;
  std::size_t count = 0;
};

// The first cell, those that are covered whole, the last.
Pieces Split(Span voxels, std::uint32_t per_cell) {
  Pieces split;
  const auto add = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t each) {
    if (begin < end) split.pieces[split.count++] = {{begin, end}, each};
  };
  const std::uint32_t first_whole = (voxels.begin + per_cell - 1) / per_cell;
  const std::uint32_t end_whole = voxels.end / per_cell;
  if (first_whole > end_whole) {  // inside one cell
    add(end_whole, end_whole + 1, voxels.end - voxels.begin);
    return split;
  }
  const std::uint32_t before = first_whole * per_cell - voxels.begin;
  const std::uint32_t after = voxels.end - end_whole * per_cell;
  if (before > 0) add(first_whole - 1, first_whole, before);
  add(first_whole, end_whole, per_cell);
  if (after > 0) add(end_whole, end_whole + 1, after);
  return split;
}

}  // namespace

ColumnSums::ColumnSums(std::uint32_t width, std::uint32_t height, std::uint32_t voxels_per_cell)
    : width_(width),
      height_(height),
      voxels_per_cell_(voxels_per_cell),
      changes_((std::size_t{width} + 1) * (std::size_t{height} + 1), 0) {}

void ColumnSums::Add(Span x, Span y, std::uint32_t layers) {
  const Pieces along_x = Split(x, voxels_per_cell_);
  const Pieces along_y = Split(y, voxels_per_cell_);
  for (std::size_t i = 0; i < along_x.count; ++i) {
    for (std::size_t j = 0; j < along_y.count; ++j) {
      AddCells(along_x.pieces[i].cells, along_y.pieces[j].cells,
               along_x.pieces[i].voxels * along_y.pieces[j].voxels * layers);
    }
  }
}

void ColumnSums::AddCells(Span x, Span y, std::uint32_t amount) {
  const std::size_t stride = std::size_t{width_} + 1;
  changes_[y.begin * stride + x.begin] += amount;
  changes_[y.begin * stride + x.end] -= amount;
  changes_[y.end * stride + x.begin] -= amount;
  changes_[y.end * stride + x.end] += amount;
}

std::vector<std::uint32_t> ColumnSums::Finish() && {
  const std::size_t stride = std::size_t{width_} + 1;
  std::vector<std::uint32_t> above(width_, 0);  // of the row before
  for (std::uint32_t y = 0; y < height_; ++y) {
    std::uint32_t change = 0;
    for (std::uint32_t x = 0; x < width_; ++x) {
      change += changes_[y * stride + x];
      above[x] += change;
      changes_[std::size_t{y} * width_ + x] = above[x];  // never ahead of what is read next
    }
  }
  changes_.resize(std::size_t{width_} * height_);
  return std::move(changes_);
}

}  // namespace lares::volume
