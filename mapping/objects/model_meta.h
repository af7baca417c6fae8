// The meta.xml of a recognition model: its name, kind and size, as RoboEarth's vision system
// (re_vision) writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lares::objects {

// The object's frame has its origin in the middle; x along the width, y the height, z the depth.
struct ModelMeta {
  std::string name;
  std::string kind;  // "planar" or "3D"
  std::uint32_t faces = 0;
  struct Size {
    double width_m = 0, height_m = 0, depth_m = 0;
  };
  std::optional<Size> size;     // planar models
  std::optional<double> scale;  // 3-D models: metres per unit of their points
};

inline constexpr std::size_t kMaxMetaBytes = 1 << 20;

// Whether the text is XML whose first element is <model>.
bool IsModelMeta(std::string_view text);

// Throws kInvalid with line and column for what is no such XML: elements left open or crossing,
// values that are absent, doubled or no numbers, sizes that are not above 0 and at most 1000 m.
ModelMeta ReadModelMeta(std::string_view text, const std::string& source);

}  // namespace lares::objects
