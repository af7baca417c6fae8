#include "server/api/openapi.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "server/web/bundle.h"

namespace lares::api {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> PathParameters(const std::string& path) {
  std::vector<std::string> names;
  for (std::size_t open = path.find('{'); open != std::string::npos;
       open = path.find('{', open + 1)) {
    names.push_back(path.substr(open + 1, path.find('}', open) - open - 1));
  }
  return names;
}

Json PathParameter(const std::string& name) {
  return {{"name", name}, {"in", "path"}, {"required", true}, {"schema", {{"type", "string"}}}};
}

// What is described by hand, completed by what the route itself says.
Json Operation(const http::Route& route, Json described) {
  Json operation{{"operationId", route.operation}};
  Json parameters = Json::array();
  for (const std::string& name : PathParameters(route.path)) {
    parameters.push_back(PathParameter(name));
  }
  const Json more = described.value("parameters", Json::array());
  for (const Json& parameter : more) {
    parameters.push_back(parameter);
  }
  described.erase("parameters");
  operation.update(described);
  if (!parameters.empty()) operation["parameters"] = std::move(parameters);
  if (!route.consumes.empty()) {
    const Json schema = operation.contains("requestBody") ? operation["requestBody"] : Json{};
    operation["requestBody"] = {{"required", true}};
    for (const std::string& type : route.consumes) {
      operation["requestBody"]["content"][type] =
          schema.contains(type) ? schema[type] : Json::object();
    }
  }
  if (operation.value("x-lares-role", "") != "public") {
    operation["security"] = Json::array({Json{{"token", Json::array()}}});
  }
  operation["responses"]["default"] = {{"$ref", "#/components/responses/Problem"}};
  return operation;
}

void CollectReferences(const Json& json, std::set<std::string>& references) {
  if (json.is_object() && json.contains("$ref") && json["$ref"].is_string()) {
    references.insert(json["$ref"].get<std::string>());
  }
  if (!json.is_structured()) return;
  for (const auto& item : json) CollectReferences(item, references);
}

}  // namespace

std::string_view OperationsJson() { return web::Bundled("operations.json"); }

std::string MakeOpenApi(const std::vector<http::Route>& routes) {
  const Json described = Json::parse(OperationsJson());
  Json document{{"openapi", "3.1.0"},
                {"info", described.at("info")},
                {"servers", {{{"url", "/"}}}},
                {"tags", described.at("tags")},
                {"paths", Json::object()}};
  for (const http::Route& route : routes) {
    if (!described["operations"].contains(route.operation)) {
      throw Error(Code::kInternal, "operation " + route.operation + " is not described");
    }
    document["paths"][route.path][ToLower(route.method)] =
        Operation(route, described["operations"][route.operation]);
  }
  document["components"] = described.at("components");
  document["components"]["securitySchemes"]["token"] = {
      {"type", "http"},
      {"scheme", "bearer"},
      {"description", "lares_ID_SECRET; not needed while the store has no token"}};
  return document.dump(2) + "\n";
}

std::vector<std::string> CheckOpenApi(const std::vector<http::Route>& routes) {
  std::vector<std::string> faults;
  const Json described = Json::parse(OperationsJson());
  std::set<std::string> operations;
  std::set<std::string> tags;
  for (const Json& tag : described.at("tags")) tags.insert(tag.at("name"));
  for (const http::Route& route : routes) {
    const std::string name = route.method + " " + route.path;
    if (!operations.insert(route.operation).second) {
      faults.push_back(name + ": operation " + route.operation + " is there twice");
    }
    if (!described["operations"].contains(route.operation)) {
      faults.push_back(name + " (" + route.operation + ") is not described");
      continue;
    }
    const Json& operation = described["operations"][route.operation];
    for (const char* member : {"summary", "tags", "responses"}) {
      if (!operation.contains(member)) {
        faults.push_back(route.operation + " has no " + member);
      }
    }
    if (!operation.contains("x-lares-role")) {
      faults.push_back(route.operation + " has no x-lares-role");
    }
    if (route.path.starts_with("/v1/environments/{id}") &&
        operation.value("x-lares-environments", "") != "path") {
      faults.push_back(route.operation + " is about an environment: x-lares-environments is path");
    }
    const Json own_tags = operation.value("tags", Json::array());
    for (const Json& tag : own_tags) {
      if (!tags.contains(tag)) faults.push_back(route.operation + " has an unknown tag");
    }
    const Json bodies = operation.value("requestBody", Json::object());
    for (const auto& [type, body] : bodies.items()) {
      if (std::find(route.consumes.begin(), route.consumes.end(), type) == route.consumes.end()) {
        faults.push_back(route.operation + " does not take " + type);
      }
    }
  }
  for (const auto& [operation, unused] : described["operations"].items()) {
    if (!operations.contains(operation)) {
      faults.push_back(operation + " is described, but no route has it");
    }
  }
  std::set<std::string> references;
  CollectReferences(described, references);
  for (const std::string& reference : references) {
    if (!reference.starts_with("#") ||
        !described.contains(Json::json_pointer(reference.substr(1)))) {
      faults.push_back("reference " + reference + " leads nowhere");
    }
  }
  return faults;
}

}  // namespace lares::api
