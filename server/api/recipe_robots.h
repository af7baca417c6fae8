// Robots as they stand to a recipe.
#pragma once

#include <vector>

#include "server/api/context.h"
#include "server/api/json.h"

namespace lares::api {

Json ToJson(const server::RobotRank& robot);
Json ToJson(const std::vector<server::RobotRank>& robots);

void AddRecipeRobotRoute(http::Router& router, Context& context);

}  // namespace lares::api
