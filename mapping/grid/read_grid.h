// Grids out of the `grid` layer of an environment.
#pragma once

#include <functional>
#include <string>

#include "mapping/environment/tar_reader.h"
#include "mapping/grid/grid.h"

namespace lares::grid {

// `open` begins the archive anew each time. Throws as environment::CheckGrid, and kTooLarge for
// more than kMaxCells.
Grid ReadGrid(const std::function<environment::TarReader()>& open, const std::string& name);

}  // namespace lares::grid
