// The YAML that ROS's map_server reads beside an occupancy grid's image.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace lares::environment {

struct MapYaml {
  enum class Mode { kTrinary, kScale, kRaw };

  std::string image;  // as written
  double resolution_m = 0;
  std::array<double, 3> origin{};  // x and y in metres and yaw in radians of the lower left corner
  bool negate = false;             // light is occupied
  double occupied_thresh = 0;
  double free_thresh = 0;
  Mode mode = Mode::kTrinary;
};

enum class Occupancy : std::uint8_t { kUnknown, kFree, kOccupied };

// What a pixel says, `grey` in 0–1 (black–white). Between the thresholds is unknown, also of mode
// `scale`; mode `raw` has per cents of occupancy, and unknown above 100.
Occupancy OccupancyOf(const MapYaml& map, double grey);

// As nav2's map_server: all keys but `mode` must be there, unknown ones are ignored. Beyond it:
// numbers must be finite, 0 ≤ free_thresh < occupied_thresh ≤ 1, the resolution positive. Throws
// kInvalid with `source`, line and column.
MapYaml ReadMapYaml(std::string_view text, const std::string& source);

inline constexpr std::size_t kMaxMapYamlBytes = 16 << 10;

}  // namespace lares::environment
