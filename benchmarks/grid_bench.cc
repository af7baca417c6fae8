// Grids for robots out of OctoMap trees: the cut, the distances, the files.
#include <cstdlib>

#include "base/file.h"
#include "benchmarks/measure.h"
#include "mapping/grid/distance.h"
#include "mapping/grid/inflate.h"
#include "mapping/grid/map_files.h"
#include "mapping/volume/cut.h"

namespace lares::bench {
namespace {

constexpr double kRadius_m = 0.4;

volume::GridCut Cut(const std::string& bytes) {
  return volume::CutOctomap([&] { return environment::ByteReader::OfBytes(bytes, "octomap"); },
                            {{0.05, 1.38}});
}

// A grid with one occupied cell in a hundred, where they fall.
grid::Grid Scattered(std::uint32_t side) {
  grid::Grid grid;
  grid.resolution_m = 0.05;
  grid.width = grid.height = side;
  grid.cells.assign(std::size_t{side} * side, grid::Cell::kFree);
  std::uint32_t state = 1;
  for (grid::Cell& cell : grid.cells) {
    state = state * 1664525 + 1013904223;
    if (state >> 24 < 3) cell = grid::Cell::kOccupied;
  }
  return grid;
}

void MeasureTree(const std::string& name, const std::string& bytes) {
  const grid::Grid cut = Cut(bytes).grid;
  Row(name + ": cut, inflated and written", "<", 100, "ms", MedianOfFive([&] {
        return 1e3 * SecondsOf([&] { grid::ToPgm(grid::Inflate(Cut(bytes).grid, kRadius_m)); });
      }));
  Note("  … of which the cut", "ms",
       MedianOfFive([&] { return 1e3 * SecondsOf([&] { Cut(bytes); }); }));
  Note("  … cells", "cells", static_cast<double>(cut.cells.size()));
}

void Run() {
  if (const char* data = std::getenv("LARES_DATA")) {
    MeasureTree("geb079.bt, 532 566 nodes",
                ReadFile(std::filesystem::path(data) / "octomap" / "geb079.bt"));
  }
  const grid::Grid grid = Scattered(4096);
  Row("4096 × 4096 cells, the most there may be: inflated", "<", 2, "s",
      MedianOfFive([&] { return SecondsOf([&] { grid::Inflate(grid, kRadius_m); }); }));
}

}  // namespace
}  // namespace lares::bench

int main() {
  try {
    lares::bench::Run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "grid_bench: %s\n", error.what());
    return 1;
  }
}
