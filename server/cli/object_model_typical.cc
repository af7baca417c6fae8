#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/download.h"
#include "server/cli/plan_package.h"
#include "server/cli/print.h"
#include "server/cli/temporary_folder.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

std::string FormatModels(const Json& models) {
  std::string text;
  for (const Json& model : models) {
    text += "  " + TextOf(model, "id") + "  " + FormatPercent(model.value("probability", 0.0)) +
            ", " + FormatBytes(model.value("size_bytes", std::uint64_t{0})) + "\n    " +
            TextOf(model, "why") + "\n";
  }
  return text;
}

std::string Format(const Json& answer) {
  const Json& loaded = answer.at("loaded");
  const Json& robot = answer.at("robot");
  const std::string room = TextOf(answer.at("room"), "label");
  std::string text = "for " + room + (robot.is_null() ? "" : " and " + TextOf(robot, "label")) +
                     ", by table '" + TextOf(answer.at("prior"), "name") + "'";
  if (answer.value("places_above", false)) {
    text += ", which counts " + TextOf(answer.at("places").at(0), "label") + " only";
  }
  text += ": " + Plural(loaded.size(), "model") + ", " +
          FormatBytes(answer.value("size_bytes", std::uint64_t{0})) + "\n" + FormatModels(loaded);
  const Json& left_out = answer.at("left_out");
  if (!left_out.empty()) text += "left out:\n" + FormatModels(left_out);
  return text;
}

// A file name of the server's is a name, never a path.
std::string PlainName(const std::string& name) {
  if (name.empty() || name == "." || name == ".." || fs::path(name).filename() != name) {
    throw Error(Code::kIo, "the server names a file '" + name + "'");
  }
  return name;
}

void SaveModel(Remote& remote, const Json& model, const fs::path& folder) {
  const std::string id = TextOf(model, "id");
  if (!IsIdentifier(id)) throw Error(Code::kIo, "the server names a model '" + id + "'");
  fs::create_directories(folder / id);
  for (const Json& file : model.at("files")) {
    const std::string name = PlainName(TextOf(file, "file_name"));
    if (fs::exists(folder / id / name)) {
      throw Error(Code::kIo, "object model " + id + " has two files '" + name + "'");
    }
    const std::string link = TextOf(file, "link");
    Wanted wanted{id + "/" + name, link.substr(0, link.find('?')), {}, TextOf(file, "sha256")};
    if (link.find("?version=") != std::string::npos) {
      wanted.query.emplace("version", std::to_string(model.value("version", 0)));
    }
    Download(remote, wanted, folder / id / name);
  }
}

// ID/… of each model that is loaded, and the choice itself as typical.json.
void Save(Remote& remote, const Json& answer, const std::string& out) {
  CheckPackageFolder(out);
  const fs::path target = TargetFolder(out);
  const StopOnSignal stop_on_signal;
  fs::create_directories(target.parent_path());
  const TemporaryFolder temporary(target.parent_path(), ".lares-models-");
  const fs::path content = temporary.path() / "content";
  fs::create_directory(content);
  for (const Json& model : answer.at("loaded")) SaveModel(remote, model, content);
  WriteFileAtomically(content / "typical.json", answer.dump(2) + "\n");
  CheckPackageFolder(out);  // nobody else filled it meanwhile
  PublishFolder(temporary.path(), target);
}

}  // namespace

void AddObjectModelTypical(CLI::App& model, const Options& options) {
  auto* typical = AddCommand(
      model, "typical", "The stored models that are worth loading for a kind of room, and why",
      "  lares object-model typical HospitalRoom\n"
      "  lares object-model typical HospitalRoom --robot scout --max-models 5 --download models");
  auto query = std::make_shared<std::map<std::string, std::string>>();
  auto strict = std::make_shared<bool>(false);
  auto out = std::make_shared<std::string>();
  typical->add_option("ROOM", (*query)["room"], "class of the room: name, label or IRI")
      ->required();
  typical->add_option("--robot", (*query)["robot"], "only what this robot's programs can use");
  typical->add_flag("--strict", *strict, "leave out what the robot is not said to have");
  typical->add_option("--prior", (*query)["prior"], "table to answer from (default: our own)");
  typical->add_option("--min-probability", (*query)["min_probability"],
                      "rarer classes are left out (default: 0.01)");
  typical->add_option("--max-models", (*query)["max_models"], "load at most so many");
  typical->add_option("--max-bytes", (*query)["max_bytes"], "load at most so much");
  typical->add_option("--download", *out, "folder that gets their files");
  typical->callback([=, &options] {
    Remote remote(options.server);
    std::multimap<std::string, std::string> given;
    for (const auto& [name, value] : *query) {
      if (!value.empty()) given.emplace(name, value);
    }
    if (*strict) given.emplace("strict", "true");
    const Json answer = remote.GetJson("/v1/object-models/typical", given);
    if (!out->empty()) Save(remote, answer, *out);
    if (options.json) return PrintJson(answer);
    Print(Format(answer) + (out->empty() ? "" : "written to " + *out + "\n"));
  });
}

}  // namespace lares::cli
