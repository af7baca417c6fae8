// The layers of an environment: what each may be, and the check that it is that.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lares::environment {

// semantic, features, octomap, grid, cloud, trajectory
bool IsLayerName(std::string_view name);
const std::vector<std::string>& LayerNames();

// What a check found out about a layer's file.
struct LayerFacts {
  std::string media_type;
  std::map<std::string, std::string> facts;       // "resolution_m": "0.08", "objects": "6"
  std::optional<std::array<double, 6>> bounds_m;  // min x y z, max x y z
};

// Reads the whole file in constant memory where the format allows and says what it is. Throws
// kInvalid with file, line or byte offset when it is not what layer `name` must be; kUnsupported
// for an unknown layer name; kNotFound or kIo when the file cannot be read. `semantic` is only
// recognised as RDF here: its content is checked by the knowledge. octomap: .bt/.ot, every node
// read, size as the header says. grid: a tar or YAML+PGM pair as one tar (map_server YAML naming
// the PGM). cloud: PLY header and byte count, finite coordinates. trajectory: TUM rows, unit
// quaternions, rising times. features: any bytes.
LayerFacts CheckLayer(std::string_view name, const std::filesystem::path& file,
                      std::string_view file_name);

// One sentence for each two layers whose bounds can hardly be of one place: on the floor plan one
// is more than three times and 8 m longer than the other (but a trajectory may be short), or they
// lie more than 1 m apart. Layers without bounds are passed over; give `semantic` the bounds of its
// map objects (semantic::BoundsOf).
std::vector<std::string> WarnOnExtents(const std::map<std::string, LayerFacts>& layers);

}  // namespace lares::environment
