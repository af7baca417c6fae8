// A version of an environment as a small picture.
#pragma once

#include <cstdint>
#include <string>

#include "server/knowledge/knowledge.h"

namespace lares::server {

// PNG: the grid layer from above, or else the octomap layer cut from 5 cm to 1.5 m, with the
// objects of the semantic layer. A layer that cannot be drawn (too large) is left out; a version
// with nothing to draw is a grey plate. Throws kInvalid for a size out of 16 to 2048.
std::string DrawThumbnail(Knowledge& knowledge, const store::EnvironmentVersion& version,
                          std::uint32_t size_px);

}  // namespace lares::server
