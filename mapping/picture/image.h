// Pictures in memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lares::picture {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<Colour> pixels;  // row by row from the top
};

}  // namespace lares::picture
