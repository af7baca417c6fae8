// Occupancy grids: map_server's YAML and the PGM that it names, together in one tar.
#pragma once

#include <functional>

#include "mapping/environment/layer_format.h"
#include "mapping/environment/map_yaml.h"
#include "mapping/environment/pgm.h"
#include "mapping/environment/tar_reader.h"

namespace lares::environment {

// `open` begins the archive anew each time (it is read twice: the YAML first, then its image).
// Throws kInvalid when it is no tar, does not hold exactly one YAML, the YAML is not as map_server
// wants it, or its image is outside the archive, missing, or no whole PGM. Bounds are those of the
// image in the map frame, turned by the origin's yaw. Memory is constant.
LayerFacts CheckGrid(const std::function<TarReader()>& open, const std::string& name);

struct GridImage {
  MapYaml map;
  PgmHeader image;
};
// The same, and calls `visit` for each pixel, the first (topmost) row first.
GridImage ReadGridImage(const std::function<TarReader()>& open, const std::string& name,
                        const std::function<void(Occupancy)>& visit);

}  // namespace lares::environment
