#include "recipes/plan/diff.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "recipes/plan/export.h"
#include "server/api/context.h"
#include "server/api/json_body.h"
#include "server/api/plans.h"
#include "server/api/scope.h"
#include "server/http/media_type.h"

namespace lares::api {
namespace {

using PlainJson = nlohmann::json;

constexpr std::uint64_t kMaxDiffRequest = 16u << 20;

// A plan is taken as it is; anything else asks for one.
recipes::Plan ReadOrMakePlan(const PlainJson& side, const http::Request& request,
                             Context& context) {
  if (side.is_object() && side.contains("format")) return recipes::PlanFromJson(side);
  const server::PlanRequest asked = ReadPlanRequest(side.dump());
  CheckReach(request, asked.environment);
  server::PlanAnswer answer = context.knowledge.MakePlan(asked);
  if (!answer.result.plan) throw Refusal(answer);
  return *std::move(answer.result.plan);
}

// Every fault says which side it is of.
recipes::Plan PlanOf(const PlainJson& sides, const std::string& name, const http::Request& request,
                     Context& context) {
  if (!sides.contains(name)) throw Error(Code::kInvalid, "'" + name + "' is missing");
  try {
    return ReadOrMakePlan(sides[name], request, context);
  } catch (const http::ProblemError&) {
    throw;  // of a plan that cannot be made: it names task and robot
  } catch (const Error& error) {
    Error of_side(error.code(), "plan " + name + ": " + error.what());
    throw of_side.WithHint(error.hint()).WithCandidates(error.candidates());
  }
}

bool WantsText(const http::Request& request) {
  if (const auto as = request.Query("as")) {
    if (*as == "json" || *as == "text") return *as == "text";
    throw Error(Code::kInvalid, "?as= is json or text, not '" + *as + "'");
  }
  const auto chosen =
      http::ChooseMediaType(request.headers.GetList("Accept"), {"application/json", "text/plain"});
  if (!chosen) {
    throw http::ProblemError("not-acceptable",
                             "a comparison is given as application/json or text/plain");
  }
  return *chosen == "text/plain";
}

http::Response Compare(const http::Request& request, Context& context) {
  const bool text = WantsText(request);
  const PlainJson sides = ReadJsonObject(http::ReadWholeBody(request, kMaxDiffRequest), {"a", "b"});
  const recipes::Plan a = PlanOf(sides, "a", request, context);
  const recipes::Plan b = PlanOf(sides, "b", request, context);
  const recipes::PlanDiff diff = recipes::DiffPlans(a, b);
  http::Response response;
  response.headers.Set("Content-Type", text ? "text/plain; charset=utf-8" : "application/json");
  response.headers.Set("Vary", "Accept");
  response.headers.Set("X-Plans-Equal", diff.differences.empty() ? "true" : "false");
  response.body = text ? recipes::ToText(diff) : recipes::ToJson(diff).dump(2) + "\n";
  return response;
}

}  // namespace

void AddPlanDiffRoutes(http::Router& router, Context& context) {
  router.Add({"POST",
              "/v1/plans/diff",
              "diffPlans",
              [&context](const http::Request& request) { return Compare(request, context); },
              {"application/json"},
              kMaxDiffRequest});
}

}  // namespace lares::api
