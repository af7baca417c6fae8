#include "server/api/documents.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/once.h"
#include "server/api/quarantine.h"
#include "server/api/scope.h"
#include "server/http/etag.h"
#include "server/http/media_type.h"
#include "server/http/multipart.h"
#include "server/http/url.h"

namespace lares::api {
namespace {

using store::DocumentInfo;
using store::DocumentKind;

Error NoDocument(DocumentKind kind, const std::string& id) {
  return Error(Code::kNotFound,
               "there is no " + std::string(store::ToString(kind)) + " '" + id + "'");
}

std::vector<DocumentInfo> Visible(const http::Request& request, DocumentKind kind,
                                  const store::Store& store) {
  std::vector<DocumentInfo> documents = store.ListDocuments(kind);
  std::erase_if(documents, [&](const DocumentInfo& one) { return !MaySee(request, kind, one.id); });
  return documents;
}

// The newest version of the path's {id}. Throws kNotFound, with similar names.
DocumentInfo Current(const http::Request& request, DocumentKind kind, const store::Store& store) {
  const std::string& id = request.Param("id");
  const auto found = store.FindDocument(kind, id);
  if (found && MaySee(request, kind, id)) return *found;
  std::vector<std::string> ids;
  for (const DocumentInfo& document : Visible(request, kind, store)) ids.push_back(document.id);
  throw NoDocument(kind, id).WithCandidates(SimilarNames(id, ids));
}

// "application/octet-stream" and forms say nothing about what they carry.
std::string TellingType(std::string_view content_type) {
  const auto media = http::ParseMediaType(content_type);
  if (!media || media->type == "application/octet-stream") return "";
  return media->type;
}

void ReadForm(const http::Request& request, Upload& upload) {
  std::string* target = nullptr;
  bool found = false;
  http::ReadMultipart(request,
                      {[&](const http::PartHeader& part) {
                         if (part.name == "id") {
                           target = &upload.id;
                         } else if (part.name == "file" && !found) {
                           found = true;
                           target = &upload.bytes;
                           upload.file_name = part.file_name;
                           upload.media_type = TellingType(part.content_type);
                         } else {
                           throw Error(Code::kInvalid,
                                       "the form's part '" + part.name +
                                           "' is not known here: send one 'file', and 'id'");
                         }
                       },
                       [&](std::string_view piece) {
                         if (target->size() + piece.size() > kMaxDocumentBytes) {
                           throw Error(Code::kTooLarge, "the document is larger than 256 MiB");
                         }
                         target->append(piece);
                       },
                       [] {}});
  if (!found) throw Error(Code::kInvalid, "the form has no part 'file'");
}

http::Response GetDocument(const http::Request& request, DocumentKind kind,
                           const store::Store& store) {
  const std::string& id = request.Param("id");
  const int version = QueryNumber(request, "version", 0, 1, INT32_MAX);
  const DocumentInfo document = version == 0 || !MaySee(request, kind, id)
                                    ? Current(request, kind, store)
                                    : store.GetDocument(kind, id, version);
  const std::string as = request.Query("as").value_or("original");
  if (as == "info") {
    http::Response response = JsonAnswer(ToJson(document));
    response.headers.Set("ETag", document.etag());
    return response;
  }
  if (as != "original") throw Error(Code::kInvalid, "?as= is 'original' or 'info'");
  return BlobAnswer(store, document.blob, document.media_type, document.file_name, document.etag());
}

// Without the details, which can be long; a version never changes, so its text is made once.
std::string ListedText(const DocumentInfo& document, TextCache& cache) {
  const std::string key = std::string(store::ToString(document.kind)) + "/" + document.id + "/" +
                          std::to_string(document.version);
  return *cache.Get(key, [&] {
    Json json = ToJson(document);
    json.erase("details");
    return Compact(json);
  });
}

http::Response ListDocuments(const http::Request& request, DocumentKind kind, Context& context) {
  const std::vector<DocumentInfo> documents = Visible(request, kind, context.store);
  return PageOfTexts(
      request, documents.size(), [&](std::size_t i) { return documents[i].id; },
      [&](std::size_t i) { return ListedText(documents[i], *context.listed); });
}

http::Response ListVersions(const http::Request& request, DocumentKind kind,
                            const store::Store& store) {
  const std::string& id = request.Param("id");
  if (!MaySee(request, kind, id)) throw NoDocument(kind, id);
  const std::vector<DocumentInfo> versions = store.DocumentLog(kind, id);
  return Page(
      request, versions.size(), [&](std::size_t i) { return std::to_string(versions[i].version); },
      [&](std::size_t i) { return ToJson(versions[i]); });
}

http::Response DeleteDocument(const http::Request& request, DocumentKind kind, Context& context) {
  const std::string& id = request.Param("id");
  const DocumentInfo current = Current(request, kind, context.store);
  const std::string condition = http::WriteCondition(request, current.etag());
  if (!condition.empty() && condition != "*" && condition != current.etag()) {
    throw Error(Code::kPreconditionFailed,
                "'" + id + "' has changed: its ETag is now " + current.etag());
  }
  context.knowledge.Remove(kind, id);
  http::Response response;
  response.status = 204;
  return response;
}

}  // namespace

const std::vector<std::string>& RdfUploadTypes() {
  static const std::vector<std::string> types = {
      "application/rdf+xml",      "text/turtle",         "application/trig",
      "application/n-triples",    "application/n-quads", "text/owl-functional",
      "application/owl+xml",      "application/ld+json", "application/xml",
      "application/octet-stream", "multipart/form-data"};
  return types;
}

Upload ReadUpload(const http::Request& request, bool needs_id) {
  Upload upload;
  const auto media = http::ParseMediaType(request.headers.Get("Content-Type"));
  if (media && media->type == "multipart/form-data") {
    ReadForm(request, upload);
  } else {
    upload.media_type = TellingType(request.headers.Get("Content-Type"));
    upload.file_name = http::SafeFileName(request.Query("file_name").value_or(""));
    upload.bytes = http::ReadWholeBody(request, kMaxDocumentBytes);
  }
  if (!needs_id) return upload;
  if (const auto id = request.params.find("id"); id != request.params.end()) {
    upload.id = id->second;
  } else if (const auto query = request.Query("id")) {
    upload.id = *query;
  }
  if (upload.id.empty()) upload.id = std::filesystem::path(upload.file_name).stem().string();
  if (upload.id.empty()) {
    throw Error(Code::kInvalid, "there is neither an id nor a file name to take it from");
  }
  if (!IsIdentifier(upload.id)) {
    throw Error(Code::kInvalid, "'" + upload.id +
                                    "' is no id: 1 to 128 of A-Z a-z 0-9 . _ -, "
                                    "beginning with a letter, digit or _")
        .WithHint("give an id of your own");
  }
  return upload;
}

server::PutRequest ToPutRequest(DocumentKind kind, const http::Request& request,
                                const store::Store& store) {
  server::PutRequest put;
  put.kind = kind;
  put.recover = QueryFlag(request, "recover");
  Upload upload = ReadUpload(request);
  put.id = std::move(upload.id);
  put.media_type = std::move(upload.media_type);
  put.file_name = std::move(upload.file_name);
  put.bytes = std::move(upload.bytes);
  const auto current = store.FindDocument(kind, put.id);
  put.if_match =
      http::WriteCondition(request, current ? std::optional(current->etag()) : std::nullopt);
  return put;
}

http::Response PutAnswerToResponse(const server::PutAnswer& answer, const std::string& collection,
                                   bool existed) {
  if (!answer.quarantined.empty()) {
    http::Response response = JsonAnswer(ToJson(answer), 202);
    response.headers.Set("Location", "/v1/quarantine/" + http::PercentEncode(answer.document.id));
    return response;
  }
  http::Response response = JsonAnswer(ToJson(answer), existed ? 200 : 201);
  response.headers.Set("ETag", answer.document.etag());
  response.headers.Set("Location", collection + "/" + http::PercentEncode(answer.document.id));
  return response;
}

void AddDocumentPutRoutes(const DocumentRoutes& routes, http::Router& router, Context& context) {
  const http::Handler put = Once(context, [routes, &context](const http::Request& request) {
    server::PutRequest wanted = ToPutRequest(routes.kind, request, context.store);
    ReadRights(request, wanted);
    const bool existed = context.store.FindDocument(routes.kind, wanted.id).has_value();
    return PutAnswerToResponse(Put(context, wanted), routes.collection, existed);
  });
  router.Add({"PUT", routes.collection + "/{id}", "put" + routes.noun, put, RdfUploadTypes(),
              kMaxDocumentBytes + (1u << 20)});
  router.Add({"POST", routes.collection, "add" + routes.noun, put, RdfUploadTypes(),
              kMaxDocumentBytes + (1u << 20)});
}

void AddDocumentReadRoutes(const DocumentRoutes& routes, http::Router& router, Context& context) {
  const DocumentKind kind = routes.kind;
  router.Add({"GET",
              routes.collection,
              "list" + routes.nouns,
              [kind, &context](const http::Request& request) {
                return ListDocuments(request, kind, context);
              },
              {},
              0});
  router.Add({"GET",
              routes.collection + "/{id}",
              "get" + routes.noun,
              [kind, &context](const http::Request& request) {
                return GetDocument(request, kind, context.store);
              },
              {},
              0});
  router.Add({"GET",
              routes.collection + "/{id}/versions",
              "list" + routes.noun + "Versions",
              [kind, &context](const http::Request& request) {
                return ListVersions(request, kind, context.store);
              },
              {},
              0});
  router.Add({"DELETE",
              routes.collection + "/{id}",
              "delete" + routes.noun,
              [kind, &context](const http::Request& request) {
                return DeleteDocument(request, kind, context);
              },
              {},
              0});
}

}  // namespace lares::api
