#include <filesystem>

#include "base/error.h"
#include "base/hash.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/scope.h"
#include "server/http/media_type.h"
#include "server/http/multipart.h"

namespace lares::api {
namespace {

// Nothing that a browser would run in our name.
bool IsHarmless(const std::string& media_type) {
  return media_type.find("html") == std::string::npos &&
         media_type.find("javascript") == std::string::npos && !media_type.starts_with("image/svg");
}

std::string TypeOf(const store::BlobUse& use, const std::string& file_name) {
  const std::string by_name = http::MediaTypeOfFile(file_name);
  if (by_name != "application/octet-stream" && IsHarmless(by_name)) return by_name;
  return use.media_type;
}

http::Response GetBlob(const http::Request& request, const store::Store& store) {
  const std::string& sha256 = request.Param("sha256");
  std::vector<store::BlobUse> uses = store.BlobUses(sha256);
  // What only environments have that the caller's token does not reach is as if it were not here.
  std::erase_if(uses, [&](const store::BlobUse& use) {
    if (!use.environment.empty()) return !Reaches(request, use.environment);
    return use.document_kind == store::ToString(store::DocumentKind::kQuarantined) &&
           !MaySee(request, store::DocumentKind::kQuarantined, use.document);
  });
  if (uses.empty()) {
    throw Error(Code::kNotFound, "nothing here has the SHA-256 '" + sha256.substr(0, 80) + "'");
  }
  const std::string name = http::SafeFileName(request.Query("name").value_or(""));
  const std::filesystem::path path = store.BlobPath(sha256);
  const store::Blob blob{sha256, std::filesystem::file_size(path)};
  http::Response response =
      BlobAnswer(store, blob, name.empty() ? uses.front().media_type : TypeOf(uses.front(), name),
                 name.empty() ? uses.front().file_name : name, "\"" + sha256 + "\"");
  response.headers.Set("Cache-Control", "public, max-age=31536000, immutable");
  return response;
}

}  // namespace

void AddBlobRoutes(http::Router& router, Context& context) {
  router.Add({"GET",
              "/v1/blobs/{sha256}",
              "getBlob",
              [&context](const http::Request& request) { return GetBlob(request, context.store); },
              {},
              0});
}

}  // namespace lares::api
