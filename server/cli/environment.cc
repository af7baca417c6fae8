#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr const char* kCollection = "/v1/environments";

void ListEnvironments(const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(kCollection);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) return Print("no environment is stored\n");
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list.at("items")) {
    rows.push_back({TextOf(item, "id"), std::to_string(item.value("latest", 0)),
                    std::string(LocalName(TextOf(item, "type"))),
                    FormatTime(TextOf(item, "created")), TextOf(item, "label")});
  }
  Print(FormatTable({"ID", "VERSION", "TYPE", "CREATED", "LABEL"}, rows));
}

std::string FormatVersion(const Json& version) {
  std::string text = "version " + std::to_string(version.value("number", 0)) + "  " +
                     FormatTime(TextOf(version, "created"));
  const std::string author = TextOf(version, "author");
  const std::string note = TextOf(version, "note");
  if (!author.empty()) text += "  by " + author;
  text += "\n";
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
  auto* list = AddCommand(*environment, "list", "List environments", "  lares environment list");
  list->callback([&options] { ListEnvironments(options); });
  auto* log = AddCommand(*environment, "log", "All versions, newest first",
                         "  lares environment log hospital-room");
  auto id = std::make_shared<std::string>();
  log->add_option("ID", *id)->required();
  log->callback([=, &options] { ShowLog(*id, options); });
}

}  // namespace lares::cli
