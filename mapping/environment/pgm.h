// Portable grey maps, the images of occupancy grids: P5 (binary) and P2 (text), one image a file.
#pragma once

#include <cstdint>
#include <functional>

#include "mapping/environment/byte_reader.h"

namespace lares::environment {

struct PgmHeader {
  bool is_text = false;
  std::uint32_t width = 0, height = 0;
  std::uint32_t white = 0;  // the largest grey value, 1–65535
};

// Calls `visit(grey)` for each pixel, first row first, grey in 0–1. Throws kInvalid naming the byte
// when the header is malformed (a side is limited to 1 000 000, the image to 2³² pixels), pixels
// are missing or too bright, or more than white space follows them. Memory is constant.
PgmHeader ReadPgm(ByteReader& reader, const std::function<void(double grey)>& visit);

}  // namespace lares::environment
