#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "mapping/grid/inflate.h"
#include "mapping/volume/cut.h"

// Any bytes: a grid or an Error, nothing else.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const double resolution_m : {0.0, 0.3, 20.0}) {
    lares::volume::CutOptions options;
    options.resolution_m = resolution_m;
    options.floor_z_m = resolution_m == 0.3 ? -1 : 0;
    options.max_cells = 1 << 16;
    try {
      const lares::volume::GridCut cut = lares::volume::CutOctomap(
          [&] { return lares::environment::ByteReader::OfBytes(bytes, "fuzz"); }, options);
      lares::grid::Inflate(cut.grid, 2 * cut.grid.resolution_m);
    } catch (const lares::Error&) {
    }
  }
  return 0;
}
