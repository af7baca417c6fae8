// Which stored robots can do a recipe, and what the others lack.
#include <nlohmann/json.hpp>

#include "server/api/answers.h"
#include "server/api/recipe_robots.h"

namespace lares::api {
namespace {

Json ItemToJson(const recipes::RepairItem& item) {
  Json json{{"what", ToJson(item.what)}, {"cost", item.cost}, {"text", item.text}};
  for (const recipes::Measure& bound : item.bounds) {
    Json limits{{"quantity", ToJson(bound.quantity)}, {"unit", bound.unit}};
    if (bound.at_least) limits["at_least"] = *bound.at_least;
    if (bound.at_most) limits["at_most"] = *bound.at_most;
    json["bounds"].push_back(std::move(limits));
  }
  return json;
}

}  // namespace

Json ToJson(const server::RobotRank& robot) {
  const recipes::RankedRobot& ranked = robot.ranked;
  Json json{{"id", robot.document},
            {"robot", ToJson(ranked.robot)},
            {"feasible", ranked.feasible},
            {"cost", ranked.cost ? Json(*ranked.cost) : Json(nullptr)},
            {"add", Json::array()},
            {"repair_is_smallest", ranked.repair_is_smallest},
            {"downloads", ToJson(ranked.downloads)}};
  for (const recipes::RepairItem& item : ranked.repair.add) json["add"].push_back(ItemToJson(item));
  return json;
}

Json ToJson(const std::vector<server::RobotRank>& robots) {
  Json json = Json::array();
  for (const server::RobotRank& robot : robots) json.push_back(ToJson(robot));
  return json;
}

void AddRecipeRobotRoute(http::Router& router, Context& context) {
  const auto rank = [&context](const http::Request& request) {
    server::RobotsRequest wanted;
    wanted.task = request.Param("id");
    wanted.environment = request.Query("environment").value_or("");
    wanted.strict = QueryFlag(request, "strict");
    const server::RobotsAnswer answer = context.knowledge.RankRobots(wanted);
    return JsonAnswer({{"task", ToJson(answer.task)}, {"robots", ToJson(answer.robots)}});
  };
  router.Add({"GET", "/v1/recipes/{id}/robots", "rankRobots", rank, {}, 0});
}

}  // namespace lares::api
