#include "mapping/grid/distance.h"

#include <algorithm>
#include <cstddef>

namespace lares::grid {
namespace {

// To the nearest occupied cell of the same column, not squared.
std::vector<std::uint32_t> DistancesAlongY(const Grid& grid) {
  std::vector<std::uint32_t> distances(grid.cells.size(), kFar);
  const std::size_t width = grid.width;
  const auto step = [&](std::size_t to, std::size_t from) {
    if (distances[from] != kFar) distances[to] = std::min(distances[to], distances[from] + 1);
  };
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == Cell::kOccupied) {
      distances[i] = 0;
    } else if (i >= width) {
      step(i, i - width);
    }
  }
  for (std::size_t i = grid.cells.size(); i-- > 0;) {
    if (i + width < grid.cells.size()) step(i, i + width);
  }
  return distances;
}

// The lower envelope of the parabolas h(x) = (x − q)² + f(q) over one row.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : parabolas_(width) {}

  // `along_y` is the row's distances along y, and is given the squared ones.
  void TransformRow(std::uint32_t* along_y, std::size_t width) {
    count_ = 0;
    for (std::size_t q = 0; q < width; ++q) {
      if (along_y[q] != kFar) Add(q, along_y[q]);
    }
    std::size_t lowest = 0;
    for (std::size_t x = 0; x < width; ++x) {
      along_y[x] = count_ == 0 ? kFar : SquaredAt(x, lowest);
    }
  }

 private:
  struct Parabola {
    std::int64_t q = 0;
    std::int64_t f = 0;  // a squared distance
    double from = 0;     // where it begins to be the lowest; −∞ for the first is never read
  };

  void Add(std::size_t x, std::uint64_t along_y) {
    Parabola added{static_cast<std::int64_t>(x), static_cast<std::int64_t>(along_y * along_y), 0};
    while (count_ > 0) {
      const Parabola& top = parabolas_[count_ - 1];
      added.from = static_cast<double>(added.f + added.q * added.q - top.f - top.q * top.q) /
                   static_cast<double>(2 * (added.q - top.q));
      if (count_ == 1 || added.from > top.from) break;
      --count_;
    }
    parabolas_[count_++] = added;
  }

  // `lowest` is where the search for x − 1 ended.
  std::uint32_t SquaredAt(std::size_t x, std::size_t& lowest) const {
    while (lowest + 1 < count_ && parabolas_[lowest + 1].from < static_cast<double>(x)) ++lowest;
    const std::int64_t along_x = static_cast<std::int64_t>(x) - parabolas_[lowest].q;
    return static_cast<std::uint32_t>(
        std::min<std::int64_t>(along_x * along_x + parabolas_[lowest].f, kFar));
  }

  std::vector<Parabola> parabolas_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::uint32_t> SquaredDistances(const Grid& grid) {
  std::vector<std::uint32_t> distances = DistancesAlongY(grid);
  Envelope envelope(grid.width);
  for (std::size_t y = 0; y < grid.height; ++y) {
    envelope.TransformRow(distances.data() + y * grid.width, grid.width);
  }
  return distances;
}

}  // namespace lares::grid
