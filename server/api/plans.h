// What the routes about plans share.
#pragma once

#include <string>

#include "server/http/problem.h"
#include "server/knowledge/knowledge.h"

namespace lares::api {

// The JSON object that asks for a plan. Throws for what is none, naming the member.
server::PlanRequest ReadPlanRequest(const std::string& body);

// The answer "no", with everything that explains it.
http::ProblemError Refusal(const server::PlanAnswer& answer);

}  // namespace lares::api
