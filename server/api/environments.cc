#include "server/api/environments.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/scope.h"

namespace lares::api {
namespace {

std::vector<store::EnvironmentInfo> Reached(const http::Request& request,
                                            const store::Store& store) {
  std::vector<store::EnvironmentInfo> environments = store.ListEnvironments();
  std::erase_if(environments, [&](const auto& one) { return !Reaches(request, one.id); });
  return environments;
}

store::EnvironmentInfo FindEnvironment(const http::Request& request, const store::Store& store) {
  const std::string& id = request.Param("id");
  if (auto found = store.FindEnvironment(id)) return *found;
  std::vector<std::string> ids;
  for (const auto& environment : Reached(request, store)) ids.push_back(environment.id);
  throw Error(Code::kNotFound, "there is no environment '" + id + "'")
      .WithCandidates(SimilarNames(id, ids));
}

http::Response ListEnvironments(const http::Request& request, const Context& context) {
  const std::vector<store::EnvironmentInfo> environments = Reached(request, context.store);
  return Page(
      request, environments.size(), [&](std::size_t i) { return environments[i].id; },
      [&](std::size_t i) { return ToJson(environments[i]); });
}

http::Response GetEnvironment(const http::Request& request, const Context& context) {
  const store::EnvironmentInfo environment = FindEnvironment(request, context.store);
  const store::EnvironmentVersion latest = context.store.GetVersion(environment.id, 0);
  Json json = ToJson(environment);
  json["version"] = ToJson(latest);
  http::Response response = JsonAnswer(json);
  response.headers.Set("ETag", latest.etag());
  return response;
}

http::Response ListVersions(const http::Request& request, const Context& context) {
  const std::string& id = request.Param("id");
  FindEnvironment(request, context.store);
  const std::vector<store::EnvironmentVersion> versions = context.store.Log(id);
  return Page(
      request, versions.size(), [&](std::size_t i) { return std::to_string(versions[i].number); },
      [&](std::size_t i) { return ToJson(versions[i]); });
}

http::Response GetVersion(const http::Request& request, const Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context.store);
  http::Response response = JsonAnswer(ToJson(version));
  response.headers.Set("ETag", version.etag());
  return response;
}

http::Response ListObjects(const http::Request& request, Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context.store);
  const std::vector<semantic::MapObject> objects =
      context.knowledge.MapObjects(version.environment, version.number);
  return Page(
      request, objects.size(), [&](std::size_t i) { return objects[i].iri; },
      [&](std::size_t i) { return ToJson(objects[i]); });
}

}  // namespace

store::EnvironmentVersion FindVersion(const http::Request& request, const store::Store& store) {
  const std::string environment = FindEnvironment(request, store).id;
  const std::string& number = request.Param("number");
  if (number == "latest") return store.GetVersion(environment, 0);
  int value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size() || value < 1) {
    throw Error(Code::kInvalid, "'" + number + "' is no version: a number from 1, or 'latest'");
  }
  return store.GetVersion(environment, value);
}

void AddEnvironmentRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* path, const char* operation, auto handler) {
    router.Add(
        {"GET",
         path,
         operation,
         [handler, &context](const http::Request& request) { return handler(request, context); },
         {},
         0});
  };
  add("/v1/environments", "listEnvironments", ListEnvironments);
  add("/v1/environments/{id}", "getEnvironment", GetEnvironment);
  add("/v1/environments/{id}/versions", "listEnvironmentVersions", ListVersions);
  add("/v1/environments/{id}/versions/{number}", "getEnvironmentVersion", GetVersion);
  add("/v1/environments/{id}/versions/{number}/objects", "listMapObjects", ListObjects);
}

}  // namespace lares::api
