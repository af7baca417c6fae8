#include "server/cli/plan_package.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "recipes/plan/export.h"
#include "server/cli/download.h"
#include "server/cli/print.h"
#include "server/cli/temporary_folder.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

// A file name of the server's is a name, never a path.
std::string PlainName(const std::string& name) {
  const std::string plain = fs::path(name).filename().string();
  if (plain.empty() || plain == "." || plain == ".." || plain != name) {
    throw Error(Code::kIo, "the package names a file '" + name + "'");
  }
  return plain;
}

Wanted ToWanted(const std::string& what, const Json& file) {
  const std::string link = TextOf(file, "link");
  const std::size_t question = link.find('?');
  Wanted wanted{what, link.substr(0, question), {}, TextOf(file, "sha256")};
  if (question != std::string::npos) {
    const std::string query = link.substr(question + 1);  // one NAME=VALUE
    const std::size_t equals = query.find('=');
    wanted.query.emplace(query.substr(0, equals),
                         equals == std::string::npos ? "" : query.substr(equals + 1));
  }
  return wanted;
}

// Each file's place below the package's folder becomes its member "file".
void SaveModels(Remote& remote, Json& package, const fs::path& folder) {
  for (Json& model : package.at("object_models")) {
    const std::string id = TextOf(model, "id");
    if (!IsIdentifier(id)) throw Error(Code::kIo, "the package names a model '" + id + "'");
    fs::create_directories(folder / "models" / id);
    for (Json& file : model.at("files")) {
      const std::string name = PlainName(TextOf(file, "file_name"));
      const std::string place = "models/" + id + "/" + name;
      if (fs::exists(folder / place)) {
        throw Error(Code::kIo, "object model " + id + " has two files '" + name + "'");
      }
      Download(remote, ToWanted(id + "/" + name, file), folder / place);
      file["file"] = place;
    }
  }
}

void SaveGrid(Remote& remote, Json& package, const fs::path& folder) {
  Json& grid = package.at("grid");
  if (grid.is_null()) return;
  fs::create_directories(folder / "grid");
  for (const char* part : {"yaml", "image"}) {
    const std::string name = PlainName(TextOf(grid.at(part), "file_name"));
    Download(remote, ToWanted(name, grid.at(part)), folder / "grid" / name);
    grid[part]["file"] = "grid/" + name;
  }
}

void SaveLayers(Remote& remote, Json& package, const fs::path& folder) {
  if (package.at("layers").empty()) return;
  const Json& environment = package.at("environment");
  const std::string version_path =
      PathOf("/v1/environments", {TextOf(environment, "id"), "versions",
                                  std::to_string(environment.at("version").get<int>())});
  fs::create_directories(folder / "layers");
  for (Json& layer : package.at("layers")) {
    layer["file"] = "layers/" + SaveLayer(remote, version_path, layer, folder / "layers");
  }
}

void PrintPackage(const Json& package, const std::string& out) {
  std::string text = "wrote " + out + "\n";
  for (const Json& model : package.at("object_models")) {
    text +=
        "  models/" + TextOf(model, "id") + "  " + Plural(model.at("files").size(), "file") + "\n";
  }
  if (!package.at("grid").is_null()) text += "  grid/map.yaml, grid/map.pgm\n";
  for (const Json& layer : package.at("layers")) text += "  " + TextOf(layer, "file") + "\n";
  text += "  plan.json, plan.xml, package.json\nwhy:\n";
  for (const Json& reason : package.at("reasons")) {
    text += "  - " + reason.get<std::string>() + "\n";
  }
  Print(text);
}

}  // namespace

void CheckPackageFolder(const std::string& out) {
  const fs::path target = TargetFolder(out);
  if (!fs::exists(target) || (fs::is_directory(target) && fs::is_empty(target))) return;
  throw Error(Code::kConflict, "'" + target.string() + "' is there already and not empty")
      .WithHint("name a folder that is new or empty");
}

void SavePackage(Remote& remote, const std::string& answer, const std::string& out,
                 const Options& options) {
  CheckPackageFolder(out);
  Json plan = Json::parse(answer);
  Json package = plan.at("package");
  plan.erase("package");
  const fs::path target = TargetFolder(out);
  const StopOnSignal stop_on_signal;
  fs::create_directories(target.parent_path());
  const TemporaryFolder temporary(target.parent_path(), ".lares-package-");
  const fs::path folder = temporary.path() / "content";
  fs::create_directory(folder);
  SaveModels(remote, package, folder);
  SaveGrid(remote, package, folder);
  SaveLayers(remote, package, folder);
  WriteFileAtomically(folder / "plan.json", plan.dump(2) + "\n");
  WriteFileAtomically(folder / "plan.xml",
                      recipes::ToBehaviorTreeXml(recipes::PlanFromJson(nlohmann::json(plan))));
  WriteFileAtomically(folder / "package.json", package.dump(2) + "\n");
  CheckPackageFolder(out);  // nobody else filled it meanwhile
  PublishFolder(temporary.path(), target);
  if (options.json) return PrintJson(package);
  PrintPackage(package, out);
}

}  // namespace lares::cli
