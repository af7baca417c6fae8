#include "mapping/grid/map_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "base/error.h"

namespace lares::grid {
namespace {

// As map_saver writes them. Unknown, 205, is an occupancy of 50/255 = 0.19608: above free_thresh.
constexpr char kOccupied = 0;
constexpr char kFree = static_cast<char>(254);
constexpr char kUnknown = static_cast<char>(205);
constexpr const char* kThresholds = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

char PixelOf(Cell cell) {
  if (cell == Cell::kOccupied) return kOccupied;
  return cell == Cell::kFree ? kFree : kUnknown;
}

std::string ToText(double number) {
  char text[40];
  // Twelve digits: a multiple of the resolution shows as people write it. + 0.0: no "-0".
  std::snprintf(text, sizeof text, "%.12g", number + 0.0);
  return text;
}

}  // namespace

std::string ToMapYaml(const Grid& grid, const std::string& image) {
  const bool is_plain = std::all_of(image.begin(), image.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-';
  });
  if (image.empty() || !is_plain) {
    throw Error(Code::kInvalid, "'" + image + "' cannot be the name of a map's image");
  }
  return "image: " + image + "\nmode: trinary\nresolution: " + ToText(grid.resolution_m) +
         "\norigin: [" + ToText(grid.origin_x_m) + ", " + ToText(grid.origin_y_m) + ", " +
         ToText(grid.yaw_rad) + "]\n" + kThresholds;
}

std::string ToPgm(const Grid& grid) {
  std::string pgm =
      "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  pgm.reserve(pgm.size() + grid.cells.size());
  for (std::uint32_t row = grid.height; row-- > 0;) {
    for (std::uint32_t x = 0; x < grid.width; ++x) pgm += PixelOf(grid.At(x, row));
  }
  return pgm;
}

}  // namespace lares::grid
