// Trajectories in TUM's text format: "timestamp tx ty tz qx qy qz qw" in each line.
#pragma once

#include "mapping/environment/byte_reader.h"
#include "mapping/environment/layer_format.h"

namespace lares::environment {

// Empty lines and lines that begin with '#' are skipped. Throws kInvalid with the line when a row
// is not eight finite numbers, its time does not rise, its quaternion's length is not 1 within
// 0.01; and when there is no row.
LayerFacts CheckTrajectory(ByteReader& reader);

}  // namespace lares::environment
