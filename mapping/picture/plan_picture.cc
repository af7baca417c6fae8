#include "mapping/picture/plan_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"

namespace lares::picture {
namespace {

constexpr Colour kUnknown{205, 205, 205};
constexpr Colour kFree{255, 255, 255};
constexpr Colour kOccupied{40, 40, 48};
constexpr double kUnknownSide_m = 0.1;  // of an object without an extent
constexpr double kMargin = 0.05;
constexpr std::size_t kMostObjects = 2000;  // the largest; more than anybody could tell apart
constexpr double kRoom_m2 = 5;              // what is larger than any piece of furniture
constexpr double kTint = 0.25;
constexpr double kSmallest_m = 1;   // what is shown at least, so that one cup fills no picture
constexpr double kLargest_m = 1e5;  // beyond it a pose is a fault, and not shown

// Well apart from one another and from the grid's greys.
constexpr Colour kClassColours[] = {{228, 87, 86},  {76, 120, 168},  {84, 162, 75},
                                    {245, 133, 24}, {114, 183, 178}, {178, 121, 162},
                                    {238, 202, 59}, {157, 117, 93}};

Colour ColourOf(const std::string& class_iri) {
  // FNV-1a: the same on every machine, so that pictures can be compared.
  std::uint32_t hash = 2166136261u;
  for (const char c : class_iri) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  return kClassColours[hash % std::size(kClassColours)];
}

struct Bounds {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;
  bool empty = true;

  void Add(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    if (empty) {
      *this = {x, y, x, y, false};
      return;
    }
    min_x = std::min(min_x, x);
    min_y = std::min(min_y, y);
    max_x = std::max(max_x, x);
    max_y = std::max(max_y, y);
  }
};

// A box on the floor plan, turned about the vertical.
struct Footprint {
  Colour colour{};
  Eigen::Vector2d middle{0, 0};
  double yaw_rad = 0;
  double half_x = 0, half_y = 0;  // metres

  bool Holds(double x, double y) const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    const double dx = x - middle.x(), dy = y - middle.y();
    return std::abs(c * dx + s * dy) <= half_x && std::abs(c * dy - s * dx) <= half_y;
  }
};

std::vector<Footprint> FootprintsOf(const std::vector<semantic::MapObject>& objects) {
  std::vector<Footprint> footprints;
  for (const semantic::MapObject& object : objects) {
    if (!object.map_from_object) continue;
    const RigidTransform& pose = *object.map_from_object;
    if (!(pose.translation_m.cwiseAbs().maxCoeff() < kLargest_m)) continue;
    const Eigen::Vector3d extent_m =
        object.extent_m.value_or(Eigen::Vector3d::Constant(kUnknownSide_m));
    footprints.push_back({ColourOf(object.class_iri),
                          {pose.translation_m.x(), pose.translation_m.y()},
                          YawRad(pose),
                          std::max(extent_m.x(), 0.02) / 2,
                          std::max(extent_m.y(), 0.02) / 2});
  }
  // The larger below the smaller, so that a cup shows on its table.
  std::stable_sort(footprints.begin(), footprints.end(), [](const auto& a, const auto& b) {
    return a.half_x * a.half_y > b.half_x * b.half_y;
  });
  if (footprints.size() > kMostObjects) footprints.resize(kMostObjects);
  return footprints;
}

Eigen::Vector2d MapOf(const grid::Grid& grid, double column, double row) {
  const double across = column * grid.resolution_m, along = row * grid.resolution_m;
  const double c = std::cos(grid.yaw_rad), s = std::sin(grid.yaw_rad);
  return {grid.origin_x_m + c * across - s * along, grid.origin_y_m + s * across + c * along};
}

Bounds Known(const grid::Grid* grid, const std::vector<Footprint>& footprints) {
  Bounds bounds;
  if (grid != nullptr) {
    for (std::uint32_t y = 0; y < grid->height; ++y) {
      for (std::uint32_t x = 0; x < grid->width; ++x) {
        if (grid->At(x, y) == grid::Cell::kUnknown) continue;
        for (const double dx : {0.0, 1.0}) {
          const Eigen::Vector2d corner = MapOf(*grid, x + dx, y + dx);
          bounds.Add(corner.x(), corner.y());
        }
      }
    }
  }
  for (const Footprint& footprint : footprints) {
    const double reach = std::hypot(footprint.half_x, footprint.half_y);
    bounds.Add(footprint.middle.x() - reach, footprint.middle.y() - reach);
    bounds.Add(footprint.middle.x() + reach, footprint.middle.y() + reach);
  }
  return bounds;
}

std::optional<grid::Cell> CellAt(const grid::Grid& grid, double x, double y) {
  const double c = std::cos(grid.yaw_rad), s = std::sin(grid.yaw_rad);
  const double dx = x - grid.origin_x_m, dy = y - grid.origin_y_m;
  const double column = std::floor((c * dx + s * dy) / grid.resolution_m);
  const double row = std::floor((c * dy - s * dx) / grid.resolution_m);
  if (!(column >= 0 && row >= 0 && column < grid.width && row < grid.height)) return std::nullopt;
  return grid.At(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
}

Colour GridColour(const grid::Grid* grid, double x, double y) {
  const auto cell = grid == nullptr ? std::nullopt : CellAt(*grid, x, y);
  if (!cell || *cell == grid::Cell::kUnknown) return kUnknown;
  return *cell == grid::Cell::kFree ? kFree : kOccupied;
}

// The darkest of the grid over a pixel's square, so that thin walls stay.
Colour FloorAt(const grid::Grid* grid, double x, double y, double side_m) {
  Colour colour = GridColour(grid, x, y);
  if (grid == nullptr) return colour;
  const int steps = std::clamp(static_cast<int>(side_m / grid->resolution_m), 0, 8);
  for (int i = 0; i <= steps && steps > 0; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Colour other = GridColour(grid, x + side_m * (static_cast<double>(i) / steps - 0.5),
                                      y + side_m * (static_cast<double>(j) / steps - 0.5));
      if (other == kOccupied) return kOccupied;
      if (other == kFree) colour = kFree;
    }
  }
  return colour;
}

Colour Tinted(const Colour& below, const Colour& tint) {
  Colour mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    mixed[i] = static_cast<std::uint8_t>(below[i] + kTint * (tint[i] - below[i]));
  }
  return mixed;
}

// How pixels lie in the map frame.
struct Plan {
  double left_m = 0, top_m = 0;  // of the picture's corner
  double side_m = 0;             // of a pixel

  double XOf(std::uint32_t column) const { return left_m + (column + 0.5) * side_m; }
  double YOf(std::uint32_t row) const { return top_m - (row + 0.5) * side_m; }
};

// The pixels, first and beyond the last, that reach from `from` to `to` (in pixels), within `size`.
std::pair<std::uint32_t, std::uint32_t> Span(double from, double to, std::uint32_t size) {
  return {static_cast<std::uint32_t>(std::clamp(std::floor(from), 0.0, static_cast<double>(size))),
          static_cast<std::uint32_t>(std::clamp(std::ceil(to), 0.0, static_cast<double>(size)))};
}

// Over what lies there already; rooms only tint what is in them.
void Draw(const Footprint& footprint, const Plan& plan, Image& image) {
  const bool is_room = 4 * footprint.half_x * footprint.half_y > kRoom_m2;
  const double reach_m = std::hypot(footprint.half_x, footprint.half_y);
  const auto [first_column, end_column] =
      Span((footprint.middle.x() - reach_m - plan.left_m) / plan.side_m,
           (footprint.middle.x() + reach_m - plan.left_m) / plan.side_m, image.width);
  const auto [first_row, end_row] =
      Span((plan.top_m - footprint.middle.y() - reach_m) / plan.side_m,
           (plan.top_m - footprint.middle.y() + reach_m) / plan.side_m, image.height);
  for (std::uint32_t row = first_row; row < end_row; ++row) {
    for (std::uint32_t column = first_column; column < end_column; ++column) {
      if (!footprint.Holds(plan.XOf(column), plan.YOf(row))) continue;
      Colour& pixel = image.pixels[static_cast<std::size_t>(row) * image.width + column];
      pixel = is_room ? Tinted(pixel, footprint.colour) : footprint.colour;
    }
  }
}

}  // namespace

Image DrawPlan(const grid::Grid* grid, const std::vector<semantic::MapObject>& objects,
               const PlanOptions& options) {
  if (options.size_px < 16 || options.size_px > 2048) {
    throw Error(Code::kInvalid,
                "a picture has 16 to 2048 pixels, not " + std::to_string(options.size_px));
  }
  const std::vector<Footprint> footprints = FootprintsOf(objects);
  Bounds shown = Known(grid, footprints);
  const double width_m = std::max(shown.max_x - shown.min_x, kSmallest_m) * (1 + 2 * kMargin);
  const double height_m = std::max(shown.max_y - shown.min_y, kSmallest_m) * (1 + 2 * kMargin);
  const double side_m = std::max(width_m, height_m) / options.size_px;
  Image image;
  image.width = std::max(1u, static_cast<std::uint32_t>(std::lround(width_m / side_m)));
  image.height = std::max(1u, static_cast<std::uint32_t>(std::lround(height_m / side_m)));
  image.pixels.reserve(static_cast<std::size_t>(image.width) * image.height);
  const Plan plan{(shown.min_x + shown.max_x - width_m) / 2,
                  (shown.min_y + shown.max_y + height_m) / 2, side_m};
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      image.pixels.push_back(FloorAt(grid, plan.XOf(column), plan.YOf(row), side_m));
    }
  }
  for (const Footprint& footprint : footprints) Draw(footprint, plan, image);
  return image;
}

}  // namespace lares::picture
