#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/documents.h"
#include "server/cli/print.h"

namespace lares::cli {

std::string NamesOf(const Json& document) {
  std::vector<std::string> labels;
  std::vector<std::string> locals;
  for (const Json& name : document.value("names", Json::array())) {
    if (TextOf(name, "kind") == "label") labels.push_back(TextOf(name, "text"));
    if (TextOf(name, "kind") == "iri") locals.emplace_back(LocalName(TextOf(name, "text")));
  }
  std::vector<std::string>& names = labels.empty() ? locals : labels;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return Join(names, ", ");
}

void AddRecipe(CLI::App& app, const Options& options) {
  auto* recipe = AddCommand(
      app, "recipe", "Action recipes: what is to be done",
      "  lares recipe put search.owl\n  lares recipe list\n  lares recipe robots FindBottle");
  recipe->require_subcommand(1);
  AddDocumentCommands(*recipe, {"/v1/recipes", "recipe", "TASKS", NamesOf}, options, "search.owl");
  AddRecipeRobots(*recipe, options);
}

}  // namespace lares::cli
