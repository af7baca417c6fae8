#include "mapping/volume/cut.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mapping/environment/facts.h"
#include "mapping/environment/octomap_format.h"
#include "mapping/volume/column_sums.h"

namespace lares::volume {
namespace {

using environment::kOctomapOrigin;
using environment::kOctomapSide;
using environment::OctomapHeader;
using environment::OctomapLeaf;

std::string ToText(const HeightRange& range) {
  return environment::ToText(range.low_m) + " and " + environment::ToText(range.high_m) + " m";
}

// The first layer that begins at `height_m` or above it. A millionth of a voxel is forgiven, for
// 0.15 / 0.05 is not 3.
std::uint32_t LayerFrom(double height_m, double voxel_m) {
  const double layer = std::ceil(height_m / voxel_m - 1e-6) + kOctomapOrigin;
  return static_cast<std::uint32_t>(std::clamp(layer, 0.0, static_cast<double>(kOctomapSide)));
}

Span LayersOf(const HeightRange& heights, double floor_z_m, double voxel_m) {
  return {LayerFrom(floor_z_m + heights.low_m, voxel_m),
          LayerFrom(floor_z_m + heights.high_m, voxel_m)};
}

double BeginOf_m(std::uint32_t voxel, double voxel_m) {
  return (static_cast<double>(voxel) - kOctomapOrigin) * voxel_m;
}

HeightRange ToHeights(const Span& layers, double voxel_m) {
  return {BeginOf_m(layers.begin, voxel_m), BeginOf_m(layers.end, voxel_m)};
}

Span Common(const Span& a, const Span& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

std::uint32_t Length(const Span& span) { return span.end > span.begin ? span.end - span.begin : 0; }

Span Along(std::uint32_t begin, const OctomapLeaf& leaf) { return {begin, begin + leaf.edge}; }

// Where the cut is made, in voxels.
struct Frame {
  double voxel_m = 0;
  Span layers;
  Span free_layers;
  Span x, y;  // what is known there
};

Frame FindFrame(const std::function<environment::ByteReader()>& open, const CutOptions& options) {
  Frame frame;
  frame.x = frame.y = {kOctomapSide, 0};
  const auto set_layers = [&](double voxel_m) {
    frame.voxel_m = voxel_m;
    frame.layers = LayersOf(options.heights, options.floor_z_m, voxel_m);
    frame.free_layers = options.free_heights
                            ? LayersOf(*options.free_heights, options.floor_z_m, voxel_m)
                            : frame.layers;
  };
  const auto extend = [](Span& span, const Span& by) {
    span = {std::min(span.begin, by.begin), std::max(span.end, by.end)};
  };
  environment::ByteReader reader = open();
  const OctomapHeader header =
      ReadOctomap(reader, [&](const OctomapHeader& of, const OctomapLeaf& leaf) {
        if (frame.voxel_m == 0) set_layers(of.resolution_m);
        if (Length(Common(Along(leaf.z, leaf), frame.layers)) == 0) return;
        extend(frame.x, Along(leaf.x, leaf));
        extend(frame.y, Along(leaf.y, leaf));
      });
  if (frame.voxel_m == 0) set_layers(header.resolution_m);
  const auto fail = [&](const std::string& message) {
    throw Error(Code::kInvalid, reader.name() + ": " + message);
  };
  if (Length(frame.layers) == 0 || Length(frame.free_layers) == 0) {
    fail("voxels of " + environment::ToText(frame.voxel_m) + " m are too large for a cut between " +
         ToText(options.heights) + ": no layer of them begins there");
  }
  if (Length(frame.x) == 0) fail("nothing is known between " + ToText(options.heights));
  return frame;
}

std::uint32_t VoxelsPerCell(const CutOptions& options, double voxel_m) {
  if (options.resolution_m == 0) return 1;
  const double voxels = std::ceil(options.resolution_m / voxel_m - 1e-6);
  if (voxels > ColumnSums::kMaxVoxelsPerCell) {
    throw Error(Code::kInvalid, "resolution_m is more than " +
                                    std::to_string(ColumnSums::kMaxVoxelsPerCell) + " voxels of " +
                                    environment::ToText(voxel_m) + " m");
  }
  return std::max(1U, static_cast<std::uint32_t>(voxels));
}

// Cells begin at whole multiples of their side from the origin of the map frame.
std::int64_t CellOf(std::uint32_t voxel, std::uint32_t per_cell) {
  const std::int64_t from_origin = std::int64_t{voxel} - kOctomapOrigin;
  const std::int64_t cell = from_origin / per_cell;
  return from_origin < cell * per_cell ? cell - 1 : cell;
}

// The grid of a frame with every cell unknown yet, and where it begins in voxels.
struct Canvas {
  grid::Grid grid;
  std::int64_t begin_x = 0, begin_y = 0;  // may lie a little outside the tree
  std::uint32_t per_cell = 1;
};

Canvas MakeCanvas(const Frame& frame, const CutOptions& options, const std::string& name) {
  Canvas canvas;
  canvas.per_cell = VoxelsPerCell(options, frame.voxel_m);
  const std::int64_t low_x = CellOf(frame.x.begin, canvas.per_cell);
  const std::int64_t low_y = CellOf(frame.y.begin, canvas.per_cell);
  const auto width =
      static_cast<std::uint64_t>(CellOf(frame.x.end - 1, canvas.per_cell) - low_x + 1);
  const auto height =
      static_cast<std::uint64_t>(CellOf(frame.y.end - 1, canvas.per_cell) - low_y + 1);
  if (width * height > options.max_cells) {
    throw Error(Code::kTooLarge, name + ": the cut would have " + std::to_string(width) + " × " +
                                     std::to_string(height) + " cells, more than " +
                                     std::to_string(options.max_cells))
        .WithHint("ask for a coarser resolution");
  }
  canvas.begin_x = low_x * canvas.per_cell + kOctomapOrigin;
  canvas.begin_y = low_y * canvas.per_cell + kOctomapOrigin;
  canvas.grid.resolution_m = frame.voxel_m * canvas.per_cell;
  canvas.grid.origin_x_m = static_cast<double>(low_x) * canvas.grid.resolution_m;
  canvas.grid.origin_y_m = static_cast<double>(low_y) * canvas.grid.resolution_m;
  canvas.grid.width = static_cast<std::uint32_t>(width);
  canvas.grid.height = static_cast<std::uint32_t>(height);
  return canvas;
}

Span From(const Span& voxels, std::int64_t begin) {
  return {static_cast<std::uint32_t>(voxels.begin - begin),
          static_cast<std::uint32_t>(voxels.end - begin)};
}

// Second reading: the voxels of each kind above each cell decide.
void Fill(const std::function<environment::ByteReader()>& open, const Frame& frame,
          Canvas& canvas) {
  grid::Grid& grid = canvas.grid;
  ColumnSums occupied(grid.width, grid.height, canvas.per_cell);
  ColumnSums free(grid.width, grid.height, canvas.per_cell);
  environment::ByteReader reader = open();
  ReadOctomap(reader, [&](const OctomapHeader&, const OctomapLeaf& leaf) {
    const Span& counted = leaf.is_occupied ? frame.layers : frame.free_layers;
    const std::uint32_t layers = Length(Common(Along(leaf.z, leaf), counted));
    if (layers == 0) return;
    (leaf.is_occupied ? occupied : free)
        .Add(From(Along(leaf.x, leaf), canvas.begin_x), From(Along(leaf.y, leaf), canvas.begin_y),
             layers);
  });
  const std::vector<std::uint32_t> occupied_voxels = std::move(occupied).Finish();
  const std::vector<std::uint32_t> free_voxels = std::move(free).Finish();
  const std::uint32_t whole = canvas.per_cell * canvas.per_cell * Length(frame.free_layers);
  grid.cells.resize(occupied_voxels.size(), grid::Cell::kUnknown);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (occupied_voxels[i] > 0) {
      grid.cells[i] = grid::Cell::kOccupied;
    } else if (free_voxels[i] == whole) {
      grid.cells[i] = grid::Cell::kFree;
    }
  }
}

void CheckRange(const HeightRange& range, const std::string& field) {
  if (!std::isfinite(range.low_m) || !std::isfinite(range.high_m) || range.low_m >= range.high_m) {
    throw Error(Code::kInvalid, field + " must be two finite numbers, the lower first");
  }
}

}  // namespace

void CutOptions::Check() const {
  CheckRange(heights, "heights");
  if (free_heights) {
    CheckRange(*free_heights, "free_heights");
    if (free_heights->low_m < heights.low_m || free_heights->high_m > heights.high_m) {
      throw Error(Code::kInvalid, "free_heights must lie within heights");
    }
  }
  if (!std::isfinite(floor_z_m)) throw Error(Code::kInvalid, "floor_z_m must be a finite number");
  if (!std::isfinite(resolution_m) || resolution_m < 0) {
    throw Error(Code::kInvalid, "resolution_m must be a finite number from 0");
  }
}

GridCut CutOctomap(const std::function<environment::ByteReader()>& open,
                   const CutOptions& options) {
  options.Check();
  const Frame frame = FindFrame(open, options);
  Canvas canvas = MakeCanvas(frame, options, open().name());
  Fill(open, frame, canvas);
  return {std::move(canvas.grid), frame.voxel_m, ToHeights(frame.layers, frame.voxel_m),
          ToHeights(frame.free_layers, frame.voxel_m)};
}

}  // namespace lares::volume
