// Grids: distances, inflation, and the files that map_server loads.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "base/error.h"
#include "mapping/environment/grid_format.h"
#include "mapping/environment/tar_reader.h"
#include "mapping/grid/distance.h"
#include "mapping/grid/inflate.h"
#include "mapping/grid/map_files.h"
#include "mapping/grid/read_grid.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::grid {
namespace {

// Rows from the largest y down, as one looks at them: '#' occupied, '.' free, '?' unknown.
Grid Drawn(const std::vector<std::string>& rows, double resolution_m = 0.1) {
  Grid grid;
  grid.resolution_m = resolution_m;
  grid.width = static_cast<std::uint32_t>(rows.front().size());
  grid.height = static_cast<std::uint32_t>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.cells.push_back(c == '#' ? Cell::kOccupied : c == '.' ? Cell::kFree : Cell::kUnknown);
    }
  }
  return grid;
}

std::vector<std::string> Draw(const Grid& grid) {
  std::vector<std::string> rows;
  for (std::uint32_t y = grid.height; y-- > 0;) {
    rows.emplace_back();
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      const Cell cell = grid.At(x, y);
      rows.back() += cell == Cell::kOccupied ? '#' : cell == Cell::kFree ? '.' : '?';
    }
  }
  return rows;
}

Grid Random(std::mt19937& random, std::uint32_t max_side, double occupied) {
  Grid grid;
  grid.resolution_m = 0.05;
  grid.width = std::uniform_int_distribution<std::uint32_t>(1, max_side)(random);
  grid.height = std::uniform_int_distribution<std::uint32_t>(1, max_side)(random);
  std::uniform_real_distribution<double> chance;
  for (std::uint32_t i = 0; i < grid.width * grid.height; ++i) {
    const bool is_free = chance(random) < 0.7;
    grid.cells.push_back(chance(random) < occupied ? Cell::kOccupied
                         : is_free                 ? Cell::kFree
                                                   : Cell::kUnknown);
  }
  return grid;
}

std::uint32_t SquaredByForce(const Grid& grid, std::uint32_t x, std::uint32_t y) {
  std::int64_t least = kFar;
  for (std::int64_t v = 0; v < grid.height; ++v) {
    for (std::int64_t u = 0; u < grid.width; ++u) {
      if (grid.At(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v)) ==
          Cell::kOccupied) {
        least = std::min(least, (u - x) * (u - x) + (v - y) * (v - y));
      }
    }
  }
  return static_cast<std::uint32_t>(least);
}

TEST(DistanceTest, IsThatOfBruteForceOnRandomGrids) {
  std::mt19937 random(1);
  for (int run = 0; run < 200; ++run) {
    const double occupied = run % 4 == 0 ? 0.5 : run % 4 == 1 ? 0.01 : 0.05;
    const Grid grid = Random(random, 40, occupied);
    const std::vector<std::uint32_t> distances = SquaredDistances(grid);
    for (std::uint32_t y = 0; y < grid.height; ++y) {
      for (std::uint32_t x = 0; x < grid.width; ++x) {
        ASSERT_EQ(distances[grid.IndexOf(x, y)], SquaredByForce(grid, x, y))
            << "run " << run << ", cell " << x << " " << y;
      }
    }
  }
}

TEST(DistanceTest, NothingOccupiedIsFarEverywhere) {
  for (const std::uint32_t distance : SquaredDistances(Drawn({"...", "?.?"}))) {
    EXPECT_EQ(distance, kFar);
  }
}

TEST(DistanceTest, OfALongGridIsExact) {
  Grid grid;
  grid.resolution_m = 1;
  grid.width = 60'000;
  grid.height = 1;
  grid.cells.assign(grid.width, Cell::kFree);
  grid.cells[0] = Cell::kOccupied;
  EXPECT_EQ(SquaredDistances(grid)[59'999], 59'999U * 59'999U);
  grid.width = 65'536;  // 65535² + … no longer fits
  grid.height = 2;
  grid.cells.assign(std::size_t{grid.width} * 2, Cell::kFree);
  grid.cells[0] = Cell::kOccupied;
  const auto distances = SquaredDistances(grid);
  EXPECT_EQ(distances[65'535], 65'535U * 65'535U);
  EXPECT_EQ(distances[2 * 65'536 - 1], 65'535U * 65'535U + 1);
}

TEST(InflateTest, TakesWhatIsExactlyAtTheRadius) {
  const Grid grid = Drawn({".......", ".......", ".......", "...#...", ".......", ".......",  //
                           "......."});
  const std::vector<std::string> two = {".......", "...#...", "..###..", ".#####.",
                                        "..###..", "...#...", "......."};
  EXPECT_EQ(Draw(Inflate(grid, 0.2)), two);
  EXPECT_EQ(Draw(Inflate(grid, 0.22)), two);
  EXPECT_NE(Draw(Inflate(grid, 0.224)), two);  // √5 cells
  EXPECT_EQ(Draw(Inflate(grid, 0.0999)), Draw(grid));
  EXPECT_EQ(Draw(Inflate(grid, 0)), Draw(grid));
}

TEST(InflateTest, SixTimesFiveCentimetresAreThirty) {
  // 0.3 / 0.05 is 5.999…: the sixth cell counts all the same.
  Grid grid = Drawn({"#........."}, 0.05);
  EXPECT_EQ(Draw(Inflate(grid, 0.3)), std::vector<std::string>{"#######..."});
}

TEST(InflateTest, UnknownBecomesOccupiedNearObstaclesOnly) {
  EXPECT_EQ(Draw(Inflate(Drawn({"#??..?"}), 0.1)), std::vector<std::string>{"##?..?"});
}

TEST(InflateTest, IsThatOfBruteForceOnRandomGrids) {
  std::mt19937 random(2);
  for (int run = 0; run < 100; ++run) {
    const Grid grid = Random(random, 30, 0.03);
    const std::uint32_t squared = std::uniform_int_distribution<std::uint32_t>(0, 80)(random);
    const Grid inflated = Inflate(grid, std::sqrt(squared) * grid.resolution_m);
    for (std::uint32_t y = 0; y < grid.height; ++y) {
      for (std::uint32_t x = 0; x < grid.width; ++x) {
        const bool is_near = SquaredByForce(grid, x, y) <= squared;
        ASSERT_EQ(inflated.At(x, y), is_near ? Cell::kOccupied : grid.At(x, y)) << "run " << run;
      }
    }
  }
}

TEST(InflateTest, RefusesARadiusThatIsNone) {
  for (const double radius_m :
       {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Inflate(Drawn({"."}), radius_m), Error);
  }
}

std::string TarOf(const Grid& grid) {
  return environment::testing::MakeTar(
      {{"map.yaml", ToMapYaml(grid, "map.pgm")}, {"map.pgm", ToPgm(grid)}});
}

Grid ReadTar(const std::string& tar) {
  return ReadGrid([&] { return environment::TarReader::OfBytes(tar, "grid.tar"); }, "grid.tar");
}

TEST(MapFilesTest, YamlHasAllThatMapServerWants) {
  Grid grid = Drawn({"."}, 0.05);
  grid.origin_x_m = -94 * 0.08;  // -7.5200000000000005
  grid.origin_y_m = -0.0;
  EXPECT_EQ(ToMapYaml(grid, "map.pgm"),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-7.52, 0, 0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapFilesTest, FirstRowOfTheImageIsTheLargestY) {
  Grid grid = Drawn({"..", "??", "##"});
  EXPECT_EQ(grid.At(0, 0), Cell::kOccupied);
  EXPECT_EQ(ToPgm(grid), "P5\n2 3\n255\n\xFE\xFE\xCD\xCD" + std::string(2, '\0'));
}

TEST(MapFilesTest, ImageIsOnlyEverAName) {
  for (const char* name : {"", "../map.pgm", "/map.pgm", "a b", "map.pgm\nmode: raw", "[x]"}) {
    EXPECT_THROW(ToMapYaml(Drawn({"."}), name), Error) << name;
  }
}

TEST(MapFilesTest, RoundTripKeepsEveryCellItsPlaceAndTheOrigin) {
  std::mt19937 random(3);
  for (int run = 0; run < 50; ++run) {
    Grid grid = Random(random, 20, 0.3);
    grid.origin_x_m = -3.25;
    grid.origin_y_m = 1.5;
    grid.yaw_rad = run % 2 == 0 ? 0 : 0.5;
    const Grid back = ReadTar(TarOf(grid));
    EXPECT_EQ(Draw(back), Draw(grid));
    EXPECT_EQ(back.width, grid.width);
    EXPECT_DOUBLE_EQ(back.resolution_m, grid.resolution_m);
    EXPECT_DOUBLE_EQ(back.origin_x_m, -3.25);
    EXPECT_DOUBLE_EQ(back.origin_y_m, 1.5);
    EXPECT_DOUBLE_EQ(back.yaw_rad, grid.yaw_rad);
  }
}

TEST(MapFilesTest, LayerCheckCountsTheSameCells) {
  const std::string tar = TarOf(Drawn({"#.?", "..?"}));
  const auto facts = environment::CheckGrid(
      [&] { return environment::TarReader::OfBytes(tar, "grid.tar"); }, "grid.tar");
  EXPECT_EQ(facts.facts.at("occupied_cells"), "1");
  EXPECT_EQ(facts.facts.at("free_cells"), "3");
}

TEST(ReadGridTest, FollowsNegateAndRawMode) {
  const std::string pgm = "P5\n4 1\n255\n" + std::string("\x00\x64\xFF\x32", 4);
  const auto read = [&](const std::string& negate, const std::string& mode) {
    return Draw(ReadTar(environment::testing::MakeTar(
        {{"m.yaml", "image: m.pgm\nmode: " + mode + "\nresolution: 1\norigin: [0, 0, 0]\nnegate: " +
                        negate + "\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"},
         {"m.pgm", pgm}})))[0];
  };
  EXPECT_EQ(read("0", "trinary"), "#?.#");
  EXPECT_EQ(read("1", "trinary"), ".?#.");
  EXPECT_EQ(read("0", "raw"), ".#??");  // 0, 100, 255 and 50 per cent
}

TEST(ReadGridTest, RefusesMoreCellsThanItHolds) {
  const std::string yaml =
      "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.25\n";
  const std::string tar = environment::testing::MakeTar(
      {{"m.yaml", yaml}, {"m.pgm", "P5\n4097 4096\n255\n" + std::string(4097 * 4096, '\0')}});
  try {
    ReadTar(tar);
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kTooLarge);
  }
}

TEST(GridTest, BoundsFollowTheYaw) {
  Grid grid = Drawn({"...", "..."}, 1);
  grid.origin_x_m = 1;
  grid.yaw_rad = 1.5707963267948966;
  const auto bounds_m = BoundsOf_m(grid);
  EXPECT_NEAR(bounds_m[0], -1, 1e-12);
  EXPECT_NEAR(bounds_m[1], 0, 1e-12);
  EXPECT_NEAR(bounds_m[2], 1, 1e-12);
  EXPECT_NEAR(bounds_m[3], 3, 1e-12);
}

}  // namespace
}  // namespace lares::grid
