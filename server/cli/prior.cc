#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

const DocumentCommand kPriors{"/v1/priors", "prior", "FILE",
                              [](const Json& item) { return TextOf(item, "file_name"); }};

}  // namespace

void AddPrior(CLI::App& app, const Options& options) {
  auto* prior = AddCommand(app, "prior", "Tables of where things usually are",
                           "  lares prior import locations.rdf --format omics\n"
                           "  lares prior list");
  prior->require_subcommand(1);

  auto* import = AddCommand(*prior, "import", "Store a table",
                            "  lares prior import locations.rdf --format omics\n"
                            "  lares prior import home.tsv --format tsv --name my-home");
  auto file = std::make_shared<std::string>();
  auto format = std::make_shared<std::string>();
  auto name = std::make_shared<std::string>();
  import->add_option("FILE", *file)->required();
  import
      ->add_option("--format", *format,
                   "omics: RDF of OMICS statements; tsv: columns object, "
                   "place, count, source")
      ->required()
      ->check(CLI::IsMember({"omics", "tsv"}));
  import->add_option("--name", *name, "its name (default: omics for omics, else the file's stem)");
  import->callback([=, &options] {
    PutOptions put;
  put.files = {*file};
  put.id = name->empty() && *format == "omics" ? "omics" : *name;
  put.query.emplace("format", *format);
  PutDocuments(kPriors, put, options);
});

auto* list = AddCommand(*prior, "list", "List the stored tables", "  lares prior list");
list->callback([&options] { ListDocuments(kPriors, options); });
}  // namespace lares::cli

}  // namespace lares::cli
