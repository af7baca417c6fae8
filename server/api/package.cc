#include "server/api/package.h"

#include <nlohmann/json.hpp>

#include "server/http/url.h"

namespace lares::api {
namespace {

using nlohmann::json;

std::string Link(const std::string& collection, const std::vector<std::string>& segments) {
  std::string link = collection;
  for (const std::string& segment : segments) link += "/" + http::PercentEncode(segment);
  return link;
}

json FileToJson(const std::string& file_name, const std::string& media_type, std::uint64_t size,
                const std::string& sha256, const std::string& link) {
  return {{"file_name", file_name},
          {"media_type", media_type},
          {"size", size},
          {"sha256", sha256},
          {"link", link}};
}

json ModelToJson(const server::PackageModel& model) {
  const store::DocumentInfo& document = model.document;
  const std::string link = Link("/v1/object-models", {document.id});
  json files = json::array();
  files.push_back(FileToJson(document.file_name.empty() ? document.id : document.file_name,
                             document.media_type, document.blob.size, document.blob.sha256,
                             link + "?version=" + std::to_string(document.version)));
  for (const server::PackageFile& file : model.files) {
    files.push_back(FileToJson(file.file_name, file.media_type, file.blob.size, file.blob.sha256,
                               Link(link + "/files", {file.file_name})));
  }
  json classes = json::array();
  for (const recipes::Resource& of : model.classes) {
    classes.push_back({{"iri", of.iri}, {"label", of.label}});
  }
  return {{"id", document.id},
          {"version", document.version},
          {"classes", std::move(classes)},
          {"reasons", model.reasons},
          {"files", std::move(files)}};
}

json GridToJson(const server::RobotGrid& grid, const std::string& link) {
  json heights = nullptr;
  if (grid.heights_m) heights = *grid.heights_m;
  return {{"yaml", FileToJson(server::kGridYamlFile, "application/yaml", grid.yaml.size(),
                              grid.yaml_sha256, Link(link, {server::kGridYamlFile}))},
          {"image", FileToJson(server::kGridImageFile, "image/x-portable-graymap", grid.pgm.size(),
                               grid.pgm_sha256, Link(link, {server::kGridImageFile}))},
          {"layer", grid.layer},
          {"layer_sha256", grid.layer_sha256},
          {"inflated_by_m", grid.radius_m},
          {"heights_m", std::move(heights)},
          {"resolution_m", grid.resolution_m},
          {"width", grid.width},
          {"height", grid.height},
          {"bounds_m", grid.bounds_m},
          {"cells",
           {{"occupied", grid.cells.occupied},
            {"free", grid.cells.free},
            {"unknown", grid.cells.unknown}}}};
}

}  // namespace

json ToJson(const server::TaskPackage& package) {
  json value = {{"format", "lares-package"},
                {"format_version", 1},
                {"robot", package.robot},
                {"environment", nullptr},
                {"grid", nullptr},
                {"layers", json::array()},
                {"reasons", package.reasons},
                {"object_models", json::array()}};
  for (const server::PackageModel& model : package.models) {
    value["object_models"].push_back(ModelToJson(model));
  }
  if (package.grid == nullptr) value["no_grid"] = package.no_grid;
  if (package.environment.empty()) return value;
  value["environment"] = {{"id", package.environment}, {"version", package.environment_version}};
  const std::string version =
      Link("/v1/environments",
           {package.environment, "versions", std::to_string(package.environment_version)});
  if (package.grid != nullptr) {
    value["grid"] = GridToJson(*package.grid, Link(version + "/robot-grid", {package.robot}));
  }
  for (const store::LayerInfo& layer : package.layers) {
    json entry = FileToJson(layer.file_name, layer.media_type, layer.blob.size, layer.blob.sha256,
                            Link(version + "/layers", {layer.name}));
    entry["name"] = layer.name;
    entry["facts"] = layer.facts;
    value["layers"].push_back(std::move(entry));
  }
  return value;
}

}  // namespace lares::api
