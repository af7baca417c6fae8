#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

const DocumentCommand kModules{"/v1/ontology/modules", "ontology", "",
                               [](const Json&) { return std::string(); }};

void ListModules(const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(kModules.collection);
  if (options.json) return PrintJson(list);
  std::vector<std::vector<std::string>> rows;
  for (const Json& module : list.at("items")) {
    rows.push_back({TextOf(module, "id"), TextOf(module, "origin"),
                    std::to_string(module.value("statements", std::size_t{0}))});
  }
  Print(FormatTable({"ID", "ORIGIN", "STATEMENTS"}, rows));
}

void ListAliases(const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList("/v1/ontology/aliases");
  if (options.json) return PrintJson(list);
  std::vector<std::vector<std::string>> rows;
  for (const Json& alias : list.at("items")) {
    rows.push_back({TextOf(alias, "alias"), TextOf(alias, "canonical"), TextOf(alias, "reason")});
  }
  Print(FormatTable({"ALIAS", "MEANS", "BECAUSE"}, rows));
}

}  // namespace

void AddOntology(CLI::App& app, const Options& options) {
  auto* ontology = AddCommand(app, "ontology", "The vocabulary and its modules",
                              "  lares ontology put knowrob.owl\n  lares ontology aliases");
  ontology->require_subcommand(1);
  AddDocumentCommands(*ontology, kModules, options, "knowrob.owl");
  ontology->get_subcommand("list")->callback([&options] { ListModules(options); });
  AddOntologyConvert(*ontology);
  AddOntologyCheck(*ontology, options);
  auto* aliases = AddCommand(*ontology, "aliases", "Historic names and what they mean here",
                             "  lares ontology aliases\n  lares ontology aliases --json");
  aliases->callback([&options] { ListAliases(options); });
}

}  // namespace lares::cli
