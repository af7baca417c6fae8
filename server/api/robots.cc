// Robots: put as SRDL or as URDF, which becomes SRDL with the URDF kept beside it.
#include "server/api/robots.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"
#include "robots/urdf/xml_tree.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/documents.h"
#include "server/api/once.h"
#include "server/api/quarantine.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/robots";

struct NamedFormat {
  const char* name;  // of ?as=
  rdf::Format format;
};
constexpr NamedFormat kFormats[] = {
    {"turtle", rdf::Format::kTurtle},      {"rdf-xml", rdf::Format::kRdfXml},
    {"n-triples", rdf::Format::kNTriples}, {"json-ld", rdf::Format::kJsonLd},
    {"trig", rdf::Format::kTriG},          {"n-quads", rdf::Format::kNQuads}};

// The components that ?has= states, resolved.
std::vector<recipes::Resource> Stated(const http::Request& request, Context& context) {
  std::vector<recipes::Resource> stated;
  const auto [begin, end] = request.query.equal_range("has");
  for (auto at = begin; at != end; ++at) {
    stated.push_back(context.knowledge.ResolveComponent(at->second));
  }
  return stated;
}

void RefuseUrdfsOwn(const http::Request& request) {
  for (const char* name : {"has", "name", "base_frame"}) {
    if (request.Query(name)) {
      throw Error(Code::kInvalid, "?" + std::string(name) + "= is for robots put as URDF")
          .WithHint("state it in the SRDL itself");
    }
  }
}

// `put` holds a URDF; afterwards its SRDL, with the URDF as attached file.
Json TurnIntoSrdl(const http::Request& request, Context& context, server::PutRequest& put) {
  if (put.recover) throw Error(Code::kInvalid, "?recover= is for RDF/XML, not for URDF");
  const std::string source = put.file_name.empty() ? put.id : put.file_name;
  const std::vector<recipes::Resource> stated = Stated(request, context);
  const urdf::Imported imported =
      urdf::Import(put.bytes, source, request.Query("base_frame").value_or(""));
  urdf::SrdlOptions options;
  options.id = put.id;
  options.label = request.Query("name").value_or("");
  options.source = source;
  options.sha256 = Sha256Hex(put.bytes);
  for (const recipes::Resource& component : stated) {
    options.stated.push_back({component.iri, component.label});
  }
  std::string srdl = urdf::ToSrdl(imported.model, imported.kinematics, imported.body, options);
  const auto writer = context.store.NewBlob();
  writer->Append(put.bytes);
  put.files.push_back(
      {put.file_name.empty() ? put.id + ".urdf" : put.file_name, kUrdfType, writer->Commit()});
  put.bytes = std::move(srdl);
  put.media_type = "text/turtle";
  put.file_name = put.id + ".ttl";
  return ToJson(imported, stated);
}

// Stated, or known by its root element where the stated type leaves it open; what says to be Turtle
// is read as that.
bool IsUrdf(const server::PutRequest& put) {
  if (put.media_type == kUrdfType) return true;
  const bool is_open = put.media_type.empty() || put.media_type == "application/xml";
  return is_open && urdf::IsUrdf(put.bytes);
}

http::Response PutRobot(const http::Request& request, Context& context) {
  server::PutRequest put = ToPutRequest(store::DocumentKind::kRobot, request, context.store);
  ReadRights(request, put);
  Json report;
  if (IsUrdf(put)) {
    report = TurnIntoSrdl(request, context, put);
  } else {
    RefuseUrdfsOwn(request);
  }
  const bool existed = context.store.FindDocument(put.kind, put.id).has_value();
  const server::PutAnswer answer = Put(context, put);
  http::Response response = PutAnswerToResponse(answer, kCollection, existed);
  if (report.is_null()) return response;
  Json body = ToJson(answer);
  body["import"] = std::move(report);
  response.body = JsonAnswer(body).body;
  return response;
}

// ?as= one of RDF's formats: the stored document written anew.
std::optional<http::Response> Rewritten(const http::Request& request, Context& context) {
  const std::string as = request.Query("as").value_or("");
  const auto format = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const NamedFormat& known) { return as == known.name; });
  if (format == std::end(kFormats)) return std::nullopt;
  const int version = QueryNumber(request, "version", 0, 1, INT32_MAX);
  const store::DocumentInfo document =
      context.store.GetDocument(store::DocumentKind::kRobot, request.Param("id"), version);
  rdf::ReadOptions options;
  options.source = document.file_name;
  options.base_iri = "https://w3id.org/lares/robots/" + document.id;
  options.recover = true;
  const std::string bytes = context.store.ReadBlob(document.blob.sha256);
  http::Response response;
  response.headers.Set("Content-Type", std::string(rdf::MediaType(format->format)));
  response.body = rdf::WriteRdf(
      rdf::ReadRdf(bytes, rdf::GuessFormat(document.media_type, document.file_name, bytes),
                   options),
      format->format);
  return response;
}

http::Response GetUrdf(const http::Request& request, Context& context) {
  const StoredUrdf urdf =
      FindUrdf(context, request.Param("id"), QueryNumber(request, "version", 0, 1, INT32_MAX));
  return BlobAnswer(context.store, urdf.blob, kUrdfType, urdf.file_name,
                    "\"" + urdf.blob.sha256.substr(0, 32) + "\"");
}

std::vector<std::string> UploadTypes() {
  std::vector<std::string> types = RdfUploadTypes();
  types.insert(types.begin(), kUrdfType);
  return types;
}

}  // namespace

StoredUrdf FindUrdf(Context& context, const std::string& robot, int version) {
  const auto resolved = context.store.FindDocument(store::DocumentKind::kRobot, robot);
  store::DocumentInfo document =
      version > 0 ? context.store.GetDocument(store::DocumentKind::kRobot, robot, version)
      : resolved  ? *resolved
                  : context.knowledge.Resolve(store::DocumentKind::kRobot, robot).document;
  const Json details = Json::parse(document.details_json, nullptr, false);
  if (details.is_object() && details.contains("files")) {
    for (const Json& file : details["files"]) {
      if (file.value("media_type", "") != kUrdfType) continue;
      return {document, {file.at("sha256"), file.at("size")}, file.at("file_name")};
    }
  }
  throw Error(Code::kNotFound, "robot '" + document.id + "' was put as SRDL: it has no URDF")
      .WithHint("put it from its URDF: lares robot put FILE.urdf --id " + document.id);
}

void AddRobotRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kRobot, kCollection, "Robot", "Robots"};
  const http::Handler put = Once(
      context, [&context](const http::Request& request) { return PutRobot(request, context); });
  router.Add({"PUT", std::string(kCollection) + "/{id}", "putRobot", put, UploadTypes(),
              kMaxDocumentBytes + (1u << 20)});
  router.Add({"POST", kCollection, "addRobot", put, UploadTypes(), kMaxDocumentBytes + (1u << 20)});
  http::Router documents;
  AddDocumentReadRoutes(routes, documents, context);
  for (http::Route route : documents.routes()) {
    if (route.operation == "getRobot") {
      route.handler = [&context, plain = route.handler](const http::Request& request) {
        if (auto rewritten = Rewritten(request, context)) return std::move(*rewritten);
        return plain(request);
      };
    }
    router.Add(std::move(route));
  }
  router.Add({"GET",
              std::string(kCollection) + "/{id}/urdf",
              "getRobotUrdf",
              [&context](const http::Request& request) { return GetUrdf(request, context); },
              {},
              0});
  AddRobotQuestionRoutes(router, context);
}

}  // namespace lares::api
