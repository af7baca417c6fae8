#include "server/knowledge/thumbnails.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "mapping/environment/byte_reader.h"
#include "mapping/environment/tar_reader.h"
#include "mapping/grid/read_grid.h"
#include "mapping/picture/plan_picture.h"
#include "mapping/picture/png.h"
#include "mapping/volume/cut.h"

namespace lares::server {
namespace {

const store::LayerInfo* FindLayer(const store::EnvironmentVersion& version,
                                  const std::string& name) {
  const auto found = std::find_if(version.layers.begin(), version.layers.end(),
                                  [&](const auto& layer) { return layer.name == name; });
  return found == version.layers.end() ? nullptr : &*found;
}

std::optional<grid::Grid> GridOf(const store::Store& store,
                                 const store::EnvironmentVersion& version) {
  try {
    if (const store::LayerInfo* layer = FindLayer(version, "grid")) {
      const std::filesystem::path file = store.BlobPath(layer->blob.sha256);
      return grid::ReadGrid([&] { return environment::TarReader::OfFile(file, layer->file_name); },
                            layer->file_name);
    }
    if (const store::LayerInfo* layer = FindLayer(version, "octomap")) {
      const std::filesystem::path file = store.BlobPath(layer->blob.sha256);
      return volume::CutOctomap(
                 [&] { return environment::ByteReader::OfFile(file, layer->file_name); }, {})
          .grid;
    }
  } catch (const Error& error) {
    const bool is_of_the_layer = error.code() == Code::kInvalid || error.code() == Code::kTooLarge;
    if (!is_of_the_layer) throw;
  }
  return std::nullopt;
}

}  // namespace

std::string DrawThumbnail(Knowledge& knowledge, const store::EnvironmentVersion& version,
                          std::uint32_t size_px) {
  const std::optional<grid::Grid> grid = GridOf(knowledge.store(), version);
  return picture::ToPng(picture::DrawPlan(grid ? &*grid : nullptr,
                                          knowledge.MapObjects(version.environment, version.number),
                                          {size_px}));
}

}  // namespace lares::server
