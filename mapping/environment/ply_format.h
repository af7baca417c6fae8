// PLY point clouds: ASCII and both binary byte orders, read value by value.
#pragma once

#include "mapping/environment/byte_reader.h"
#include "mapping/environment/layer_format.h"

namespace lares::environment {

// Throws kInvalid naming the byte, element and number when the header is malformed, has no vertices
// with x, y and z, an element is cut off or no number, a coordinate is not finite, or bytes follow
// the last element. Memory is constant (the header is limited to 64 KiB).
LayerFacts CheckCloud(ByteReader& reader);

}  // namespace lares::environment
