#include "mapping/grid/grid_diff.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lares::grid {
namespace {

// Rows from the largest y down: '#' occupied, '.' free, '?' unknown.
Grid Drawn(const std::vector<std::string>& rows) {
  Grid grid;
  grid.resolution_m = 0.1;
  grid.width = static_cast<std::uint32_t>(rows.front().size());
  grid.height = static_cast<std::uint32_t>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.cells.push_back(c == '#' ? Cell::kOccupied : c == '.' ? Cell::kFree : Cell::kUnknown);
    }
  }
  return grid;
}

TEST(GridDiffTest, EachKindOfChangeIsCounted) {
  const GridDiff diff = DiffGrids(Drawn({"..#", "?#."}), Drawn({".#.", "..?"}));
  EXPECT_TRUE(diff.same_cut);
  EXPECT_EQ(diff.same, 1u);
  EXPECT_EQ(diff.became_occupied, 1u);
  EXPECT_EQ(diff.became_free, 2u);
  EXPECT_EQ(diff.became_known, 1u);
  EXPECT_EQ(diff.became_unknown, 1u);
  EXPECT_NEAR(diff.changed_area_m2, 0.05, 1e-12);
}

TEST(GridDiffTest, GridsCutDifferentlyAreComparedByPlace) {
  const Grid before = Drawn({"#..", "..."});
  Grid after = Drawn({"?????", "?#..?", "?...?", "?????"});
  after.origin_x_m = -0.1;
  after.origin_y_m = -0.1;
  const GridDiff diff = DiffGrids(before, after);
  EXPECT_FALSE(diff.same_cut);
  EXPECT_EQ(diff.changed_area_m2, 0);
  EXPECT_EQ(diff.same, 20u);
}

TEST(GridDiffTest, TurnedGridIsComparedByPlace) {
  // A quarter turn: what lies along y in one lies along x in the other.
  const Grid before = Drawn({"#", ".", "."});
  Grid after = Drawn({"..#"});
  after.yaw_rad = 1.5707963267948966;
  after.origin_x_m = 0.1;
  const GridDiff diff = DiffGrids(before, after);
  EXPECT_EQ(diff.same, 3u);
  Grid mirrored = after;
  mirrored.yaw_rad = -1.5707963267948966;
  mirrored.origin_x_m = 0;
  mirrored.origin_y_m = 0.3;
  EXPECT_EQ(DiffGrids(before, mirrored).became_occupied, 1u);
}

TEST(GridDiffTest, KnownCellsBeyondTheFirstGridAreCounted) {
  Grid after = Drawn({"..#?"});
  EXPECT_EQ(DiffGrids(Drawn({".."}), after).beyond_before, 1u);
}

}  // namespace
}  // namespace lares::grid
