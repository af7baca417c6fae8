#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/api/layer_files.h"
#include "server/cli/command.h"
#include "server/cli/grid_files.h"
#include "server/cli/print.h"
#include "server/cli/progress.h"
#include "server/cli/temporary_folder.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

struct GetOptions {
  std::string id;
  int version = 0;
  std::vector<std::string> layers;
  std::string out;
};

// One layer into `file`, streamed, its hash checked.
void Download(Remote& remote, const std::string& path, const Json& layer, const fs::path& file) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  Sha256 hash;
  ProgressBar bar("receiving " + TextOf(layer, "name"));
  http::Transfer transfer;
  transfer.downloaded = [&bar](std::uint64_t done, std::uint64_t all) { bar.Show(done, all); };
  transfer.sink = [&](std::string_view piece) {
    hash.Update(piece);
    out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
    if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  };
  remote.Send({"GET", path, {}, {}, {}}, transfer);
  out.close();
  if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  if (hash.FinishHex() != TextOf(layer, "sha256")) {
    throw Error(Code::kIo, "layer " + TextOf(layer, "name") +
                               " arrived damaged: its SHA-256 is not the manifest's");
  }
}

// The file's name below the output folder.
std::string SaveLayer(Remote& remote, const std::string& version_path, const Json& layer,
                      const fs::path& folder) {
  const std::string name = TextOf(layer, "name");
  if (!IsIdentifier(name)) throw Error(Code::kIo, "the manifest names a layer '" + name + "'");
  const std::string file_name =
      api::LayerFileName(name, TextOf(layer, "file_name"), TextOf(layer, "media_type"));
  Download(remote, PathOf(version_path + "/layers", {name}), layer, folder / file_name);
  if (name != "grid") return file_name;
  UnpackGrid(folder / file_name, folder / "grid");
  fs::remove(folder / file_name);
  return "grid/";
}

// An earlier download may be replaced, anything else may not.
void CheckTarget(const fs::path& out) {
  if (!fs::exists(out) || (fs::is_directory(out) && fs::is_empty(out)) ||
      fs::exists(out / api::kManifestFile)) {
    return;
  }
  throw Error(Code::kConflict, "'" + out.string() + "' holds other files")
      .WithHint("name a folder that is new or empty");
}

// The finished folder takes the place of `out` in one step.
void Publish(const fs::path& finished, const fs::path& out) {
  const fs::path ready = finished / "content";
  fs::permissions(ready,
                  fs::perms::others_read | fs::perms::others_exec | fs::perms::group_read |
                      fs::perms::group_exec,
                  fs::perm_options::add);
  if (fs::exists(out)) fs::rename(out, finished / "before");
  fs::rename(ready, out);
  SyncFolder(out);
  SyncFolder(finished.parent_path());
}

void Get(const GetOptions& get, const Options& options) {
  Remote remote(options.server);
  const fs::path out = fs::absolute(get.out).lexically_normal();
  const fs::path target = out.has_filename() ? out : out.parent_path();
  CheckTarget(target);
  const std::string asked = get.version > 0 ? std::to_string(get.version) : "latest";
  Json manifest = remote.GetJson(PathOf("/v1/environments", {get.id, "versions", asked}));
  const std::string version_path = PathOf(
      "/v1/environments", {get.id, "versions", std::to_string(manifest.at("number").get<int>())});
  Json kept = Json::array();
  fs::create_directories(target.parent_path());
  const TemporaryFolder temporary(target.parent_path(), ".lares-get-");
  const fs::path folder = temporary.path() / "content";
  fs::create_directory(folder);
  for (const std::string& wanted : get.layers) {
    const auto& layers = manifest.at("layers");
    if (std::none_of(layers.begin(), layers.end(),
                     [&](const Json& layer) { return TextOf(layer, "name") == wanted; })) {
      throw Error(Code::kNotFound, "version " + std::to_string(manifest.value("number", 0)) +
                                       " of " + get.id + " has no layer '" + wanted + "'");
    }
  }
  std::string text;
  for (Json& layer : manifest.at("layers")) {
    const std::string name = TextOf(layer, "name");
    if (!get.layers.empty() &&
        std::find(get.layers.begin(), get.layers.end(), name) == get.layers.end()) {
      continue;
    }
    layer["file"] = SaveLayer(remote, version_path, layer, folder);
    text += "  " + TextOf(layer, "file") + "  " +
            FormatBytes(layer.value("size", std::uint64_t{0})) + "\n";
    kept.push_back(layer);
  }
  manifest["layers"] = std::move(kept);
  WriteFileAtomically(folder / api::kManifestFile, manifest.dump(2) + "\n");
  Publish(temporary.path(), target);
  if (options.json) return PrintJson(manifest);
  Print("environment " + get.id + ", version " + std::to_string(manifest.value("number", 0)) +
        ", in " + get.out + "\n" + text + "  " + api::kManifestFile + "\n");
}

}  // namespace

void AddEnvironmentGet(CLI::App& environment, const Options& options) {
  auto* command =
      AddCommand(environment, "get", "Download a version's layers and manifest into a folder",
                 "  lares environment get hospital-room --out room\n"
                 "  lares environment get hospital-room --version 1 --layer octomap --out room");
  auto get = std::make_shared<GetOptions>();
  command->add_option("ID", get->id)->required();
  command->add_option("--version", get->version, "default: the newest")->check(CLI::PositiveNumber);
  command->add_option("--layer", get->layers, "only this one; may be repeated");
  command->add_option("--out", get->out, "folder to write; appears whole or not at all")
      ->required();
  command->callback([=, &options] { Get(*get, options); });
}

}  // namespace lares::cli
