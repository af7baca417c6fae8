#include <array>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/writer.h"
#include "server/api/answers.h"
#include "server/api/environments.h"
#include "server/api/layer_files.h"
#include "server/api/tar.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"

namespace lares::api {
namespace {

std::string BlobEtag(const store::Blob& blob, const std::string& suffix = "") {
  return "\"" + blob.sha256.substr(0, 32) + suffix + "\"";
}

const store::LayerInfo& FindLayer(const store::EnvironmentVersion& version,
                                  const std::string& name) {
  std::vector<std::string> names;
  for (const store::LayerInfo& layer : version.layers) {
    if (layer.name == name) return layer;
    names.push_back(layer.name);
  }
  throw Error(Code::kNotFound, "version " + std::to_string(version.number) + " of '" +
                                   version.environment + "' has no layer '" + name + "'; it has " +
                                   Join(names, ", "))
      .WithCandidates(SimilarNames(name, names));
}

// How a semantic layer can be given, whatever it was received as.
constexpr rdf::Format kRendered[] = {
    rdf::Format::kTurtle, rdf::Format::kRdfXml, rdf::Format::kTriG,          rdf::Format::kNTriples,
    rdf::Format::kNQuads, rdf::Format::kJsonLd, rdf::Format::kOwlFunctional, rdf::Format::kOwlXml};

http::Response Rendered(const store::EnvironmentVersion& version, const store::LayerInfo& layer,
                        rdf::Format format, Context& context) {
  const std::string extension =
      LayerFileName("", "", rdf::MediaType(format)).substr(1);  // without the dot
  http::Response response;
  response.headers.Set("Content-Type", std::string(rdf::MediaType(format)));
  response.headers.Set("ETag", BlobEtag(layer.blob, "-" + extension));
  response.headers.Set("Content-Disposition", ContentDisposition("semantic." + extension));
  try {
    response.body = context.knowledge.RenderSemantic(version.environment, version.number, format);
  } catch (const Error& error) {
    if (error.code() != Code::kInvalid || !rdf::HoldsOnlyAxioms(format)) throw;
    throw http::ProblemError("not-acceptable", error.what());  // more than the format can say
  }
  return response;
}

// The bytes as received, unless Accept asks for another way to write the same graph.
http::Response SemanticLayer(const http::Request& request, const store::EnvironmentVersion& version,
                             const store::LayerInfo& layer, Context& context) {
  std::vector<std::string> offered{layer.media_type};
  for (const rdf::Format format : kRendered) offered.emplace_back(rdf::MediaType(format));
  const auto chosen = http::ChooseMediaType(request.headers.GetList("Accept"), offered);
  if (!chosen) {
    throw http::ProblemError("not-acceptable",
                             "the semantic layer is given as " + Join(offered, ", "));
  }
  http::Response response;
  if (*chosen == layer.media_type) {
    response = BlobAnswer(context.store, layer.blob, layer.media_type, layer.file_name,
                          BlobEtag(layer.blob));
  } else {
    response = Rendered(version, layer, rdf::GuessFormat(*chosen, "", ""), context);
  }
  response.headers.Set("Vary", "Accept");
  return response;
}

http::Response GetLayer(const http::Request& request, Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  const store::LayerInfo& layer = FindLayer(version, request.Param("name"));
  if (layer.name == "semantic") return SemanticLayer(request, version, layer, context);
  return BlobAnswer(context.store, layer.blob, layer.media_type, layer.file_name,
                    BlobEtag(layer.blob));
}

struct TarFile {
  std::string name;
  std::uint64_t size = 0;
  std::filesystem::path path;  // empty: `text`
  std::string text;
};

std::string Manifest(const store::EnvironmentVersion& version) {
  Json manifest = ToJson(version);
  for (std::size_t i = 0; i < version.layers.size(); ++i) {
    const store::LayerInfo& layer = version.layers[i];
    manifest["layers"][i]["file"] = LayerFileName(layer.name, layer.file_name, layer.media_type);
  }
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<TarFile> TarFiles(const store::EnvironmentVersion& version, const Context& context) {
  std::vector<TarFile> files;
  std::string manifest = Manifest(version);
  files.push_back({kManifestFile, manifest.size(), {}, std::move(manifest)});
  for (const store::LayerInfo& layer : version.layers) {
    files.push_back({LayerFileName(layer.name, layer.file_name, layer.media_type), layer.blob.size,
                     context.store.BlobPath(layer.blob.sha256), ""});
  }
  return files;
}

void SendFile(const TarFile& entry, const http::Sink& sink) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(entry.path.c_str(), "rb"),
                                                             &std::fclose);
  std::array<char, 64 * 1024> piece;
  for (std::uint64_t left = entry.size; left > 0;) {
    const std::size_t wanted = std::min<std::uint64_t>(piece.size(), left);
    const std::size_t got = file ? std::fread(piece.data(), 1, wanted, file.get()) : 0;
    if (got == 0) throw Error(Code::kIo, "cannot read '" + entry.path.string() + "'");
    sink({piece.data(), got});
    left -= got;
  }
}

http::Response GetTar(const http::Request& request, Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  std::vector<TarFile> files = TarFiles(version, context);
  http::StreamBody body;
  body.length = TarEnd().size();
  for (const TarFile& file : files) body.length += TarEntrySize(file.size);
  body.produce = [files = std::move(files), created = version.created](const http::Sink& sink) {
    for (const TarFile& file : files) {
      sink(TarHeader(file.name, file.size, created));
      if (file.path.empty()) {
        sink(file.text);
      } else {
        SendFile(file, sink);
      }
      sink(TarPadding(file.size));
    }
    sink(TarEnd());
  };
  http::Response response;
  response.headers.Set("Content-Type", "application/x-tar");
  response.headers.Set(
      "ETag", "\"" + version.environment + "-" + std::to_string(version.number) + "-tar\"");
  response.headers.Set(
      "Content-Disposition",
      ContentDisposition(version.environment + "-" + std::to_string(version.number) + ".tar"));
  response.body = std::move(body);
  return response;
}

}  // namespace

void AddEnvironmentDownloadRoutes(http::Router& router, Context& context) {
  router.Add({"GET",
              "/v1/environments/{id}/versions/{number}/layers/{name}",
              "getEnvironmentLayer",
              [&context](const http::Request& request) { return GetLayer(request, context); },
              {},
              0});
  router.Add({"GET",
              "/v1/environments/{id}/versions/{number}.tar",
              "getEnvironmentTar",
              [&context](const http::Request& request) { return GetTar(request, context); },
              {},
              0});
}

}  // namespace lares::api
