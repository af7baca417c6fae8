#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/documents.h"
#include "server/api/object_models.h"
#include "server/api/once.h"
#include "server/api/quarantine.h"
#include "server/http/etag.h"
#include "server/http/media_type.h"
#include "server/http/multipart.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/object-models";
constexpr const char* kTypical = "typical";
constexpr std::uint64_t kMaxUploadBytes = std::uint64_t{4} << 30;

// A form of one "description" (RDF, in memory) and any number of "file" parts (into blobs).
class ModelForm {
 public:
  ModelForm(store::Store& store, server::PutRequest& put) : store_(store), put_(put) {}

  http::MultipartHandler handler() {
    return {[this](const http::PartHeader& part) { Begin(part); },
            [this](std::string_view piece) { Data(piece); }, [this] { End(); }};
  }
  bool described() const { return described_; }

 private:
  void Begin(const http::PartHeader& part) {
    if (part.name == "description" && !described_) {
      described_ = true;
      put_.file_name = part.file_name;
      put_.media_type = part.content_type == "application/octet-stream" ? "" : part.content_type;
      return;
    }
    if (part.name != "file") {
      throw Error(Code::kInvalid, "the form's part '" + part.name +
                                      "' is not known here: send one 'description' and any "
                                      "number of 'file'");
    }
    if (part.file_name.empty()) throw Error(Code::kInvalid, "a 'file' part has no file name");
    const auto same = [&](const server::AttachedFile& file) {
      return file.file_name == part.file_name;
    };
    if (std::any_of(put_.files.begin(), put_.files.end(), same)) {
      throw Error(Code::kInvalid, "file '" + part.file_name + "' is there twice");
    }
    file_ = {part.file_name,
             part.content_type.empty() ? http::MediaTypeOfFile(part.file_name) : part.content_type,
             {}};
    writer_ = store_.NewBlob();
  }

  void Data(std::string_view piece) {
    if (writer_ != nullptr) {
      writer_->Append(piece);
      return;
    }
    if (put_.bytes.size() + piece.size() > kMaxDocumentBytes) {
      throw Error(Code::kTooLarge, "the description is larger than 256 MiB");
    }
    put_.bytes.append(piece);
  }

  void End() {
    if (writer_ == nullptr) return;
    file_.blob = writer_->Commit();
    writer_.reset();
    put_.files.push_back(std::move(file_));
  }

  store::Store& store_;
  server::PutRequest& put_;
  bool described_ = false;
  server::AttachedFile file_;
  std::unique_ptr<store::BlobWriter> writer_;
};

http::Response PutModel(const http::Request& request, Context& context) {
  server::PutRequest put;
  put.kind = store::DocumentKind::kObjectModel;
  put.id = request.Param("id");
  put.recover = QueryFlag(request, "recover");
  ReadRights(request, put);
  if (!IsIdentifier(put.id)) throw Error(Code::kInvalid, "'" + put.id + "' is no id");
  if (put.id == kTypical) {
    throw Error(Code::kInvalid, "'typical' cannot be an id: it asks for the models of a room");
  }
  const auto current = context.store.FindDocument(put.kind, put.id);
  put.if_match =
      http::WriteCondition(request, current ? std::optional(current->etag()) : std::nullopt);
  ModelForm form(context.store, put);
  http::ReadMultipart(request, form.handler(), {4096, 8192});
  if (!form.described()) throw Error(Code::kInvalid, "the form has no part 'description'");
  return PutAnswerToResponse(Put(context, put), kCollection, current.has_value());
}

// One of the files that came with the description.
http::Response GetFile(const http::Request& request, Context& context) {
  const std::string& id = request.Param("id");
  const std::string& name = request.Param("name");
  const auto document = context.store.FindDocument(store::DocumentKind::kObjectModel, id);
  if (!document) throw Error(Code::kNotFound, "there is no object-model '" + id + "'");
  const Json details = Json::parse(document->details_json, nullptr, false);
  std::vector<std::string> names;
  if (details.is_object() && details.contains("files")) {
    for (const Json& file : details["files"]) {
      names.push_back(file.at("file_name"));
      if (names.back() != name) continue;
      const store::Blob blob{file.at("sha256"), file.at("size")};
      return BlobAnswer(context.store, blob, file.at("media_type"), name,
                        "\"" + blob.sha256.substr(0, 32) + "\"");
    }
  }
  throw Error(Code::kNotFound, "object model '" + id + "' has no file '" + name + "'")
      .WithCandidates(SimilarNames(name, names));
}

}  // namespace

void AddObjectModelRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kObjectModel, kCollection, "ObjectModel",
                              "ObjectModels"};
  router.Add({"PUT",
              std::string(kCollection) + "/{id}",
              "putObjectModel",
              Once(context,
                   [&context](const http::Request& request) { return PutModel(request, context); }),
              {"multipart/form-data"},
              kMaxUploadBytes});
  http::Router documents;
  AddDocumentReadRoutes(routes, documents, context);
  for (http::Route route : documents.routes()) {
    if (route.operation == "listObjectModels") {
      route.handler = [&context](const http::Request& request) {
        return ListObjectModels(request, context);
      };
    }
    router.Add(std::move(route));
  }
  router.Add(
      {"GET",
       std::string(kCollection) + "/" + kTypical,
       "getTypicalObjectModels",
       [&context](const http::Request& request) { return TypicalObjectModels(request, context); },
       {},
       0});
  router.Add({"GET",
              std::string(kCollection) + "/{id}/files/{name}",
              "getObjectModelFile",
              [&context](const http::Request& request) { return GetFile(request, context); },
              {},
              0});
}

}  // namespace lares::api
