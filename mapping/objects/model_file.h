// One file of an object model, read for what it says of the object's shape.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "mapping/objects/model_meta.h"

namespace lares::objects {

struct ModelFileFacts {
  std::optional<std::uint64_t> points;          // of a PLY cloud
  std::optional<std::array<double, 6>> bounds;  // of its points, in its units: min x y z, max x y z
  std::optional<ModelMeta> meta;                // of a meta.xml
};

// A `.ply` is read whole, in constant memory; an `.xml` when it is a model's meta.xml. Of any other
// file nothing is known, and it is not opened. Throws kInvalid as environment::CheckCloud and
// ReadModelMeta, kNotFound or kIo when it cannot be read.
ModelFileFacts ReadModelFile(const std::filesystem::path& file, const std::string& file_name);

}  // namespace lares::objects
