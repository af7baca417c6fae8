#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/environments.h"

namespace lares::api {
namespace {

Json Ranked(const std::vector<server::WhereAnswer::Place>& places) {
  Json json = Json::array();
  for (const auto& place : places) {
    Json entry = ToJson(place.place);
    entry["probability"] = place.probability;
    entry["support"] = place.support;
    json.push_back(std::move(entry));
  }
  return json;
}

Json ToJson(const server::WhereAnswer& answer) {
  Json json{{"object", api::ToJson(answer.object)},
            {"prior", {{"name", answer.prior}, {"title", answer.prior_title}}},
            {"seen", Json::array()},
            {"rooms", Ranked(answer.rooms)},
            {"furniture", Ranked(answer.furniture)}};
  for (const server::SeenObject& seen : answer.seen) {
    Json entry = api::ToJson(seen.object);
    entry["environment"] = seen.environment;
    entry["version"] = seen.version;
    json["seen"].push_back(std::move(entry));
  }
  return json;
}

http::Response LikelyPlaces(const http::Request& request, Context& context) {
  server::WhereRequest where;
  where.object = request.Query("object").value_or("");
  if (where.object.empty()) throw Error(Code::kInvalid, "?object= is missing");
  where.prior = request.Query("prior").value_or("");
  where.environment = request.Query("environment").value_or("");
  where.environment_version = ChosenVersion(request, context.store, where.environment);
  return JsonAnswer(ToJson(context.knowledge.Where(where)));
}

}  // namespace

void AddLikelyPlaceRoutes(http::Router& router, Context& context) {
  router.Add({"GET",
              "/v1/likely-places",
              "findLikelyPlaces",
              [&context](const http::Request& request) { return LikelyPlaces(request, context); },
              {},
              0});
}

}  // namespace lares::api
