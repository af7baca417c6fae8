// Cuts through OctoMap trees against OctoMap itself, asked voxel by voxel.
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "mapping/environment/octomap_format.h"
#include "mapping/grid/map_files.h"
#include "mapping/volume/column_sums.h"
#include "mapping/volume/cut.h"
#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::volume {
namespace {

using grid::Cell;

constexpr int kOrigin = environment::kOctomapOrigin;

// Voxels by whole numbers from the origin of the map frame.
struct Box {
  int x0, y0, z0, x1, y1, z1;
};

class Tree {
 public:
  explicit Tree(double voxel_m) : tree_(voxel_m) {}

  Tree& Set(const Box& box, bool is_occupied) {
    for (int x = box.x0; x < box.x1; ++x) {
      for (int y = box.y0; y < box.y1; ++y) {
        for (int z = box.z0; z < box.z1; ++z) {
          tree_.setNodeValue(Key(x, y, z), is_occupied ? 1.0F : -1.0F, true);
        }
      }
    }
    return *this;
  }
  Tree& Finish() {
    tree_.updateInnerOccupancy();
    tree_.prune();
    return *this;
  }
  Cell At(int x, int y, int z) const {
    const octomap::OcTreeNode* node = tree_.search(Key(x, y, z));
    if (node == nullptr) return Cell::kUnknown;
    return tree_.isNodeOccupied(node) ? Cell::kOccupied : Cell::kFree;
  }
  std::string Bytes(bool is_binary) {
    std::ostringstream bytes;
    if (is_binary) {
      tree_.writeBinaryConst(bytes);
    } else {
      tree_.write(bytes);
    }
    return bytes.str();
  }
  std::size_t leaves() const { return tree_.getNumLeafNodes(); }

 private:
  static octomap::OcTreeKey Key(int x, int y, int z) {
    return {static_cast<octomap::key_type>(x + kOrigin),
            static_cast<octomap::key_type>(y + kOrigin),
            static_cast<octomap::key_type>(z + kOrigin)};
  }
  octomap::OcTree tree_;
};

GridCut Cut(const std::string& bytes, const CutOptions& options) {
  return CutOctomap([&] { return environment::ByteReader::OfBytes(bytes, "map.bt"); }, options);
}

Code CodeOf(const std::string& bytes, const CutOptions& options) {
  try {
    Cut(bytes, options);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()), "");
    return error.code();
  }
  return Code::kInternal;
}

// Whole layers and whole voxels; the definition of CutOctomap, written the slow way.
Cell CellByForce(const Tree& tree, int cell_x, int cell_y, int per_cell, const Box& layers,
                 const Box& free_layers) {
  bool is_free = true;
  for (int x = cell_x * per_cell; x < (cell_x + 1) * per_cell; ++x) {
    for (int y = cell_y * per_cell; y < (cell_y + 1) * per_cell; ++y) {
      for (int z = layers.z0; z < layers.z1; ++z) {
        const Cell voxel = tree.At(x, y, z);
        if (voxel == Cell::kOccupied) return Cell::kOccupied;
        const bool must_be_free = z >= free_layers.z0 && z < free_layers.z1;
        if (must_be_free && voxel == Cell::kUnknown) is_free = false;
      }
    }
  }
  return is_free ? Cell::kFree : Cell::kUnknown;
}

int CellIndex(double corner_m, double side_m) {
  return static_cast<int>(std::lround(corner_m / side_m));
}

TEST(CutTest, IsThatOfOctomapAskedForEachVoxelOnRandomTrees) {
  std::mt19937 random(7);
  const auto from = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  for (int run = 0; run < 40; ++run) {
    const double voxel_m = run % 2 == 0 ? 0.05 : 0.08;
    Tree tree(voxel_m);
    for (int box = 0; box < 12; ++box) {
      const int x = from(-30, 20), y = from(-30, 20), z = from(-12, 12);
      const bool is_occupied = box % 3 == 2;
      const int most = is_occupied ? 5 : 24;
      tree.Set({x, y, z, x + from(1, most), y + from(1, most), z + from(1, most)}, is_occupied);
    }
    tree.Set({-16, -16, -16, 16, 16, 0}, run % 4 == 0);  // one large leaf for each eighth
    tree.Finish();
    const int low = from(-8, 4), high = low + from(1, 20);
    const int free_low = from(low, high - 1), free_high = from(free_low + 1, high);
    const int per_cell = run % 5 == 0 ? from(2, 9) : 1;
    CutOptions options;
    options.floor_z_m = -0.3;
    options.heights = {low * voxel_m + 0.3, high * voxel_m + 0.3};
    if (run % 3 == 0) {
      options.free_heights = {free_low * voxel_m + 0.3, free_high * voxel_m + 0.3};
    }
    options.resolution_m = per_cell * voxel_m;
    const GridCut cut = Cut(tree.Bytes(run % 2 == 0), options);
    ASSERT_NEAR(cut.grid.resolution_m, per_cell * voxel_m, 1e-12);
    ASSERT_NEAR(cut.layers.low_m, low * voxel_m, 1e-9);
    ASSERT_NEAR(cut.layers.high_m, high * voxel_m, 1e-9);
    const Box layers{0, 0, low, 0, 0, high};
    const Box free_layers = options.free_heights ? Box{0, 0, free_low, 0, 0, free_high} : layers;
    const int first_x = CellIndex(cut.grid.origin_x_m, cut.grid.resolution_m);
    const int first_y = CellIndex(cut.grid.origin_y_m, cut.grid.resolution_m);
    const int end_x = first_x + static_cast<int>(cut.grid.width);
    const int end_y = first_y + static_cast<int>(cut.grid.height);
    // Beyond the grid's edges too: nothing is known there.
    for (int x = first_x - 2; x < end_x + 2; ++x) {
      for (int y = first_y - 2; y < end_y + 2; ++y) {
        const bool is_inside = x >= first_x && x < end_x && y >= first_y && y < end_y;
        const Cell cell = is_inside ? cut.grid.At(static_cast<std::uint32_t>(x - first_x),
                                                  static_cast<std::uint32_t>(y - first_y))
                                    : Cell::kUnknown;
        ASSERT_EQ(cell, CellByForce(tree, x, y, per_cell, layers, free_layers))
            << "run " << run << ", cell " << x << " " << y;
      }
    }
  }
}

TEST(CutTest, AxesAreThoseOfTheMap) {
  // One obstacle far along x, one far along −y: a swapped or turned axis puts it elsewhere.
  Tree tree(0.5);
  tree.Set({-4, -8, 0, 10, 3, 4}, false);
  tree.Set({9, 2, 1, 10, 3, 2}, true).Set({-4, -8, 1, -3, -7, 2}, true).Finish();
  const GridCut cut = Cut(tree.Bytes(true), {});
  EXPECT_EQ(cut.grid.width, 14U);
  EXPECT_EQ(cut.grid.height, 11U);
  EXPECT_DOUBLE_EQ(cut.grid.origin_x_m, -2);
  EXPECT_DOUBLE_EQ(cut.grid.origin_y_m, -4);
  EXPECT_EQ(cut.grid.At(13, 10), Cell::kOccupied);  // x = 4.5 m, y = 1 m
  EXPECT_EQ(cut.grid.At(0, 0), Cell::kOccupied);    // x = −2 m, y = −4 m
  EXPECT_EQ(grid::Count(cut.grid).occupied, 2U);
  EXPECT_EQ(grid::Count(cut.grid).free, 14U * 11 - 2);
  // In the image the first row is the largest y, so (13, 10) is the last pixel of the first row.
  const std::string pgm = grid::ToPgm(cut.grid);
  const std::size_t begin = pgm.size() - std::size_t{14} * 11;
  EXPECT_EQ(pgm[begin + 13], '\0');
  EXPECT_EQ(pgm[begin + 14 * 10], '\0');
}

TEST(CutTest, LooksAtLayersFromTheFirstThatBeginsAboveTheClearance) {
  const auto cell_with_obstacle_in = [](int layer) {
    Tree tree(0.1);
    tree.Set({0, 0, -2, 1, 1, 10}, false).Set({0, 0, layer, 1, 1, layer + 1}, true).Finish();
    CutOptions options;
    options.heights = {0.05, 0.5};
    return Cut(tree.Bytes(true), options).grid.cells.at(0);
  };
  EXPECT_EQ(cell_with_obstacle_in(-1), Cell::kFree);
  EXPECT_EQ(cell_with_obstacle_in(0), Cell::kFree);  // the floor's own layer, 0–0.1 m
  EXPECT_EQ(cell_with_obstacle_in(1), Cell::kOccupied);
  EXPECT_EQ(cell_with_obstacle_in(4), Cell::kOccupied);
  EXPECT_EQ(cell_with_obstacle_in(5), Cell::kFree);  // begins at 0.5 m, where the body ends
}

TEST(CutTest, OneUnknownVoxelAtBodyHeightMakesACellUnknown) {
  Tree tree(0.1);
  tree.Set({0, 0, 0, 2, 1, 9}, false).Set({0, 0, 9, 1, 1, 10}, false).Finish();
  CutOptions options;
  options.heights = {0, 1};
  const GridCut cut = Cut(tree.Bytes(false), options);
  EXPECT_EQ(cut.grid.At(0, 0), Cell::kFree);
  EXPECT_EQ(cut.grid.At(1, 0), Cell::kUnknown);
  options.free_heights = {0.2, 0.5};
  EXPECT_EQ(Cut(tree.Bytes(false), options).grid.At(1, 0), Cell::kFree);
}

TEST(CutTest, AFloorThatIsNotAtZeroMovesTheCut) {
  Tree tree(0.1);
  tree.Set({0, 0, 0, 1, 1, 30}, false).Set({0, 0, 12, 1, 1, 13}, true).Finish();
  CutOptions options;
  options.heights = {0.1, 0.5};
  EXPECT_EQ(Cut(tree.Bytes(true), options).grid.cells[0], Cell::kFree);
  options.floor_z_m = 1;
  EXPECT_EQ(Cut(tree.Bytes(true), options).grid.cells[0], Cell::kOccupied);
}

TEST(CutTest, VoxelTooLargeForTheBodyIsRefused) {
  const std::string bytes = environment::testing::OneVoxelBt("2");
  CutOptions options;
  options.heights = {0.05, 1.4};
  EXPECT_EQ(CodeOf(bytes, options), Code::kInvalid);
}

TEST(CutTest, NothingKnownAtTheseHeightsIsRefused) {
  CutOptions options;
  options.heights = {5, 6};
  EXPECT_EQ(CodeOf(environment::testing::OneVoxelBt(), options), Code::kInvalid);
}

TEST(CutTest, ATreeOfEmptyWorldIsRefusedNotExpanded) {
  // Two leaves that fill an eighth of 6.5 km each: 65 536 × 65 536 cells.
  CutOptions options;
  EXPECT_EQ(CodeOf(environment::testing::TwoLeavesOt(), options), Code::kTooLarge);
  // A coarser grid of it is small, and made in no time.
  options.resolution_m = 0.1 * ColumnSums::kMaxVoxelsPerCell;
  const GridCut cut = Cut(environment::testing::TwoLeavesOt(), options);
  EXPECT_EQ(cut.grid.width, 129U);  // child 7 alone is above the floor: 32 768 voxels
  options.resolution_m += 0.1;
  EXPECT_EQ(CodeOf(environment::testing::TwoLeavesOt(), options), Code::kInvalid);
}

TEST(CutTest, OptionsThatAreNoneAreRefusedByName) {
  const std::string bytes = environment::testing::OneVoxelBt();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const HeightRange& range : {HeightRange{1, 1}, HeightRange{2, 1}, HeightRange{nan, 1},
                                   HeightRange{0, std::numeric_limits<double>::infinity()}}) {
    CutOptions options;
    options.heights = range;
    EXPECT_EQ(CodeOf(bytes, options), Code::kInvalid);
  }
  CutOptions options;
  options.free_heights = HeightRange{0, 1};
  EXPECT_EQ(CodeOf(bytes, options), Code::kInvalid);
  options = {};
  options.resolution_m = -1;
  EXPECT_EQ(CodeOf(bytes, options), Code::kInvalid);
  options = {};
  options.floor_z_m = nan;
  EXPECT_EQ(CodeOf(bytes, options), Code::kInvalid);
}

TEST(CutTest, ADamagedTreeIsRefusedAsTheLayerCheckDoes) {
  std::string bytes = environment::testing::OneVoxelBt();
  bytes.pop_back();
  EXPECT_EQ(CodeOf(bytes, {}), Code::kInvalid);
}

TEST(ColumnSumsTest, AreThoseOfEachVoxelAdded) {
  std::mt19937 random(11);
  for (int run = 0; run < 100; ++run) {
    const std::uint32_t per_cell = run % 7 + 1, width = 5, height = 4;
    ColumnSums sums(width, height, per_cell);
    std::vector<std::uint32_t> expected(width * height, 0);
    for (int box = 0; box < 6; ++box) {
      const auto span = [&](std::uint32_t voxels) {
        const auto begin = std::uniform_int_distribution<std::uint32_t>(0, voxels - 1)(random);
        return Span{begin, std::uniform_int_distribution<std::uint32_t>(begin + 1, voxels)(random)};
      };
      const Span x = span(width * per_cell), y = span(height * per_cell);
      const std::uint32_t layers = random() % 9 + 1;
      sums.Add(x, y, layers);
      for (std::uint32_t v = y.begin; v < y.end; ++v) {
        for (std::uint32_t u = x.begin; u < x.end; ++u) {
          expected[v / per_cell * width + u / per_cell] += layers;
        }
      }
    }
    ASSERT_EQ(std::move(sums).Finish(), expected) << "run " << run;
  }
}

TEST(RecordedCutTest, CorridorIsThatOfOctomapItself) {
  LARES_REQUIRE_DATA(file, "octomap/geb079.bt");
  octomap::OcTree tree(file.string());
  CutOptions options;
  options.heights = {0.05, 1.38};
  const GridCut cut =
      CutOctomap([&] { return environment::ByteReader::OfFile(file, "geb079.bt"); }, options);
  EXPECT_NEAR(cut.layers.low_m, 0.08, 1e-9);
  EXPECT_NEAR(cut.layers.high_m, 1.44, 1e-9);
  const grid::Grid& grid = cut.grid;
  for (std::uint32_t y = 0; y < grid.height; ++y) {
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      Cell expected = Cell::kFree;
      for (int layer = 1; layer < 18 && expected != Cell::kOccupied; ++layer) {
        const octomap::OcTreeNode* node =
            tree.search(grid.origin_x_m + (x + 0.5) * 0.08, grid.origin_y_m + (y + 0.5) * 0.08,
                        (layer + 0.5) * 0.08);
        if (node == nullptr) {
          expected = Cell::kUnknown;
        } else if (tree.isNodeOccupied(node)) {
          expected = Cell::kOccupied;
        }
      }
      ASSERT_EQ(grid.At(x, y), expected) << x << " " << y;
    }
  }
  EXPECT_GT(grid::Count(grid).free, 5'000U);
  EXPECT_GT(grid::Count(grid).occupied, 5'000U);
}

}  // namespace
}  // namespace lares::volume
