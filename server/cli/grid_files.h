// Occupancy grids between two files on disk and the one archive that a layer is.
#pragma once

#include <filesystem>

namespace lares::cli {

// Writes map_server's YAML and the image that it names into a new tar `archive`; the image is named
// by its file name alone there. Throws kInvalid with the place in the YAML, kNotFound for an image
// that is missing.
void PackGrid(const std::filesystem::path& yaml, const std::filesystem::path& archive);

// Writes the archive's files into `folder`, which is created. Throws kInvalid for a malformed
// archive.
void UnpackGrid(const std::filesystem::path& archive, const std::filesystem::path& folder);

}  // namespace lares::cli
