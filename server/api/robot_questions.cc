// What is asked of one robot: what it can do, how it hangs together, what is wrong with its URDF.
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "recipes/plan/export.h"
#include "robots/urdf/doctor.h"
#include "robots/urdf/tree_picture.h"
#include "server/api/answers.h"
#include "server/api/documents.h"
#include "server/api/robots.h"

namespace lares::api {
namespace {

constexpr std::uint64_t kMaxUrdf = 64u << 20;

Json Point(const Eigen::Vector3d& point_m) { return {point_m.x(), point_m.y(), point_m.z()}; }

Json SensorJson(const urdf::Model& model, const urdf::BodySensor& placed) {
  constexpr const char* kKinds[] = {"camera",   "depth-camera", "rgbd-camera", "stereo-camera",
                                    "laser-2d", "laser-3d",     "sonar",       "bumper",
                                    "imu",      "force-torque", "other"};
  const urdf::Sensor& sensor = placed.sensor;
  const Eigen::Quaterniond& q = placed.base_from_sensor.rotation;
  Json json{{"name", sensor.name},
            {"kind", kKinds[static_cast<std::size_t>(sensor.kind)]},
            {"link", model.links[static_cast<std::size_t>(sensor.link)].name},
            {"position_m", Point(placed.base_from_sensor.translation_m)},
            {"rotation_xyzw", {q.x(), q.y(), q.z(), q.w()}},
            {"reason", sensor.reason}};
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) json[name] = *value;
  };
  add("min_range_m", sensor.min_range_m);
  add("max_range_m", sensor.max_range_m);
  add("hfov_rad", sensor.hfov_rad);
  add("min_angle_rad", sensor.min_angle_rad);
  add("max_angle_rad", sensor.max_angle_rad);
  add("width_px", sensor.width_px);
  add("height_px", sensor.height_px);
  add("rate_hz", sensor.rate_hz);
  return json;
}

Json LimbsJson(const urdf::Model& model, const urdf::Body& body) {
  const auto link = [&](int index) { return model.links[static_cast<std::size_t>(index)].name; };
  Json arms = Json::array(), grippers = Json::array();
  for (const urdf::Arm& arm : body.arms) {
    arms.push_back({{"side", arm.side},
                    {"base_link", link(arm.base_link)},
                    {"end_link", link(arm.end_link)},
                    {"joints", arm.joints.size()},
                    {"reach_m", arm.reach_m},
                    {"reason", arm.reason}});
  }
  for (const urdf::Gripper& gripper : body.grippers) {
    grippers.push_back({{"side", gripper.side},
                        {"palm", link(gripper.palm)},
                        {"fingers", gripper.fingers.size()},
                        {"reason", gripper.reason}});
  }
  Json heads = Json::array(), torsos = Json::array();
  for (const urdf::Head& head : body.heads) {
    heads.push_back({{"link", link(head.link)}, {"reason", head.reason}});
  }
  for (const urdf::Torso& torso : body.torsos) {
    torsos.push_back({{"link", link(torso.link)}, {"reason", torso.reason}});
  }
  return {{"arms", arms}, {"grippers", grippers}, {"heads", heads}, {"torsos", torsos}};
}

Json FindingJson(const urdf::Finding& finding) {
  Json json{{"severity", urdf::ToString(finding.severity)}, {"code", finding.code}};
  if (finding.place.line > 0) {
    json["place"] = {{"source", finding.place.source}, {"line", finding.place.line}};
  }
  json["message"] = finding.message;
  if (!finding.remedy.empty()) json["remedy"] = finding.remedy;
  return json;
}

// A stored SRDL as triples.
struct StoredSrdl {
  rdf::Dictionary dictionary;
  rdf::Graph graph;
  std::string id;
};

std::unique_ptr<StoredSrdl> ReadSrdl(Context& context, const store::DocumentInfo& document) {
  auto srdl = std::make_unique<StoredSrdl>();
  srdl->id = document.id;
  rdf::ReadOptions options;
  options.source = document.file_name;
  options.base_iri = "https://w3id.org/lares/robots/" + document.id;
  options.recover = true;
  const std::string bytes = context.store.ReadBlob(document.blob.sha256);
  const rdf::Document content = rdf::ReadRdf(
      bytes, rdf::GuessFormat(document.media_type, document.file_name, bytes), options);
  srdl->graph = rdf::MakeGraph(content, "srdl", context.knowledge.aliases(), srdl->dictionary);
  return srdl;
}

http::Response Examined(Context& context, const std::string& bytes, const std::string& source,
                        const std::string& srdl_of) {
  std::unique_ptr<StoredSrdl> srdl;
  if (!srdl_of.empty()) {
    srdl =
        ReadSrdl(context, context.knowledge.Resolve(store::DocumentKind::kRobot, srdl_of).document);
  }
  std::vector<urdf::Finding> findings;
  if (srdl != nullptr) {
    const urdf::SrdlToCompare compared{srdl->graph, srdl->dictionary, srdl->id};
    findings = urdf::Examine(bytes, source, &compared);
  } else {
    findings = urdf::Examine(bytes, source);
  }
  const auto count = [&](urdf::Finding::Severity severity) {
    return std::count_if(findings.begin(), findings.end(),
                         [&](const urdf::Finding& f) { return f.severity == severity; });
  };
  Json json{{"source", source},
            {"errors", count(urdf::Finding::Severity::kError)},
            {"warnings", count(urdf::Finding::Severity::kWarning)},
            {"notes", count(urdf::Finding::Severity::kNote)},
            {"findings", ToJson(findings)}};
  return JsonAnswer(json);
}

http::Response ExamineUpload(const http::Request& request, Context& context) {
  const Upload upload = ReadUpload(request, false);
  return Examined(context, upload.bytes, upload.file_name.empty() ? "robot.urdf" : upload.file_name,
                  request.Query("srdl").value_or(""));
}

// A stored robot's URDF against its own SRDL or another's.
http::Response ExamineStored(const http::Request& request, Context& context) {
  const StoredUrdf urdf = FindUrdf(context, request.Param("id"));
  return Examined(context, context.store.ReadBlob(urdf.blob.sha256), urdf.file_name,
                  request.Query("srdl").value_or(urdf.document.id));
}

http::Response ShowTree(const http::Request& request, Context& context) {
  const std::string as = request.Query("as").value_or("svg");
  if (as != "svg" && as != "dot") throw Error(Code::kInvalid, "?as= is 'svg' or 'dot'");
  const StoredUrdf stored = FindUrdf(context, request.Param("id"));
  const urdf::Imported robot =
      urdf::Import(context.store.ReadBlob(stored.blob.sha256), stored.file_name);
  http::Response response;
  response.headers.Set("Content-Type", as == "svg" ? "image/svg+xml" : "text/vnd.graphviz");
  if (as == "svg") {
    response.headers.Set("Content-Security-Policy",
                         "default-src 'none'; style-src 'unsafe-inline'");
  }
  response.body =
      as == "svg" ? urdf::ToSvg(robot.model, robot.body) : urdf::ToDot(robot.model, robot.body);
  return response;
}

http::Response ShowCapabilities(const http::Request& request, Context& context) {
  const recipes::CapabilityReport report =
      context.knowledge.Capabilities(request.Param("id"), QueryFlag(request, "strict"));
  recipes::MatchReport as_match;
  as_match.robot = report.robot;
  as_match.capabilities = report.capabilities;
  const nlohmann::json written = recipes::ToJson(as_match);
  Json json{{"robot", ToJson(report.robot)},
            {"capabilities", Json(written.value("capabilities", nlohmann::json::array()))}};
  return JsonAnswer(json);
}

}  // namespace

Json ToJson(const std::vector<urdf::Finding>& findings) {
  Json json = Json::array();
  for (const urdf::Finding& finding : findings) json.push_back(FindingJson(finding));
  return json;
}

Json ToJson(const urdf::Imported& imported, const std::vector<recipes::Resource>& stated) {
  const urdf::Model& model = imported.model;
  const urdf::Body& body = imported.body;
  Json json{{"robot", model.name},
            {"links", model.links.size()},
            {"joints", model.joints.size()},
            {"base_frame", model.links[static_cast<std::size_t>(body.base_frame)].name},
            {"mass_kg", body.mass_kg},
            {"base", {{"kind", urdf::ToString(body.base.kind)}, {"reason", body.base.reason}}}};
  if (body.footprint) {
    json["footprint"] = {{"length_m", body.footprint->length_m},
                         {"width_m", body.footprint->width_m},
                         {"radius_m", body.footprint->radius_m},
                         {"is_lower_bound", body.footprint->is_lower_bound},
                         {"reason", body.footprint->reason}};
  }
  if (body.height) {
    json["height"] = {{"height_m", body.height->height_m},
                      {"is_lower_bound", body.height->is_lower_bound},
                      {"reason", body.height->reason}};
  }
  json.update(LimbsJson(model, body));
  json["sensors"] = Json::array();
  for (const urdf::BodySensor& sensor : body.sensors) {
    json["sensors"].push_back(SensorJson(model, sensor));
  }
  json["stated"] = ToJson(stated);
  json["notes"] = body.notes;
  json["findings"] = ToJson(model.findings);
  return json;
}

void AddRobotQuestionRoutes(http::Router& router, Context& context) {
  using Answer = http::Response (*)(const http::Request&, Context&);
  const auto get = [&](const char* path, const char* operation, Answer answer) {
    router.Add(
        {"GET",
         path,
         operation,
         [answer, &context](const http::Request& request) { return answer(request, context); },
         {},
         0});
  };
  get("/v1/robots/{id}/capabilities", "showRobotCapabilities", ShowCapabilities);
  get("/v1/robots/{id}/tree", "showRobotTree", ShowTree);
  get("/v1/robots/{id}/doctor", "examineRobot", ExamineStored);
  router.Add({"POST",
              "/v1/robots/doctor",
              "examineUrdf",
              [&context](const http::Request& request) { return ExamineUpload(request, context); },
              {kUrdfType, "application/xml", "application/octet-stream"},
              kMaxUrdf});
}

}  // namespace lares::api
