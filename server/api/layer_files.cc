#include "server/api/layer_files.h"

#include <filesystem>

#include "base/text.h"

namespace lares::api {
namespace {

std::string UsualExtension(std::string_view layer, std::string_view media_type) {
  if (media_type == "application/rdf+xml") return ".owl";
  if (media_type == "text/turtle") return ".ttl";
  if (media_type == "application/trig") return ".trig";
  if (media_type == "application/n-triples") return ".nt";
  if (media_type == "application/n-quads") return ".nq";
  if (media_type == "text/owl-functional") return ".ofn";
  if (media_type == "application/owl+xml") return ".owx";
  if (media_type == "application/ld+json") return ".jsonld";
  if (layer == "octomap") return ".bt";
  if (layer == "grid") return ".tar";
  if (layer == "cloud") return ".ply";
  if (layer == "trajectory") return ".txt";
  return ".bin";
}

}  // namespace

std::string LayerFileName(std::string_view layer, std::string_view uploaded_as,
                          std::string_view media_type) {
  std::string extension = ToLower(std::filesystem::path(uploaded_as).extension().string());
  const bool sensible = extension.size() >= 2 && extension.size() <= 8 &&
                        IsIdentifier(std::string_view(extension).substr(1));
  if (!sensible || layer == "grid") extension = UsualExtension(layer, media_type);
  return std::string(layer) + extension;
}

}  // namespace lares::api
