#include "mapping/grid/grid_diff.h"

#include <cmath>
#include <optional>

namespace lares::grid {
namespace {

// The first grid at the middle of a cell of the second.
class Lookup {
 public:
  Lookup(const Grid& before, const Grid& after) : before_(before), after_(after) {}

  std::optional<Cell> At(std::uint32_t x, std::uint32_t y) const {
    const double across_m = (x + 0.5) * after_.resolution_m;
    const double along_m = (y + 0.5) * after_.resolution_m;
    const double c = std::cos(after_.yaw_rad);
    const double s = std::sin(after_.yaw_rad);
    const double map_x_m = after_.origin_x_m + c * across_m - s * along_m - before_.origin_x_m;
    const double map_y_m = after_.origin_y_m + s * across_m + c * along_m - before_.origin_y_m;
    const double bc = std::cos(before_.yaw_rad);
    const double bs = std::sin(before_.yaw_rad);
    const double column = std::floor((bc * map_x_m + bs * map_y_m) / before_.resolution_m);
    const double row = std::floor((bc * map_y_m - bs * map_x_m) / before_.resolution_m);
    if (!(column >= 0 && row >= 0 && column < before_.width && row < before_.height)) {
      return std::nullopt;
    }
    return before_.At(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
  }

 private:
  const Grid& before_;
  const Grid& after_;
};

void Count(std::optional<Cell> before, Cell after, GridDiff& diff) {
  if (!before) {
    if (after == Cell::kUnknown) {
      ++diff.same;
    } else {
      ++diff.beyond_before;
    }
  } else if (*before == after) {
    ++diff.same;
  } else if (after == Cell::kUnknown) {
    ++diff.became_unknown;
  } else if (*before == Cell::kUnknown) {
    ++diff.became_known;
  } else if (after == Cell::kOccupied) {
    ++diff.became_occupied;
  } else {
    ++diff.became_free;
  }
}

}  // namespace

GridDiff DiffGrids(const Grid& before, const Grid& after) {
  GridDiff diff;
  diff.same_cut = before.resolution_m == after.resolution_m &&
                  before.origin_x_m == after.origin_x_m && before.origin_y_m == after.origin_y_m &&
                  before.yaw_rad == after.yaw_rad && before.width == after.width &&
                  before.height == after.height;
  const Lookup lookup(before, after);
  for (std::uint32_t y = 0; y < after.height; ++y) {
    for (std::uint32_t x = 0; x < after.width; ++x) {
      const std::optional<Cell> stood =
          diff.same_cut ? std::optional(before.At(x, y)) : lookup.At(x, y);
      Count(stood, after.At(x, y), diff);
    }
  }
  const std::uint64_t changed = diff.became_occupied + diff.became_free + diff.became_known +
                                diff.became_unknown + diff.beyond_before;
  diff.changed_area_m2 = static_cast<double>(changed) * after.resolution_m * after.resolution_m;
  return diff;
}

}  // namespace lares::grid
