#include "server/api/uploads.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/api/context.h"
#include "server/http/multipart.h"
#include "server/http/problem.h"
#include "server/http/tus.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/uploads";
constexpr const char* kPieceType = "application/offset+octet-stream";
constexpr std::uint64_t kMaxPieceBytes = std::uint64_t{64} << 30;

http::ProblemError Locked(const store::UploadBusyError& error) {
  return http::ProblemError("upload-locked", error.what()).WithHeader("Retry-After", "1");
}

void CheckVersion(const http::Request& request) {
  if (request.headers.Get("Tus-Resumable") == http::kTusVersion) return;
  throw http::ProblemError("tus-version", "send 'Tus-Resumable: 1.0.0'")
      .WithHeader("Tus-Version", std::string(http::kTusVersion));
}

// Every answer says which version of the protocol it is in, refusals too.
http::Handler InTus(http::Handler handler) {
  return [handler = std::move(handler)](const http::Request& request) {
    http::Response response;
    try {
      CheckVersion(request);
      response = handler(request);
    } catch (const store::UploadBusyError& error) {
      response = http::ToProblem(Locked(error), request.id);
    } catch (const Error& error) {
      response = http::ToProblem(error, request.id);
    }
    response.headers.Set("Tus-Resumable", std::string(http::kTusVersion));
    response.headers.Set("Cache-Control", "no-store");
    return response;
  };
}

void AddState(const store::UploadInfo& upload, http::Response& response) {
  response.headers.Set("Upload-Offset", std::to_string(upload.offset));
  response.headers.Set("Upload-Expires", http::FormatHttpDate(upload.expires));
  if (upload.is_whole()) response.headers.Set("Upload-Sha256", upload.sha256);
}

// What arrived before the connection broke is kept, so that the client goes on from there.
void KeepWhatArrived(store::UploadWriter& writer) {
  try {
    writer.Keep();
  } catch (const Error&) {
    // The offset is what was kept before.
  }
}

// The body as the upload's next piece.
store::UploadInfo TakePiece(const http::Request& request, store::Uploads& uploads,
                            const std::string& id, std::uint64_t offset) {
  if (request.headers.Has("Content-Encoding")) {
    throw Error(Code::kUnsupported, "pieces of an upload are taken as they are");
  }
  const auto checksum = http::ParseUploadChecksum(request.headers.Get("Upload-Checksum"));
  const auto writer =
      uploads.Continue(id, offset, checksum ? store::Pieces::kWholeOrNot : store::Pieces::kAnyPart);
  Sha256 hash;
  try {
    request.read_body([&](std::string_view bytes) {
      writer->Append(bytes);
      if (checksum) hash.Update(bytes);
    });
  } catch (const http::ProblemError&) {  // of the connection
    if (!checksum) KeepWhatArrived(*writer);
    throw;
  }
  if (checksum && hash.FinishHex() != *checksum) {
    throw http::ProblemError("checksum-mismatch",
                             "the piece has another SHA-256 than Upload-Checksum says; nothing of "
                             "it was kept");
  }
  return writer->Keep();
}

http::Response CreateUpload(const http::Request& request, store::Uploads& uploads) {
  if (request.headers.Has("Upload-Defer-Length")) {
    throw http::ProblemError("bad-request", "the length must be known: send Upload-Length");
  }
  const std::uint64_t length = http::ReadUploadNumber(request, "Upload-Length");
  const std::string metadata = request.headers.GetList("Upload-Metadata");
  http::ParseUploadMetadata(metadata);
  store::UploadInfo upload = uploads.Create(length, metadata);
  if (request.has_body) {
    try {
      upload = TakePiece(request, uploads, upload.id, 0);
    } catch (const Error&) {
      uploads.Remove(upload.id);  // nobody was told of it
      throw;
    }
  }
  http::Response response;
  response.status = 201;
  response.headers.Set("Location", std::string(kCollection) + "/" + upload.id);
  AddState(upload, response);
  return response;
}

http::Response GetOffset(const http::Request& request, const store::Uploads& uploads) {
  const store::UploadInfo upload = uploads.Find(request.Param("id"));
  http::Response response;
  AddState(upload, response);
  response.headers.Set("Upload-Length", std::to_string(upload.length));
  if (!upload.metadata.empty()) response.headers.Set("Upload-Metadata", upload.metadata);
  return response;
}

http::Response ContinueUpload(const http::Request& request, store::Uploads& uploads) {
  const std::uint64_t offset = http::ReadUploadNumber(request, "Upload-Offset");
  http::Response response;
  response.status = 204;
  AddState(TakePiece(request, uploads, request.Param("id"), offset), response);
  return response;
}

http::Response RemoveUpload(const http::Request& request, store::Uploads& uploads) {
  uploads.Remove(request.Param("id"));
  http::Response response;
  response.status = 204;
  return response;
}

// For clients that can send nothing but GET and POST.
http::Response OverriddenMethod(const http::Request& request, store::Uploads& uploads) {
  const std::string_view method = request.headers.Get("X-HTTP-Method-Override");
  if (method == "PATCH") return ContinueUpload(request, uploads);
  if (method == "DELETE") return RemoveUpload(request, uploads);
  if (method == "HEAD") return GetOffset(request, uploads);
  throw http::ProblemError("method-not-allowed",
                           "an upload takes POST only with X-HTTP-Method-Override: PATCH, DELETE "
                           "or HEAD")
      .WithHeader("Allow", "DELETE, HEAD, PATCH");
}

// What there is, for clients that ask before they send; of no version yet.
http::Response DescribeUploads(const store::Uploads& uploads) {
  http::Response response;
  response.status = 204;
  response.headers.Set("Tus-Resumable", std::string(http::kTusVersion));
  response.headers.Set("Tus-Version", std::string(http::kTusVersion));
  response.headers.Set("Tus-Extension", std::string(http::kTusExtensions));
  response.headers.Set("Tus-Max-Size", std::to_string(uploads.limits().max_bytes));
  response.headers.Set("Tus-Checksum-Algorithm", "sha256");
  return response;
}

}  // namespace

std::unique_ptr<store::UploadClaim> ClaimUpload(store::Uploads& uploads,
                                                const std::string& reference) {
  const std::string id(LocalName(Trim(reference)));
  try {
    return uploads.Claim(id);
  } catch (const store::UploadBusyError& error) {
    throw Locked(error);
  } catch (const Error& error) {
    if (error.code() != Code::kConflict) throw;
    throw Error(Code::kInvalid, error.what()).WithHint("send the rest, then refer to it");
  }
}

std::string UploadFileName(const store::UploadInfo& upload) {
  const auto metadata = http::ParseUploadMetadata(upload.metadata);
  const auto found = metadata.find("filename");
  return found == metadata.end() ? "" : http::SafeFileName(found->second);
}

void AddUploadRoutes(http::Router& router, Context& context) {
  store::Uploads& uploads = context.store.uploads();
  const auto add = [&](const char* method, const char* path, const char* operation, auto handler,
                       bool takes_piece) {
    router.Add({method, path, operation, InTus([handler, &uploads](const http::Request& request) {
                  return handler(request, uploads);
                }),
                takes_piece ? std::vector<std::string>{kPieceType} : std::vector<std::string>{},
                takes_piece ? kMaxPieceBytes : 0});
  };
  static const std::string one = std::string(kCollection) + "/{id}";
  add("POST", kCollection, "createUpload", CreateUpload, true);
  add("HEAD", one.c_str(), "getUploadOffset", GetOffset, false);
  add("PATCH", one.c_str(), "continueUpload", ContinueUpload, true);
  add("DELETE", one.c_str(), "removeUpload", RemoveUpload, false);
  add("POST", one.c_str(), "overrideUploadMethod", OverriddenMethod, true);
  router.Add({"OPTIONS",
              kCollection,
              "describeUploads",
              [&uploads](const http::Request&) { return DescribeUploads(uploads); },
              {},
              0});
}

}  // namespace lares::api
