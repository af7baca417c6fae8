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

// The id of one that is there and that the caller's token reaches.
store::EnvironmentInfo FindEnvironment(const http::Request& request, const store::Store& store,
                                       const std::string& id) {
  if (Reaches(request, id)) {
    if (auto found = store.FindEnvironment(id)) return *found;
  }
  std::vector<std::string> ids;
  for (const auto& environment : store.ListEnvironments()) {
    if (Reaches(request, environment.id)) ids.push_back(environment.id);
  }
  throw Error(Code::kNotFound, "there is no environment '" + id + "'")
      .WithCandidates(SimilarNames(id, ids));
}

server::EnvironmentQuery ReadQuery(const http::Request& request) {
  server::EnvironmentQuery query;
  const auto text = [&](const char* name) { return request.Query(name).value_or(""); };
  query.room_number = text("room_number");
  query.street = text("street");
  query.building = text("building");
  query.level = text("level");
  query.type = text("type");
  query.text = text("q");
  const auto all = [&](const char* name) {
    std::vector<std::string> values;
    const auto [first, last] = request.query.equal_range(name);
    for (auto it = first; it != last; ++it) values.push_back(it->second);
    return values;
  };
  query.holds = all("holds");
  query.layers = all("layer");
  query.changed_from = QueryTime(request, "changed_from");
  query.changed_until = QueryTime(request, "changed_until");
  query.after = text("after");
  query.limit = static_cast<std::size_t>(QueryNumber(request, "limit", 100, 1, 1000));
  return query;
}

// Page after page, until there are `limit` that the caller's token reaches.
std::vector<store::EnvironmentInfo> FindReached(const http::Request& request, Context& context,
                                                server::EnvironmentQuery query) {
  std::vector<store::EnvironmentInfo> reached;
  const std::size_t limit = query.limit;
  for (;;) {
    const std::vector<store::EnvironmentInfo> page = context.knowledge.SearchEnvironments(query);
    for (const store::EnvironmentInfo& found : page) {
      if (Reaches(request, found.id)) reached.push_back(found);
      if (reached.size() == limit) return reached;
    }
    if (page.size() < query.limit) return reached;
    query.after = page.back().id;
  }
}

http::Response ListEnvironments(const http::Request& request, Context& context) {
  server::EnvironmentQuery query = ReadQuery(request);
  const std::size_t limit = query.limit++;  // one more tells whether there is a next page
  std::vector<store::EnvironmentInfo> found = FindReached(request, context, query);
  const bool more = found.size() > limit;
  if (more) found.pop_back();
  Json json{{"items", Json::array()}, {"next", nullptr}};
  for (const store::EnvironmentInfo& environment : found) {
    json["items"].push_back(ToJson(environment));
  }
  if (more) json["next"] = found.back().id;
  return JsonAnswer(json);
}

http::Response GetEnvironment(const http::Request& request, const Context& context) {
  const store::EnvironmentInfo environment =
      FindEnvironment(request, context.store, request.Param("id"));
  const store::EnvironmentVersion latest = context.store.GetVersion(environment.id, 0);
  Json json = ToJson(environment);
  json["version"] = ToJson(latest);
  http::Response response = JsonAnswer(json);
  response.headers.Set("ETag", latest.etag());
  return response;
}

http::Response ListVersions(const http::Request& request, const Context& context) {
  const std::string& id = request.Param("id");
  FindEnvironment(request, context.store, id);
  const std::vector<store::EnvironmentVersion> versions = context.store.Log(id);
  return Page(
      request, versions.size(), [&](std::size_t i) { return std::to_string(versions[i].number); },
      [&](std::size_t i) { return ToJson(versions[i]); });
}

http::Response GetVersion(const http::Request& request, Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  http::Response response = JsonAnswer(ToJson(version));
  response.headers.Set("ETag", version.etag());
  return response;
}

http::Response ListObjects(const http::Request& request, Context& context) {
  const store::EnvironmentVersion version = FindVersion(request, context);
  const std::vector<semantic::MapObject> objects =
      context.knowledge.MapObjects(version.environment, version.number);
  return Page(
      request, objects.size(), [&](std::size_t i) { return objects[i].iri; },
      [&](std::size_t i) { return ToJson(objects[i]); });
}

}  // namespace

store::EnvironmentVersion FindVersion(const http::Request& request, const store::Store& store,
                                      const std::string& environment, const std::string& name) {
  FindEnvironment(request, store, environment);
  if (name == "latest") return store.GetVersion(environment, 0);
  int value = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  if (error == std::errc() && end == name.data() + name.size() && value >= 1) {
    return store.GetVersion(environment, value);
  }
  if (const auto tag = store.FindTag(environment, name)) {
    return store.GetVersion(environment, tag->number);
  }
  std::vector<std::string> tags{"latest"};
  for (const store::Tag& tag : store.Tags(environment)) tags.push_back(tag.name);
  throw Error(
      IsIdentifier(name) && error != std::errc() ? Code::kNotFound : Code::kInvalid,
      "'" + name + "' is no version of '" + environment + "': a number from 1, 'latest' or a tag")
      .WithCandidates(SimilarNames(name, tags));
}

store::EnvironmentVersion FindVersion(const http::Request& request, Context& context) {
  const std::string& environment = request.Param("id");
  const std::string& name = request.Param("number");
  const auto as_of = QueryTime(request, "as_of");
  const auto robot = request.Query("robot");
  if (name != "latest" && (as_of || robot)) {
    throw Error(Code::kInvalid, "?as_of= and ?robot= go with versions/latest");
  }
  if (as_of && robot) throw Error(Code::kInvalid, "?as_of= and ?robot= exclude one another");
  if (as_of) {
    FindEnvironment(request, context.store, environment);
    return context.store.GetVersion(environment, context.store.VersionAsOf(environment, *as_of));
  }
  if (robot) {
    FindEnvironment(request, context.store, environment);
    const std::string id =
        context.knowledge.Resolve(store::DocumentKind::kRobot, *robot).document.id;
    const auto pin = context.store.FindPin(id, environment);
    return context.store.GetVersion(environment, pin ? pin->number : 0);
  }
  return FindVersion(request, context.store, environment, name);
}

int ChosenVersion(const http::Request& request, const store::Store& store,
                  const std::string& environment) {
  const auto name = request.Query("version");
  const auto as_of = QueryTime(request, "as_of");
  if (!name && !as_of) return 0;
  if (environment.empty()) {
    throw Error(Code::kInvalid, "?version= and ?as_of= need an ?environment=");
  }
  if (name && as_of) throw Error(Code::kInvalid, "?version= and ?as_of= exclude one another");
  // A number is looked up where the question is answered.
  const bool is_number = name && name->find_first_not_of("0123456789") == std::string::npos;
  if (is_number) return QueryNumber(request, "version", 0, 1, INT32_MAX);
  if (name) return FindVersion(request, store, environment, *name).number;
  FindEnvironment(request, store, environment);
  return store.VersionAsOf(environment, *as_of);
}

std::optional<Time> QueryTime(const http::Request& request, const std::string& name) {
  const auto text = request.Query(name);
  if (!text) return std::nullopt;
  if (const auto time = FromRfc3339(*text)) return time;
  throw Error(Code::kInvalid,
              "?" + name + "= is a time such as 2026-01-31T12:00:00Z, not '" + *text + "'");
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
