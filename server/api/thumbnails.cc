#include <nlohmann/json.hpp>

#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/environments.h"
#include "server/knowledge/thumbnails.h"

namespace lares::api {
namespace {

// Of some kilobytes each; the largest have half a megabyte.
constexpr std::size_t kKept = 128;

http::Response GetThumbnail(const http::Request& request, Context& context, TextCache& kept) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  const int size_px = QueryNumber(request, "size", 256, 16, 2048);
  const std::string key =
      version.environment + "-" + std::to_string(version.number) + "-" + std::to_string(size_px);
  http::Response response;
  response.headers.Set("Content-Type", "image/png");
  response.headers.Set("ETag", "\"" + key + "-png\"");
  response.headers.Set("Accept-Ranges", "bytes");
  response.body = *kept.Get(key, [&] {
    return server::DrawThumbnail(context.knowledge, version, static_cast<std::uint32_t>(size_px));
  });
  return response;
}

}  // namespace

void AddThumbnailRoutes(http::Router& router, Context& context) {
  const auto kept = std::make_shared<TextCache>(kKept);
  router.Add({"GET",
              "/v1/environments/{id}/versions/{number}/thumbnail.png",
              "getEnvironmentThumbnail",
              [&context, kept](const http::Request& request) {
                return GetThumbnail(request, context, *kept);
              },
              {},
              0});
}

}  // namespace lares::api
