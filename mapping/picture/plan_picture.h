// A place seen from above: its grid, and the objects on its map.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/grid/grid.h"
#include "mapping/picture/image.h"
#include "mapping/semantic/map_object.h"

namespace lares::picture {

struct PlanOptions {
  std::uint32_t size_px = 256;  // of the longer side, 16 to 2048
};

// North up: y of the map frame upwards, x to the right. Occupied cells are dark, free ones white,
// unknown ones grey; objects are boxes in the colour of their class, as they stand and as large as
// they are (10 cm where that is not known); what is larger than 5 m², a room, only tints. Of more
// than 2000 the largest are drawn. The picture shows what is known and 5 % around it, and is grey
// where nothing is. `grid` may be null. Throws kInvalid for a size out of range.
Image DrawPlan(const grid::Grid* grid, const std::vector<semantic::MapObject>& objects,
               const PlanOptions& options = {});

}  // namespace lares::picture
