#include "mapping/environment/map_yaml.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/number.h"
#include "mapping/environment/facts.h"

namespace lares::environment {
namespace {

class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : source_(source) {
    try {
      root_ = YAML::Load(std::string(text));
    } catch (const YAML::Exception& fault) {
      Fail(fault.mark, "not YAML: " + Excerpt(fault.msg));
    }
    if (!root_.IsMap()) Fail(root_.Mark(), "not a map description: no 'key: value' lines");
  }

  YAML::Node Get(const char* key) const {
    const YAML::Node node = root_[key];
    if (!node.IsDefined() || node.IsNull()) Fail(root_.Mark(), Quoted(key) + " is missing");
    return node;
  }

  std::string GetText(const char* key) const {
    const YAML::Node node = Get(key);
    if (!node.IsScalar()) Fail(node.Mark(), Quoted(key) + " is not a text");
    return node.Scalar();
  }

  double GetNumber(const char* key) const { return ToFinite(Get(key), key); }

  double ToFinite(const YAML::Node& node, const char* key) const {
    const std::optional<double> number =
        node.IsScalar() ? ToNumber(node.Scalar()) : std::optional<double>();
    if (!number || !std::isfinite(*number)) {
      Fail(node.Mark(), Quoted(key) + " is not a finite number");
    }
    return *number;
  }

  std::optional<std::string> FindText(const char* key) const {
    const YAML::Node node = root_[key];
    if (!node.IsDefined()) return std::nullopt;
    return GetText(key);
  }

  [[noreturn]] void FailAt(const char* key, const std::string& message) const {
    Fail(root_[key].Mark(), Quoted(key) + message);
  }

 private:
  static std::string Quoted(const char* key) { return "'" + std::string(key) + "'"; }

  [[noreturn]] void Fail(const YAML::Mark& mark, const std::string& message) const {
    Place place{source_};
    if (!mark.is_null()) {
      place.line = mark.line + 1;
      place.column = mark.column + 1;
    }
    throw Error(Code::kInvalid, message, place);
  }

  const std::string& source_;
  YAML::Node root_;
};

std::array<double, 3> ReadOrigin(const Reader& reader) {
  const YAML::Node node = reader.Get("origin");
  if (!node.IsSequence() || node.size() != 3) {
    reader.FailAt("origin", " is three numbers: x and y in metres, yaw in radians");
  }
  std::array<double, 3> origin{};
  for (std::size_t i = 0; i < 3; ++i) origin[i] = reader.ToFinite(node[i], "origin");
  return origin;
}

bool ReadNegate(const Reader& reader) {
  const std::string text = reader.GetText("negate");
  if (text == "0" || text == "false" || text == "False" || text == "no") return false;
  if (text == "1" || text == "true" || text == "True" || text == "yes") return true;
  reader.FailAt("negate", " is neither 0 nor 1");
}

MapYaml::Mode ReadMode(const Reader& reader) {
  const std::string text = reader.FindText("mode").value_or("trinary");
  if (text == "trinary") return MapYaml::Mode::kTrinary;
  if (text == "scale") return MapYaml::Mode::kScale;
  if (text == "raw") return MapYaml::Mode::kRaw;
  reader.FailAt("mode", " is none of trinary, scale and raw");
}

}  // namespace

Occupancy OccupancyOf(const MapYaml& map, double grey) {
  double occupied = map.negate ? grey : 1 - grey;
  if (map.mode == MapYaml::Mode::kRaw) {
    occupied = std::round(grey * 255) / 100;
    if (occupied > 1) return Occupancy::kUnknown;
  }
  if (occupied > map.occupied_thresh) return Occupancy::kOccupied;
  return occupied < map.free_thresh ? Occupancy::kFree : Occupancy::kUnknown;
}

MapYaml ReadMapYaml(std::string_view text, const std::string& source) {
  const Reader reader(text, source);
  MapYaml map;
  map.image = reader.GetText("image");
  if (map.image.empty()) reader.FailAt("image", " is empty");
  map.resolution_m = reader.GetNumber("resolution");
  if (!(map.resolution_m > 0 && map.resolution_m <= 1000)) {
    reader.FailAt("resolution", " must be more than 0 and at most 1000 m");
  }
  map.origin = ReadOrigin(reader);
  map.negate = ReadNegate(reader);
  map.occupied_thresh = reader.GetNumber("occupied_thresh");
  map.free_thresh = reader.GetNumber("free_thresh");
  if (map.occupied_thresh > 1) reader.FailAt("occupied_thresh", " is more than 1");
  if (map.free_thresh < 0) reader.FailAt("free_thresh", " is less than 0");
  if (map.free_thresh >= map.occupied_thresh) {
    reader.FailAt("free_thresh", " must be less than occupied_thresh");
  }
  map.mode = ReadMode(reader);
  return map;
}

}  // namespace lares::environment
