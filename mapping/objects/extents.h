// How large the object of a model is, out of its files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mapping/objects/model_file.h"

namespace lares::objects {

struct Extents {
  std::array<double, 3> size_m{};  // along x, y, z of the model's frame
  // Whether x is the width, y the height and z the depth, as a meta.xml has it.
  bool axes_known = false;
  std::string from;  // "meta.xml", "the points of drawing_model.ply"
};

struct NamedFacts {
  std::string file_name;
  ModelFileFacts facts;
};

// The size that a meta.xml states; otherwise the box around the points: of all clouds of a model
// with a meta.xml (they share its frame), or of the only cloud that has points. Nothing when
// several clouds have points and nothing says that they share a frame, or none has any. Points are
// taken to be in metres, unless a meta.xml gives a scale.
std::optional<Extents> FindExtents(const std::vector<NamedFacts>& files);

}  // namespace lares::objects
