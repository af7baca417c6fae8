#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

struct RobotsOptions {
  std::string task;
  std::string environment;
  bool strict = false;
};

std::string Texts(const Json& items, const std::string& name) {
  std::string text;
  for (const Json& item : items) text += (text.empty() ? "" : ", ") + TextOf(item, name);
  return text;
}

std::string CostOf(const Json& robot) {
  if (!robot.contains("cost") || !robot["cost"].is_number()) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%g", robot["cost"].get<double>());
  return text;
}

std::string WhatOf(const Json& robot) {
  const std::string downloads = Texts(robot.value("downloads", Json::array()), "label");
  const std::string with = downloads.empty() ? "" : "downloads " + downloads;
  if (robot.value("feasible", false)) return with;
  if (!robot["cost"].is_number()) return "nothing that could be added makes it able";
  return "add " + Texts(robot.value("add", Json::array()), "text") +
         (with.empty() ? "" : "; " + with);
}

void RankRobots(const RobotsOptions& robots, const Options& options) {
  Remote remote(options.server);
  std::multimap<std::string, std::string> query;
  if (!robots.environment.empty()) query.emplace("environment", robots.environment);
  if (robots.strict) query.emplace("strict", "true");
  const Json answer = remote.GetJson(PathOf("/v1/recipes", {robots.task, "robots"}), query);
  if (options.json) return PrintJson(answer);
  std::vector<std::vector<std::string>> rows;
  for (const Json& robot : answer.at("robots")) {
    rows.push_back({TextOf(robot, "id"), robot.value("feasible", false) ? "yes" : "no",
                    CostOf(robot), WhatOf(robot)});
  }
  if (rows.empty()) return Print("no robot is stored\n");
  Print(FormatTable({"ROBOT", "CAN", "COST", "CHANGE"}, rows));
}

}  // namespace

void AddRecipeRobots(CLI::App& recipe, const Options& options) {
  auto* command =
      AddCommand(recipe, "robots", "The stored robots by how little they lack for a task",
                 "  lares recipe robots FindBottle\n"
                 "  lares recipe robots FindBottle --environment hospital-room --json");
  auto robots = std::make_shared<RobotsOptions>();
  command->add_option("task", robots->task, "Recipe or task: id, IRI or name")->required();
  command->add_option("--environment", robots->environment,
                      "Maps of this environment are on offer");
  command->add_flag("--strict", robots->strict, "What only the maker claims counts as missing");
  command->callback([robots, &options] { RankRobots(*robots, options); });
}

}  // namespace lares::cli
