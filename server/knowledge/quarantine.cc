#include "server/knowledge/quarantine.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace lares::server {
namespace {

using nlohmann::json;
using store::DocumentKind;

DocumentKind KindOf(const std::string& name) {
  for (const DocumentKind kind :
       {DocumentKind::kOntology, DocumentKind::kRecipe, DocumentKind::kRobot,
        DocumentKind::kObjectModel, DocumentKind::kSkillTemplate}) {
    if (store::ToString(kind) == name) return kind;
  }
  throw Error(Code::kInternal, "'" + name + "' is no kind of document that is kept aside");
}

store::DocumentInfo FindAside(const store::Store& store, const std::string& quarantine_id) {
  if (const auto document = store.FindDocument(DocumentKind::kQuarantined, quarantine_id)) {
    return *document;
  }
  Error error(Code::kNotFound, "no document '" + quarantine_id + "' is kept aside");
  error.WithHint("lares quarantine list shows those that are");
  throw error;
}

}  // namespace

std::string QuarantineId(DocumentKind kind, const std::string& id) {
  return std::string(store::ToString(kind)) + "." + id;
}

store::DocumentInfo KeepAside(store::Store& store, const PutRequest& request,
                              const std::string& reason) {
  json files = json::array();
  for (const AttachedFile& file : request.files) {
    files.push_back({{"file_name", file.file_name},
                     {"media_type", file.media_type},
                     {"sha256", file.blob.sha256},
                     {"size", file.blob.size}});
  }
  store::NewDocument document;
  document.kind = DocumentKind::kQuarantined;
  document.id = QuarantineId(request.kind, request.id);
  document.media_type = request.media_type;
  document.file_name = request.file_name;
  document.bytes = request.bytes;
  document.details_json = json{
      {"kind", store::ToString(request.kind)},
      {"id", request.id},
      {"reason", reason},
      {"recover", request.recover},
      {"editor", request.editor},
      {"files", files}}.dump();
  return store.PutDocument(document);
}

store::DocumentInfo KeepAside(store::Store& store, const store::NewVersion& version,
                              const store::LayerInfo& semantic, bool editor,
                              const std::string& reason) {
  store::NewDocument document;
  document.kind = DocumentKind::kQuarantined;
  document.id = QuarantineIdOfEnvironment(version.environment);
  document.media_type = semantic.media_type;
  document.file_name = semantic.file_name;
  document.bytes = store.ReadBlob(semantic.blob.sha256);
  document.details_json =
      json{{"kind", "environment"},    {"id", version.environment}, {"reason", reason},
           {"editor", editor},         {"type", version.type_iri},  {"label", version.label},
           {"author", version.author}, {"note", version.note}}
          .dump();
  return store.PutDocument(document);
}

VersionAside VersionKeptAside(const store::Store& store, const std::string& quarantine_id) {
  const store::DocumentInfo document = FindAside(store, quarantine_id);
  const json details = json::parse(document.details_json);
  VersionAside aside;
  aside.version.environment = details.at("id");
  aside.version.type_iri = details.at("type");
  aside.version.label = details.at("label");
  aside.version.author = details.at("author");
  aside.version.note = details.at("note");
  aside.version.layers = {{"semantic", document.file_name, document.media_type, document.blob, {}}};
  aside.editor = details.at("editor");
  return aside;
}

PutRequest KeptAside(const store::Store& store, const std::string& quarantine_id) {
  const store::DocumentInfo document = FindAside(store, quarantine_id);
  const json details = json::parse(document.details_json);
  PutRequest request;
  request.kind = KindOf(details.at("kind"));
  request.id = details.at("id");
  request.media_type = document.media_type;
  request.file_name = document.file_name;
  request.bytes = store.ReadBlob(document.blob.sha256);
  request.recover = details.at("recover");
  request.editor = details.at("editor");
  for (const json& file : details.at("files")) {
    request.files.push_back({file.at("file_name"),
                             file.at("media_type"),
                             {file.at("sha256"), file.at("size").get<std::uint64_t>()}});
  }
  return request;
}

void ForgetKeptAside(store::Store& store, DocumentKind kind, const std::string& id) {
  ForgetKeptAside(store, QuarantineId(kind, id));
}

void ForgetKeptAside(store::Store& store, const std::string& quarantine_id) {
  if (store.FindDocument(DocumentKind::kQuarantined, quarantine_id)) {
    store.DeleteDocument(DocumentKind::kQuarantined, quarantine_id);
  }
}

}  // namespace lares::server
