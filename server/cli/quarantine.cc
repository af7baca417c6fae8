#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

const DocumentCommand kAside{"/v1/quarantine", "quarantine", "",
                             [](const Json&) { return std::string(); }};

// Lists are short of details: each document is asked for its reason.
void ListAside(const Options& options) {
  Remote remote(options.server);
  const Json list = remote.GetList(kAside.collection);
  if (options.json) return PrintJson(list);
  if (list.at("items").empty()) return Print("nothing is kept aside\n");
  for (const Json& item : list.at("items")) {
    http::ClientRequest request;
    request.path = PathOf(kAside.collection, {TextOf(item, "id")});
    request.query.emplace("as", "info");
    const Json info = Json::parse(remote.Send(request).body);
    const Json& details = info.at("details");
    Print(TextOf(details, "kind") + " " + TextOf(details, "id") + ", received " +
          FormatTime(TextOf(info, "received")) + "\n  " + TextOf(details, "reason") + "\n");
  }
}

}  // namespace

void AddQuarantine(CLI::App& app, const Options& options) {
  auto* quarantine = AddCommand(app, "quarantine", "Documents kept aside: they contradict",
                                "  lares quarantine list\n  lares ontology release my-furniture");
  quarantine->require_subcommand(1);
  auto* list = AddCommand(*quarantine, "list", "What is kept aside, and why",
                          "  lares quarantine list\n  lares quarantine list --json");
  list->callback([&options] { ListAside(options); });

  auto* get = AddCommand(*quarantine, "get", "One of them as it was received",
                         "  lares quarantine get ontology.my-furniture");
  auto id = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  get->add_option("ID", *id, "kind.id, as in ontology.my-furniture or environment.lab")->required();
  get->add_option("--out", *out, "file to write instead of standard output");
  get->callback([=, &options] { GetDocument(kAside, *id, 0, *out, options); });

  auto* remove = AddCommand(*quarantine, "remove", "Forget one of them",
                            "  lares quarantine remove ontology.my-furniture");
  auto ids = std::make_shared<std::vector<std::string>>();
  remove->add_option("ID", *ids, "kind.id, as in ontology.my-furniture")->required();
  remove->callback([=, &options] { RemoveDocuments(kAside, *ids, options); });
}

}  // namespace lares::cli
