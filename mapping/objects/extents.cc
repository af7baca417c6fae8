#include "mapping/objects/extents.h"

#include "base/text.h"
#include "mapping/environment/facts.h"

namespace lares::objects {

std::optional<Extents> FindExtents(const std::vector<NamedFacts>& files) {
  const NamedFacts* with_meta = nullptr;
  std::vector<const NamedFacts*> clouds;
  for (const NamedFacts& file : files) {
    if (file.facts.meta && with_meta == nullptr) with_meta = &file;
    if (file.facts.bounds) clouds.push_back(&file);
  }
  if (with_meta != nullptr && with_meta->facts.meta->size) {
    const ModelMeta::Size& size = *with_meta->facts.meta->size;
    return Extents{{size.width_m, size.height_m, size.depth_m}, true, with_meta->file_name};
  }
  if (clouds.empty() || (clouds.size() > 1 && with_meta == nullptr)) return std::nullopt;
  environment::BoundsBuilder box;
  std::vector<std::string> names;
  for (const NamedFacts* cloud : clouds) {
    const auto& bounds = *cloud->facts.bounds;
    box.Add(bounds[0], bounds[1], bounds[2]);
    box.Add(bounds[3], bounds[4], bounds[5]);
    names.push_back(cloud->file_name);
  }
  const double scale = with_meta == nullptr ? 1 : with_meta->facts.meta->scale.value_or(1);
  const auto bounds = *box.bounds_m();
  Extents extents;
  for (int axis = 0; axis < 3; ++axis) {
    extents.size_m[axis] = (bounds[axis + 3] - bounds[axis]) * scale;
  }
  extents.from = "the points of " +
                 (names.size() > 3 ? std::to_string(names.size()) + " files" : Join(names, ", "));
  return extents;
}

}  // namespace lares::objects
