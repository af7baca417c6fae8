// Versions compared, taken back, merged; their tags, and the robots that are pinned to one.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/environments.h"
#include "server/api/json_body.h"
#include "server/api/scope.h"
#include "server/http/problem.h"
#include "server/knowledge/versions.h"

namespace lares::api {
namespace {

using PlainJson = nlohmann::json;

constexpr std::uint64_t kMaxBody = 1u << 20;

// Nothing is an empty object.
PlainJson ReadObject(const http::Request& request, const std::vector<std::string>& known) {
  const std::string body = http::ReadWholeBody(request, kMaxBody);
  return body.empty() ? PlainJson::object() : ReadJsonObject(body, known);
}

std::string Text(const PlainJson& json, const char* name) {
  if (!json.contains(name)) return "";
  if (!json[name].is_string()) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be a text");
  }
  return json[name].get<std::string>();
}

bool Flag(const PlainJson& json, const char* name) {
  if (!json.contains(name)) return false;
  if (!json[name].is_boolean()) {
    throw Error(Code::kInvalid, std::string("'") + name + "' must be true or false");
  }
  return json[name].get<bool>();
}

// A number or a tag, as a number; 0 when it is not there.
int VersionOf(const PlainJson& json, const char* name, const std::string& environment,
              const http::Request& request, const Context& context) {
  if (!json.contains(name)) return 0;
  const PlainJson& value = json[name];
  if (value.is_string()) {
    return FindVersion(request, context.store, environment, value.get<std::string>()).number;
  }
  if (value.is_number_integer()) {
    return FindVersion(request, context.store, environment, value.dump()).number;
  }
  throw Error(Code::kInvalid, std::string("'") + name + "' must be a version: a number or a tag");
}

int RequiredVersion(const PlainJson& json, const char* name, const std::string& environment,
                    const http::Request& request, const Context& context) {
  if (!json.contains(name)) throw Error(Code::kInvalid, std::string("'") + name + "' is missing");
  return VersionOf(json, name, environment, request, context);
}

server::VersionBy ReadBy(const PlainJson& json, const http::Request& request) {
  return {Text(json, "author"), Text(json, "robot"), Text(json, "mission"), Text(json, "note"),
          std::string(request.headers.Get("If-Match"))};
}

// --- Comparing --------------------------------------------------------------------------------

Json ToJson(const server::LayerDiff& layer) {
  static constexpr const char* kKinds[] = {"same", "added", "removed", "changed"};
  Json json{{"layer", layer.name}, {"change", kKinds[static_cast<int>(layer.kind)]}};
  if (layer.before) json["bytes_before"] = layer.before->size;
  if (layer.after) json["bytes_after"] = layer.after->size;
  return json;
}

Json Objects(const std::vector<semantic::MapObject>& objects) {
  Json json = Json::array();
  for (const semantic::MapObject& object : objects) json.push_back(api::ToJson(object));
  return json;
}

Json NumberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json ToJson(const semantic::ObjectDiff& diff) {
  Json json{{"added", Objects(diff.added)}, {"gone", Objects(diff.gone)}, {"moved", Json::array()},
            {"reclassed", Json::array()},   {"renamed", Json::array()},   {"same", diff.same}};
  for (const semantic::MovedObject& moved : diff.moved) {
    json["moved"].push_back({{"before", api::ToJson(moved.before)},
                             {"after", api::ToJson(moved.after)},
                             {"distance_m", NumberOrNull(moved.distance_m)},
                             {"angle_rad", NumberOrNull(moved.angle_rad)}});
  }
  for (const auto& each : diff.reclassed) {
    json["reclassed"].push_back(
        {{"before", api::ToJson(each.before)}, {"after", api::ToJson(each.after)}});
  }
  for (const auto& each : diff.renamed) {
    json["renamed"].push_back({{"before", api::ToJson(each.before)},
                               {"after", api::ToJson(each.after)},
                               {"distance_m", each.distance_m}});
  }
  return json;
}

Json ToJson(const grid::GridDiff& diff) {
  return {{"same_cut", diff.same_cut},
          {"same_cells", diff.same},
          {"became_occupied", diff.became_occupied},
          {"became_free", diff.became_free},
          {"became_known", diff.became_known},
          {"became_unknown", diff.became_unknown},
          {"beyond_before", diff.beyond_before},
          {"changed_area_m2", diff.changed_area_m2}};
}

double QueryMetres(const http::Request& request, const char* name, double otherwise) {
  const auto text = request.Query(name);
  if (!text) return otherwise;
  char* end = nullptr;
  const double value = std::strtod(text->c_str(), &end);
  if (text->empty() || *end != '\0' || !(value >= 0) || !std::isfinite(value)) {
    throw Error(Code::kInvalid, std::string("?") + name + "= is a number of 0 or more, not '" +
                                    Shortened(*text, 60) + "'");
  }
  return value;
}

http::Response Diff(const http::Request& request, Context& context) {
  const std::string& id = request.Param("id");
  const store::EnvironmentVersion after =
      FindVersion(request, context.store, id, request.Query("to").value_or("latest"));
  const auto from = request.Query("from");
  const int before = from ? FindVersion(request, context.store, id, *from).number
                          : (after.parents.empty() ? after.number : after.parents.front());
  semantic::DiffTolerance tolerance;
  tolerance.distance_m = QueryMetres(request, "tolerance_m", tolerance.distance_m);
  tolerance.angle_rad = QueryMetres(request, "tolerance_rad", tolerance.angle_rad);
  const server::VersionDiff diff =
      server::DiffVersions(context.knowledge, id, before, after.number, tolerance);
  Json json{{"environment", id},
            {"from", diff.before.number},
            {"to", diff.after.number},
            {"layers", Json::array()},
            {"objects", ToJson(diff.objects)},
            {"grid", diff.grid ? ToJson(*diff.grid) : Json(nullptr)}};
  for (const server::LayerDiff& layer : diff.layers) json["layers"].push_back(ToJson(layer));
  if (!diff.grid_problem.empty()) json["grid_problem"] = diff.grid_problem;
  if (diff.before.type_iri != diff.after.type_iri) {
    json["type"] = {{"before", diff.before.type_iri}, {"after", diff.after.type_iri}};
  }
  if (diff.before.label != diff.after.label) {
    json["label"] = {{"before", diff.before.label}, {"after", diff.after.label}};
  }
  return JsonAnswer(json);
}

// --- Taking back and merging ------------------------------------------------------------------

http::Response RollBack(const http::Request& request, Context& context) {
  const std::string& id = request.Param("id");
  const PlainJson json = ReadObject(request, {"to", "author", "robot", "mission", "note"});
  FindVersion(request, context.store, id, "latest");
  return VersionCreated(server::RollBack(context.knowledge, id,
                                         RequiredVersion(json, "to", id, request, context),
                                         ReadBy(json, request)));
}

rdf::Side ReadSide(const PlainJson& value, const std::string& name) {
  if (value == "ours") return rdf::Side::kOurs;
  if (value == "theirs") return rdf::Side::kTheirs;
  throw Error(Code::kInvalid, "'" + Shortened(name, 100) + "' must be \"ours\" or \"theirs\"");
}

Json BlobOrNull(const std::optional<store::Blob>& blob) {
  return blob ? Json{{"sha256", blob->sha256}, {"size", blob->size}} : Json(nullptr);
}

Json ToJson(const server::MergeAnswer& answer) {
  Json json{{"base", answer.base},
            {"ours", answer.ours},
            {"theirs", answer.theirs},
            {"up_to_date", answer.up_to_date},
            {"conflicts", Json::array()}};
  for (const server::LayerConflict& conflict : answer.layer_conflicts) {
    json["conflicts"].push_back({{"layer", conflict.layer},
                                 {"base", BlobOrNull(conflict.base)},
                                 {"ours", BlobOrNull(conflict.ours)},
                                 {"theirs", BlobOrNull(conflict.theirs)}});
  }
  for (const rdf::MergeConflict& conflict : answer.conflicts) {
    json["conflicts"].push_back({{"layer", "semantic"},
                                 {"subject", conflict.subject},
                                 {"property", conflict.predicate},
                                 {"base", conflict.base},
                                 {"ours", conflict.ours},
                                 {"theirs", conflict.theirs}});
  }
  return json;
}

server::MergeRequest ReadMerge(const http::Request& request, const Context& context) {
  server::MergeRequest merge;
  merge.environment = request.Param("id");
  const PlainJson json = ReadObject(request, {"theirs", "ours", "dry_run", "take", "otherwise",
                                              "author", "robot", "mission", "note"});
  FindVersion(request, context.store, merge.environment, "latest");
  merge.theirs = RequiredVersion(json, "theirs", merge.environment, request, context);
  merge.ours = VersionOf(json, "ours", merge.environment, request, context);
  merge.dry_run = Flag(json, "dry_run");
  merge.by = ReadBy(json, request);
  if (json.contains("take")) {
    if (!json["take"].is_object()) {
      throw Error(Code::kInvalid, "'take' must be an object from layers or IRIs to a side");
    }
    for (const auto& [name, value] : json["take"].items()) {
      merge.take[name] = ReadSide(value, name);
    }
  }
  if (json.contains("otherwise")) merge.otherwise = ReadSide(json["otherwise"], "otherwise");
  return merge;
}

http::Response MergeInto(const http::Request& request, Context& context) {
  const server::MergeRequest merge = ReadMerge(request, context);
  const server::MergeAnswer answer = server::MergeVersions(context.knowledge, merge);
  const Json json = ToJson(answer);
  if (answer.merged) return VersionCreated(*answer.merged);
  const std::size_t count = answer.conflicts.size() + answer.layer_conflicts.size();
  if (count == 0 || merge.dry_run) return JsonAnswer(json);
  throw http::ProblemError("merge-conflict",
                           "version " + std::to_string(answer.theirs) + " and version " +
                               std::to_string(answer.ours) + " of '" + merge.environment +
                               "' changed " + std::to_string(count) +
                               (count == 1 ? " thing differently" : " things differently"))
      .WithHint(
          "say which side each is taken of, by \"take\": {\"LAYER or IRI\": \"ours\"} or "
          "\"otherwise\"")
      .WithMembers(Compact(json));
}

// --- Tags and pins ----------------------------------------------------------------------------

Json ToJson(const store::Tag& tag) {
  return {{"environment", tag.environment},    {"name", tag.name},     {"version", tag.number},
          {"created", ToRfc3339(tag.created)}, {"author", tag.author}, {"note", tag.note}};
}

Json ToJson(const store::Pin& pin) {
  return {{"robot", pin.robot},
          {"environment", pin.environment},
          {"version", pin.number},
          {"created", ToRfc3339(pin.created)},
          {"author", pin.author}};
}

http::Response ListTags(const http::Request& request, Context& context) {
  FindVersion(request, context.store, request.Param("id"), "latest");
  Json json{{"items", Json::array()}};
  for (const store::Tag& tag : context.store.Tags(request.Param("id"))) {
    json["items"].push_back(ToJson(tag));
  }
  return JsonAnswer(json);
}

http::Response PutTag(const http::Request& request, Context& context) {
  const std::string& id = request.Param("id");
  const PlainJson json = ReadObject(request, {"version", "move", "author", "note"});
  FindVersion(request, context.store, id, "latest");
  store::Tag tag;
  tag.environment = id;
  tag.name = request.Param("tag");
  tag.number = VersionOf(json, "version", id, request, context);
  tag.author = Text(json, "author");
  tag.note = Text(json, "note");
  return JsonAnswer(ToJson(context.store.PutTag(tag, Flag(json, "move"))));
}

http::Response DeleteTag(const http::Request& request, Context& context) {
  FindVersion(request, context.store, request.Param("id"), "latest");
  context.store.DeleteTag(request.Param("id"), request.Param("tag"));
  http::Response response;
  response.status = 204;
  return response;
}

std::string RobotOf(const http::Request& request, Context& context) {
  return context.knowledge.Resolve(store::DocumentKind::kRobot, request.Param("id")).document.id;
}

http::Response ListPins(const http::Request& request, Context& context) {
  Json json{{"items", Json::array()}};
  for (const store::Pin& pin : context.store.Pins(RobotOf(request, context))) {
    if (!Reaches(request, pin.environment)) continue;
    json["items"].push_back(ToJson(pin));
  }
  return JsonAnswer(json);
}

http::Response PutPin(const http::Request& request, Context& context) {
  const std::string& environment = request.Param("environment");
  CheckReach(request, environment);
  const PlainJson json = ReadObject(request, {"version", "author"});
  FindVersion(request, context.store, environment, "latest");
  store::Pin pin;
  pin.robot = RobotOf(request, context);
  pin.environment = environment;
  pin.number = VersionOf(json, "version", environment, request, context);
  pin.author = Text(json, "author");
  return JsonAnswer(ToJson(context.store.PutPin(pin)));
}

http::Response DeletePin(const http::Request& request, Context& context) {
  CheckReach(request, request.Param("environment"));
  context.store.DeletePin(RobotOf(request, context), request.Param("environment"));
  http::Response response;
  response.status = 204;
  return response;
}

}  // namespace

void AddEnvironmentVersionRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* method, const char* path, const char* operation, auto handler,
                       bool has_body = false) {
    router.Add(
        {method, path, operation,
         [handler, &context](const http::Request& request) { return handler(request, context); },
         has_body ? std::vector<std::string>{"application/json"} : std::vector<std::string>{},
         has_body ? kMaxBody : 0});
  };
  add("GET", "/v1/environments/{id}/diff", "diffEnvironmentVersions", Diff);
  add("POST", "/v1/environments/{id}/rollback", "rollBackEnvironment", RollBack, true);
  add("POST", "/v1/environments/{id}/merge", "mergeEnvironmentVersions", MergeInto, true);
  add("GET", "/v1/environments/{id}/tags", "listEnvironmentTags", ListTags);
  add("PUT", "/v1/environments/{id}/tags/{tag}", "putEnvironmentTag", PutTag, true);
  add("DELETE", "/v1/environments/{id}/tags/{tag}", "deleteEnvironmentTag", DeleteTag);
  add("GET", "/v1/robots/{id}/pins", "listRobotPins", ListPins);
  add("PUT", "/v1/robots/{id}/pins/{environment}", "pinRobot", PutPin, true);
  add("DELETE", "/v1/robots/{id}/pins/{environment}", "unpinRobot", DeletePin);
}

}  // namespace lares::api
