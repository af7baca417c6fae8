// The grid of an environment for one robot, as map_server's two files.
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/environments.h"

namespace lares::api {
namespace {

http::Response GetGridFile(const http::Request& request, Context& context, bool is_image) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  // The newest is, for a robot that is pinned, the one that it is pinned to.
  const bool is_newest = request.Param("number") == "latest" && !request.Query("as_of");
  const auto grid = context.knowledge.MakeRobotGrid(request.Param("robot"), version.environment,
                                                    is_newest ? 0 : version.number);
  http::Response response;
  response.headers.Set("Content-Type", is_image ? "image/x-portable-graymap" : "application/yaml");
  response.headers.Set(
      "ETag", "\"" + (is_image ? grid->pgm_sha256 : grid->yaml_sha256).substr(0, 32) + "\"");
  response.headers.Set("Accept-Ranges", "bytes");
  response.headers.Set("Content-Disposition", ContentDisposition(is_image ? server::kGridImageFile
                                                                          : server::kGridYamlFile));
  response.body = is_image ? grid->pgm : grid->yaml;
  return response;
}

}  // namespace

void AddRobotGridRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* file, const char* operation, bool is_image) {
    router.Add({"GET",
                std::string("/v1/environments/{id}/versions/{number}/robot-grid/{robot}/") + file,
                operation,
                [&context, is_image](const http::Request& request) {
                  return GetGridFile(request, context, is_image);
                },
                {},
                0});
  };
  add(server::kGridYamlFile, "getRobotGrid", false);
  add(server::kGridImageFile, "getRobotGridImage", true);
}

}  // namespace lares::api
