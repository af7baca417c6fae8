// What a robot takes along to carry out a plan: the values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mapping/grid/grid.h"
#include "recipes/resource.h"
#include "server/store/store.h"

namespace lares::server {

struct PackageFile {
  std::string file_name;
  std::string media_type;
  store::Blob blob;
};

// An occupancy grid for one body, as map_server's two files. Immutable.
struct RobotGrid {
  std::string yaml;
  std::string pgm;
  std::string yaml_sha256;
  std::string pgm_sha256;
  std::string layer;  // that it was made from: "octomap" or "grid"
  std::string layer_sha256;
  double radius_m = 0;  // inflated by; 0: not at all
  // The heights that were looked at, in the map frame; nothing when made from a `grid` layer.
  std::optional<std::array<double, 2>> heights_m;
  double resolution_m = 0;
  std::uint32_t width = 0, height = 0;  // cells
  std::array<double, 4> bounds_m{};     // in the map frame: min x, min y, max x, max y
  grid::Counts cells;
  std::vector<std::string> reasons;  // how it was made, and why so
};

inline constexpr const char* kGridYamlFile = "map.yaml";
inline constexpr const char* kGridImageFile = "map.pgm";

struct PackageModel {
  store::DocumentInfo document;            // the description
  std::vector<recipes::Resource> classes;  // what it is a model of
  std::vector<PackageFile> files;          // that came with it
  std::vector<std::string> reasons;        // why it is wanted
};

struct TaskPackage {
  std::string robot;        // as the grid's route names it: the document's id or the robot's IRI
  std::string environment;  // id; empty for none
  int environment_version = 0;
  std::vector<PackageModel> models;       // by id
  std::shared_ptr<const RobotGrid> grid;  // null when there is none
  std::string no_grid;                    // why there is none
  std::vector<store::LayerInfo> layers;   // of the environment's version
  std::vector<std::string> reasons;       // what was decided, and why
};

}  // namespace lares::server
