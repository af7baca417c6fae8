#include "server/api/json.h"

#include <nlohmann/json.hpp>

#include "base/time.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

Json PlaceToJson(const Place& place) {
  Json json = Json::object();
  if (!place.source.empty()) json["source"] = place.source;
  if (place.line > 0) json["line"] = place.line;
  if (place.column > 0) json["column"] = place.column;
  return json;
}

// What the reader found out; text that is no JSON object is our own fault and shown as none.
Json Details(const std::string& text) {
  Json details = Json::parse(text, nullptr, false);
  return details.is_object() ? details : Json::object();
}

Json Numbers(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

Json ToJson(const recipes::Resource& resource) {
  Json json{{"iri", resource.iri}, {"label", resource.label}};
  if (resource.as_written != resource.iri && !resource.as_written.empty()) {
    json["as_written"] = resource.as_written;
  }
  return json;
}

Json ToJson(const std::vector<recipes::Resource>& resources) {
  Json json = Json::array();
  for (const recipes::Resource& resource : resources) json.push_back(ToJson(resource));
  return json;
}

Json ToJson(const rdf::Remark& remark) {
  return {{"message", remark.message}, {"place", PlaceToJson(remark.place)}};
}

Json ToJson(const server::CheckAnswer& answer) {
  Json json{{"clean", answer.report.is_clean},
            {"owl2_rl", answer.report.is_owl2_rl},
            {"statements", answer.statements},
            {"findings", Json::array()}};
  for (const profile::Finding& finding : answer.report.findings) {
    Json entry{{"kind", profile::ToString(finding.kind)},
               {"message", finding.message},
               {"count", finding.count},
               {"places", Json::array()},
               {"names", finding.names}};
    for (const Place& place : finding.places) entry["places"].push_back(PlaceToJson(place));
    json["findings"].push_back(std::move(entry));
  }
  AddRemarks(answer.remarks, answer.warnings, json);
  return json;
}

void AddRemarks(const std::vector<rdf::Remark>& remarks, const std::vector<std::string>& warnings,
                Json& to) {
  to["repairs"] = Json::array();
  to["warnings"] = Json::array();
  for (const rdf::Remark& remark : remarks) {
    const bool repair = remark.kind == rdf::Remark::Kind::kRepair;
    to[repair ? "repairs" : "warnings"].push_back(ToJson(remark));
  }
  for (const std::string& warning : warnings) to["warnings"].push_back({{"message", warning}});
}

Json ToJson(const store::DocumentInfo& document) {
  Json names = Json::array();
  for (const store::DocumentName& name : document.names) {
    names.push_back({{"text", name.text}, {"kind", name.kind}, {"target", name.target}});
  }
  return {{"kind", store::ToString(document.kind)},
          {"id", document.id},
          {"version", document.version},
          {"media_type", document.media_type},
          {"file_name", document.file_name},
          {"size", document.blob.size},
          {"sha256", document.blob.sha256},
          {"etag", document.etag()},
          {"received", ToRfc3339(document.received)},
          {"names", std::move(names)},
          {"details", Details(document.details_json)}};
}

Json ToJson(const store::LayerInfo& layer) {
  return {
      {"name", layer.name},
      {"file_name", layer.file_name},
      {"media_type", layer.media_type},
      {"size", layer.blob.size},
      {"sha256", layer.blob.sha256},
      {"facts", layer.facts},
      {"href", "/v1/blobs/" + layer.blob.sha256 + "?name=" + http::PercentEncode(layer.file_name)}};
}

Json ToJson(const store::EnvironmentVersion& version) {
  Json layers = Json::array();
  for (const store::LayerInfo& layer : version.layers) layers.push_back(ToJson(layer));
  return {{"environment", version.environment},
          {"number", version.number},
          {"type", version.type_iri},
          {"label", version.label},
          {"created", ToRfc3339(version.created)},
          {"author", version.author},
          {"robot", version.robot},
          {"mission", version.mission},
          {"note", version.note},
          {"origin", store::ToString(version.origin)},
          {"parents", version.parents},
          {"base", version.base},
          {"head", version.was_head},
          {"etag", version.etag()},
          {"changed_layers", version.changed_layers},
          {"layers", std::move(layers)}};
}

Json ToJson(const store::EnvironmentInfo& environment) {
  return {{"id", environment.id},
          {"type", environment.type_iri},
          {"label", environment.label},
          {"created", ToRfc3339(environment.created)},
          {"changed", ToRfc3339(environment.changed)},
          {"latest", environment.latest},
          {"versions", environment.count}};
}

Json ToJson(const semantic::MapObject& object) {
  Json json{{"iri", object.iri}, {"label", object.label}, {"class", object.class_iri}};
  if (!object.class_as_written.empty() && object.class_as_written != object.class_iri) {
    json["class_as_written"] = object.class_as_written;
  }
  if (object.map_from_object) {
    const Eigen::Quaterniond& q = object.map_from_object->rotation;
    json["pose"] = {{"position_m", Numbers(object.map_from_object->translation_m)},
                    {"orientation_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
  }
  if (object.extent_m) json["extent_m"] = Numbers(*object.extent_m);
  if (object.existence) json["existence"] = *object.existence;
  if (object.first_seen) json["first_seen"] = ToRfc3339(*object.first_seen);
  if (object.last_seen) {
    json["last_seen"] = ToRfc3339(*object.last_seen);
    json["age"] = ToAge(*object.last_seen, Now());
  }
  if (!object.recognised_with.empty()) json["recognised_with"] = object.recognised_with;
  if (!object.part_of.empty()) json["part_of"] = object.part_of;
  if (!object.room.empty()) json["room"] = object.room;
  if (!object.maps.empty()) json["maps"] = object.maps;
  return json;
}

Json ToJson(const recipes::Task& task) {
  Json json = ToJson(task.task);
  json["top_level"] = task.top_level;
  json["form"] = task.state_machine ? "state-machine" : "partial-order";
  json["steps"] = ToJson(task.steps);
  json["problems"] = task.problems;
  json["warnings"] = task.warnings;
  return json;
}

Json ToJson(const server::PutAnswer& answer) {
  Json json;
  json["document"] = ToJson(answer.document);
  json["statements"] = answer.statements;
  json["inferred"] = answer.inferred;
  if (!answer.quarantined.empty()) json["quarantined"] = answer.quarantined;
  AddRemarks(answer.remarks, answer.warnings, json);
  if (answer.document.kind == store::DocumentKind::kRecipe) {
    json["tasks"] = Json::array();
    for (const recipes::Task& task : answer.tasks) json["tasks"].push_back(ToJson(task));
  }
  if (answer.document.kind == store::DocumentKind::kSkillTemplate) {
    json["skill_templates"] = ToJson(answer.skill_templates);
  }
  if (answer.document.kind == store::DocumentKind::kRobot) json["robots"] = ToJson(answer.robots);
  return json;
}

}  // namespace lares::api
