#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/time.h"
#include "server/api/layer_files.h"
#include "server/cli/command.h"
#include "server/cli/download.h"
#include "server/cli/print.h"
#include "server/cli/temporary_folder.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

struct GetOptions {
  std::string id;
  std::string version;  // a number or a tag; empty: the newest
  std::vector<std::string> layers;
  std::string out;
  bool offline_ok = false;
  int patience_s = 60;
  std::uint64_t cache_mb = Cache::kUsualBytes >> 20;
};

// An earlier download may be replaced, anything else may not.
void CheckTarget(const fs::path& out) {
  if (!fs::exists(out) || (fs::is_directory(out) && fs::is_empty(out)) ||
      fs::exists(out / api::kManifestFile)) {
    return;
  }
  throw Error(Code::kConflict, "'" + out.string() + "' holds other files")
      .WithHint("name a folder that is new or empty");
}

// A manifest as it was got once, with what asks whether it is still the newest.
struct KnownManifest {
  std::string etag;
  std::string got;  // RFC 3339
  Json manifest;
};

// Where the manifest of a version (a number, or "latest") is kept.
std::string ManifestName(const std::string& server, const std::string& id,
                         const std::string& version) {
  return "versions/" + Sha256Hex(server + "\n" + id).substr(0, 32) + "/" + version + ".json";
}

std::optional<KnownManifest> FindManifest(const std::optional<Cache>& cache,
                                          const std::string& server, const std::string& id,
                                          const std::string& version) {
  const auto text =
      cache ? cache->ReadText(ManifestName(server, id, version)) : std::optional<std::string>();
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains("manifest")) return std::nullopt;
  KnownManifest known{TextOf(json, "etag"), TextOf(json, "got"), json.at("manifest")};
  if (!known.manifest.is_object() || !known.manifest.contains("layers")) return std::nullopt;
  return known;
}

KnownManifest AskForManifest(Remote& remote, const std::string& id, const std::string& version,
                             const std::optional<KnownManifest>& known) {
  http::ClientRequest request{
      "GET", PathOf("/v1/environments", {id, "versions", version}), {}, {}, {}};
  if (known && !known->etag.empty()) request.headers.Set("If-None-Match", known->etag);
  const http::ClientResponse response = remote.Send(request);
  if (response.status == 304) return {known->etag, ToRfc3339(Now()), known->manifest};
  Json manifest = Json::parse(response.body, nullptr, false);
  if (!manifest.is_object() || !manifest.contains("layers")) {
    throw Error(Code::kIo, "what answers at " + remote.url() + " sent no manifest");
  }
  return {std::string(response.headers.Get("ETag")), ToRfc3339(Now()), std::move(manifest)};
}

// Once its layers are kept, so that what is known can be given whole.
void KeepManifest(const Cache& cache, const std::string& server, const std::string& id,
                  const std::string& version, const KnownManifest& known) {
  const std::string text =
      Json{{"etag", known.etag}, {"got", known.got}, {"manifest", known.manifest}}.dump() + "\n";
  cache.KeepText(ManifestName(server, id, version), text);
  cache.KeepText(ManifestName(server, id, std::to_string(known.manifest.value("number", 0))), text);
}

bool IsWanted(const GetOptions& get, const Json& layer) {
  return get.layers.empty() ||
         std::find(get.layers.begin(), get.layers.end(), TextOf(layer, "name")) != get.layers.end();
}

void CheckLayers(const GetOptions& get, const Json& manifest) {
  for (const std::string& wanted : get.layers) {
    const auto& layers = manifest.at("layers");
    if (std::none_of(layers.begin(), layers.end(),
                     [&](const Json& layer) { return TextOf(layer, "name") == wanted; })) {
      throw Error(Code::kNotFound, "version " + std::to_string(manifest.value("number", 0)) +
                                       " of " + get.id + " has no layer '" + wanted + "'");
    }
  }
}

// The wanted layers, each saved by `save(layer, folder)`, and the manifest take the target's place.
template <typename Save>
Json WriteVersion(const GetOptions& get, Json manifest, const Save& save) {
  CheckLayers(get, manifest);
  const fs::path target = TargetFolder(get.out);
  fs::create_directories(target.parent_path());
  const TemporaryFolder temporary(target.parent_path(), ".lares-get-");
  const fs::path folder = temporary.path() / "content";
  fs::create_directory(folder);
  Json kept = Json::array();
  for (Json& layer : manifest.at("layers")) {
    if (!IsWanted(get, layer)) continue;
    layer["file"] = save(layer, folder);
    kept.push_back(layer);
  }
  manifest["layers"] = std::move(kept);
  WriteFileAtomically(folder / api::kManifestFile, manifest.dump(2) + "\n");
  PublishFolder(temporary.path(), target);
  return manifest;
}

Json GetFromServer(const GetOptions& get, const ServerAddress& server, const Getting& getting) {
  Remote remote(server);
  const std::string asked = get.version.empty() ? "latest" : get.version;
  const KnownManifest known = AskForManifest(
      remote, get.id, asked, FindManifest(getting.cache, remote.url(), get.id, asked));
  const std::string version_path =
      PathOf("/v1/environments",
             {get.id, "versions", std::to_string(known.manifest.at("number").get<int>())});
  const Json written =
      WriteVersion(get, known.manifest, [&](const Json& layer, const fs::path& folder) {
        return SaveLayer(remote, version_path, layer, folder, getting);
      });
  if (!getting.cache) return written;
  KeepManifest(*getting.cache, remote.url(), get.id, asked, known);
  std::set<std::string> in_use;
  for (const Json& layer : written.at("layers")) in_use.insert(TextOf(layer, "sha256"));
  getting.cache->Trim(get.cache_mb << 20, in_use);
  return written;
}

// The version that was got last, for a robot that cannot reach the server now.
Json GetFromCache(const GetOptions& get, const ServerAddress& server, const Getting& getting,
                  http::ConnectionError& fault) {
  const std::string asked = get.version.empty() ? "latest" : get.version;
  const auto known = FindManifest(getting.cache, Remote(server).url(), get.id, asked);
  if (!known) {
    fault.WithHint("and no version of " + get.id + " was got from it before");
    throw;
  }
  Json written = WriteVersion(get, known->manifest, [&](const Json& layer, const fs::path& folder) {
    return SaveCachedLayer(*getting.cache, layer, folder);
  });
  const auto got = FromRfc3339(known->got);
  std::fprintf(stderr, "lares: %s; this is version %d of %s as it was got %s\n", fault.what(),
               written.value("number", 0), get.id.c_str(),
               got ? ToAge(*got, Now()).c_str() : "before");
  written["offline"] = true;
  return written;
}

std::string Summary(const GetOptions& get, const Json& manifest) {
  std::string text = "environment " + get.id + ", version " +
                     std::to_string(manifest.value("number", 0)) + ", in " + get.out + "\n";
  for (const Json& layer : manifest.at("layers")) {
    text += "  " + TextOf(layer, "file") + "  " +
            FormatBytes(layer.value("size", std::uint64_t{0})) + "\n";
  }
  return text + "  " + api::kManifestFile + "\n";
}

void Get(const GetOptions& get, const Options& options) {
  CheckTarget(TargetFolder(get.out));
  Getting getting;
  getting.patience = std::chrono::seconds(get.patience_s);
  if (get.cache_mb == 0) getting.cache.reset();
  const StopOnSignal stop_on_signal;
  Json manifest;
  try {
    manifest = GetFromServer(get, options.server, getting);
  } catch (http::ConnectionError& error) {
    if (!get.offline_ok || IsAskedToStop()) throw;
    manifest = GetFromCache(get, options.server, getting, error);
  }
  if (options.json) return PrintJson(manifest);
  Print(Summary(get, manifest));
}

}  // namespace

void AddEnvironmentGet(CLI::App& environment, const Options& options) {
  auto* command =
      AddCommand(environment, "get", "Download a version's layers and manifest into a folder",
                 "  lares environment get hospital-room --out room\n"
                 "  lares environment get hospital-room --version 1 --layer octomap --out room\n"
                 "  lares environment get hospital-room --offline-ok --out room");
  auto get = std::make_shared<GetOptions>();
  command->add_option("ID", get->id)->required();
  command->add_option("--version", get->version, "a number or a tag; default: the newest");
  command->add_option("--layer", get->layers, "only this one; may be repeated");
  command->add_option("--out", get->out, "folder to write; appears whole or not at all")
      ->required();
  command->add_flag(
      "--offline-ok", get->offline_ok,
      "when the server cannot be reached, give the version that was got last, and say "
      "so");
  command
      ->add_option("--patience", get->patience_s,
                   "seconds to try again after the connection broke; the download goes on where it "
                   "stopped")
      ->check(CLI::Range(0, 86400))
      ->capture_default_str();
  command
      ->add_option("--cache-mb", get->cache_mb,
                   "what the cache (~/.cache/lares) may hold afterwards; 0: use none")
      ->capture_default_str();
  command->callback([=, &options] { Get(*get, options); });
}

}  // namespace lares::cli
