#include "mapping/environment/grid_format.h"

#include <cmath>
#include <cstdint>
#include <set>

#include "base/error.h"
#include "mapping/environment/byte_reader.h"
#include "mapping/environment/facts.h"
#include "mapping/environment/map_yaml.h"
#include "mapping/environment/pgm.h"

namespace lares::environment {
namespace {

struct Description {
  std::string path;  // of the YAML in the archive
  std::string text;
};

[[noreturn]] void Fail(const std::string& source, const std::string& message) {
  throw Error(Code::kInvalid, message, Place{source});
}

bool IsYaml(std::string_view path) { return path.ends_with(".yaml") || path.ends_with(".yml"); }

std::string ReadYamlText(TarReader& archive, const std::string& source) {
  std::string text;
  char buffer[4096];
  for (std::size_t count = archive.Read(buffer, sizeof buffer); count > 0;
       count = archive.Read(buffer, sizeof buffer)) {
    text.append(buffer, count);
    if (text.size() > kMaxMapYamlBytes) Fail(source, "the map description is larger than 16 KiB");
  }
  return text;
}

// Looks through the whole archive, so that its damage anywhere is found.
Description FindYaml(TarReader archive, const std::string& name) {
  std::optional<Description> found;
  std::set<std::string> seen;
  while (const std::optional<TarEntry> entry = archive.Next()) {
    if (!seen.insert(entry->path).second) {
      Fail(name, "the archive holds '" + Excerpt(entry->path) + "' twice");
    }
    if (!IsYaml(entry->path)) continue;
    if (found) Fail(name, "the archive holds two YAML files; a grid is one YAML and its PGM");
    found = Description{entry->path, ReadYamlText(archive, name + "/" + entry->path)};
  }
  if (!found) Fail(name, "the archive holds no YAML file; a grid is one YAML and its PGM");
  return *found;
}

// The image's path in the archive: relative to the folder of the YAML, never out of it.
std::string ImagePath(const Description& description, const MapYaml& map,
                      const std::string& source) {
  const std::filesystem::path written(map.image);
  for (const auto& part : written) {
    if (written.is_absolute() || part == "..") {
      Fail(source, "the image '" + Excerpt(map.image) + "' is outside the archive");
    }
  }
  return (std::filesystem::path(description.path).parent_path() / written)
      .lexically_normal()
      .generic_string();
}

PgmHeader ReadImage(TarReader archive, const std::string& path,
                    const std::function<void(double)>& visit, const std::string& name) {
  while (const std::optional<TarEntry> entry = archive.Next()) {
    if (entry->path != path) continue;
    ByteReader reader(
        [&](char* into, std::size_t capacity) { return archive.Read(into, capacity); },
        name + "/" + path);
    return ReadPgm(reader, visit);
  }
  Fail(name, "the archive does not hold the image '" + Excerpt(path) + "' that its YAML names");
}

std::array<double, 6> ToBounds(const MapYaml& map, const PgmHeader& image) {
  const double width_m = image.width * map.resolution_m;
  const double height_m = image.height * map.resolution_m;
  const double cosine = std::cos(map.origin[2]), sine = std::sin(map.origin[2]);
  BoundsBuilder bounds;
  for (const double x_m : {0.0, width_m}) {
    for (const double y_m : {0.0, height_m}) {
      bounds.Add(map.origin[0] + cosine * x_m - sine * y_m,
                 map.origin[1] + sine * x_m + cosine * y_m, 0);
    }
  }
  return *bounds.bounds_m();
}

}  // namespace

GridImage ReadGridImage(const std::function<TarReader()>& open, const std::string& name,
                        const std::function<void(Occupancy)>& visit) {
  const Description description = FindYaml(open(), name);
  const std::string yaml_source = name + "/" + description.path;
  GridImage grid;
  grid.map = ReadMapYaml(description.text, yaml_source);
  grid.image = ReadImage(
      open(), ImagePath(description, grid.map, yaml_source),
      [&](double grey) { visit(OccupancyOf(grid.map, grey)); }, name);
  return grid;
}

LayerFacts CheckGrid(const std::function<TarReader()>& open, const std::string& name) {
  std::uint64_t occupied = 0, free = 0;
  const auto [map, image] = ReadGridImage(open, name, [&](Occupancy cell) {
    if (cell == Occupancy::kOccupied) ++occupied;
    if (cell == Occupancy::kFree) ++free;
  });
  constexpr const char* kModes[] = {"trinary", "scale", "raw"};
  LayerFacts facts;
  facts.media_type = "application/x-tar";
  facts.facts = {{"resolution_m", ToText(map.resolution_m)},
                 {"width_px", std::to_string(image.width)},
                 {"height_px", std::to_string(image.height)},
                 {"mode", kModes[static_cast<std::size_t>(map.mode)]},
                 {"occupied_cells", std::to_string(occupied)},
                 {"free_cells", std::to_string(free)}};
  facts.bounds_m = ToBounds(map, image);
  return facts;
}

}  // namespace lares::environment
