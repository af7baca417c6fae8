#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/environments";

struct FindOptions {
  std::string type, room_number, street, building, level, text, changed_from, changed_until;
  std::vector<std::string> holds, layers;
};

void ListEnvironments(const FindOptions& find, const Options& options) {
  std::multimap<std::string, std::string> query;
  const auto put = [&](const char* name, const std::string& value) {
    if (!value.empty()) query.emplace(name, value);
  };
  put("type", find.type);
  put("room_number", find.room_number);
  put("street", find.street);
  put("building", find.building);
  put("level", find.level);
  put("q", find.text);
  put("changed_from", find.changed_from);
  put("changed_until", find.changed_until);
  for (const std::string& each : find.holds) put("holds", each);
  for (const std::string& each : find.layers) put("layer", each);
  Remote remote(options.server);
  const Json list = remote.GetList(kCollection, query);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) {
    return Print(query.empty() ? "no environment is stored\n" : "no environment is all of that\n");
  }
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    rows.push_back({TextOf(item, "id"), std::to_string(item.value("latest", 0)),
                    std::string(LocalName(TextOf(item, "type"))),
                    FormatTime(TextOf(item, "changed")), TextOf(item, "label")});
  }
  Print(FormatTable({"ID", "VERSION", "TYPE", "CHANGED", "LABEL"}, rows));
}

// What is out of the ordinary: a branch, a merge, a rollback.
std::string Lineage(const Json& version) {
  std::vector<std::string> parents;
  for (const Json& parent : version.at("parents")) {
    parents.push_back(std::to_string(parent.get<int>()));
  }
  const std::string origin = TextOf(version, "origin");
  if (origin == "merge") return "  merge of " + Join(parents, " and ");
  if (origin == "rollback") return "  back to " + std::to_string(version.value("base", 0));
  return version.value("head", true) ? "" : "  branch off " + Join(parents, ", ");
}

std::string FormatVersion(const Json& version) {
  std::string text = "version " + std::to_string(version.value("number", 0)) + "  " +
                     FormatTime(TextOf(version, "created"));
  const std::string author = TextOf(version, "author");
  const std::string note = TextOf(version, "note");
  const std::string robot = TextOf(version, "robot");
  const std::string mission = TextOf(version, "mission");
  if (!author.empty()) text += "  by " + author;
  if (!robot.empty()) text += "  robot " + robot;
  if (!mission.empty()) text += "  mission " + mission;
  text += Lineage(version) + "\n";
  if (!note.empty()) text += "  " + note + "\n";
  const auto changed = version.value("changed_layers", std::vector<std::string>());
  for (const Json& layer : version.at("layers")) {
    const std::string name = TextOf(layer, "name");
    const bool is_new = std::find(changed.begin(), changed.end(), name) != changed.end();
    text += std::string(is_new ? "  * " : "    ") + name + "  " +
            FormatBytes(layer.value("size", std::uint64_t{0})) + "  " + TextOf(layer, "file_name") +
            "\n";
  }
  return text;
}

void ShowLog(const std::string& id, const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(PathOf(kCollection, {id, "versions"}));
  if (options.json) return PrintJson(list);
  std::string text;
  for (const Json& version : list.at("items")) text += FormatVersion(version);
  Print(text + "(* changed in that version)\n");
}

}  // namespace

void AddEnvironment(CLI::App& app, const Options& options) {
  auto* environment = AddCommand(app, "environment", "Rooms and flats, in versions of layers",
                                 "  lares environment put lab --layer semantic=lab.ttl\n"
                                 "  lares environment get lab --out lab");
  environment->require_subcommand(1);
  AddEnvironmentPut(*environment, options);
  AddEnvironmentGet(*environment, options);
  AddEnvironmentRelease(*environment, options);
  AddEnvironmentVersions(*environment, options);
  auto* list = AddCommand(*environment, "list", "Find environments",
                          "  lares environment list\n"
                          "  lares environment list --type Kitchen --holds Cup --level 2\n"
                          "  lares environment list --text 'coffee mach*'");
  auto find = std::make_shared<FindOptions>();
  list->add_option("--type", find->type, "a class of places, subclasses included");
  list->add_option("--holds", find->holds, "a class of objects that is there; may be repeated");
  list->add_option("--layer", find->layers, "a layer that it has; may be repeated");
  list->add_option("--room-number", find->room_number);
  list->add_option("--street", find->street, "a street or a city");
  list->add_option("--building", find->building);
  list->add_option("--level", find->level, "storey");
  list->add_option("--text", find->text, "words that are all there; cof* stands for a beginning");
  list->add_option("--changed-from", find->changed_from, "2026-01-31T12:00:00Z");
  list->add_option("--changed-until", find->changed_until);
  list->callback([=, &options] { ListEnvironments(*find, options); });
  auto* log = AddCommand(*environment, "log", "All versions, newest first",
                         "  lares environment log hospital-room");
  auto id = std::make_shared<std::string>();
  log->add_option("ID", *id)->required();
  log->callback([=, &options] { ShowLog(*id, options); });
}

}  // namespace lares::cli
