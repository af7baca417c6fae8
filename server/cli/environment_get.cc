#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
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
  int version = 0;
  std::vector<std::string> layers;
  std::string out;
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

void Get(const GetOptions& get, const Options& options) {
  Remote remote(options.server);
  const fs::path target = TargetFolder(get.out);
  CheckTarget(target);
  const std::string asked = get.version > 0 ? std::to_string(get.version) : "latest";
  Json manifest = remote.GetJson(PathOf("/v1/environments", {get.id, "versions", asked}));
  const std::string version_path = PathOf(
      "/v1/environments", {get.id, "versions", std::to_string(manifest.at("number").get<int>())});
  Json kept = Json::array();
  const StopOnSignal stop_on_signal;
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
  PublishFolder(temporary.path(), target);
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
