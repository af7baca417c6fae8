#include "server/http/service.h"

#include <algorithm>
#include <new>
#include <random>

#include "base/error.h"
#include "base/text.h"
#include "server/http/content_coding.h"
#include "server/http/etag.h"
#include "server/http/log.h"
#include "server/http/media_type.h"
#include "server/http/origin_check.h"
#include "server/http/problem.h"
#include "server/http/range.h"

namespace lares::http {
namespace {

void CheckBody(const Route& route, const Request& request) {
  if (!request.has_body) return;
  if (route.consumes.empty()) {
    if (request.content_length == 0) return;
    throw ProblemError("bad-request", route.method + " " + route.path + " takes no body");
  }
  CheckContentEncoding(request);
  if (request.content_length && *request.content_length > route.max_body_bytes) {
    throw Error(Code::kTooLarge, "the body has " + std::to_string(*request.content_length) +
                                     " bytes; " + std::to_string(route.max_body_bytes) +
                                     " are allowed here");
  }
  const auto media = ParseMediaType(request.headers.Get("Content-Type"));
  const auto fits = [&media](const std::string& accepted) {
    return accepted == "*/*" || (media && media->type == accepted);
  };
  if (!std::any_of(route.consumes.begin(), route.consumes.end(), fits)) {
    throw Error(Code::kUnsupported,
                request.headers.Has("Content-Type")
                    ? "'" + std::string(request.headers.Get("Content-Type")) + "' is not taken here"
                    : std::string("the request has a body but no Content-Type"))
        .WithHint("send one of: " + Join(route.consumes, ", "));
  }
}

void Slice(Response& response, const ByteRange& range) {
  if (auto* file = std::get_if<FileBody>(&response.body)) {
    file->offset += range.offset;
    file->length = range.length;
  } else if (auto* text = std::get_if<std::string>(&response.body)) {
    *text = text->substr(range.offset, range.length);
  }
}

// Range (with If-Range) on what a handler marked with "Accept-Ranges: bytes".
void ApplyRange(const Request& request, Response& response) {
  if (response.headers.Get("Accept-Ranges") != "bytes" || request.method != "GET") return;
  const std::string* header = request.headers.Find("Range");
  if (header == nullptr) return;
  const std::string* if_range = request.headers.Find("If-Range");
  if (if_range != nullptr && Trim(*if_range) != response.headers.Get("ETag")) return;
  const std::uint64_t size = BodyLength(response);
  const ByteRange range = ParseRange(*header, size);
  if (range.kind == ByteRange::Kind::kWhole) return;
  if (range.kind == ByteRange::Kind::kUnsatisfiable) {
    throw ProblemError("range-not-satisfiable",
                       "the content has " + std::to_string(size) + " bytes")
        .WithHeader("Content-Range", FormatContentRange(range, size));
  }
  Slice(response, range);
  response.headers.Set("Content-Range", FormatContentRange(range, size));
  response.status = 206;
}

// 304 when the client has the answer in either form; its tag is then that of the form.
bool ApplyNoneMatch(const Request& request, Response& response) {
  if (response.status != 200 || (request.method != "GET" && request.method != "HEAD")) return false;
  const std::string if_none_match = request.headers.GetList("If-None-Match");
  const std::string own(response.headers.Get("ETag"));
  const std::string other = IdentityTag(own) == own ? ZstdTag(own) : IdentityTag(own);
  const bool hits_own = NoneMatchHits(if_none_match, own);
  if (!hits_own && !NoneMatchHits(if_none_match, other)) return false;
  if (!hits_own) response.headers.Set("ETag", other);
  response.status = 304;
  response.headers.Remove("Content-Type");
  response.headers.Remove("Content-Length");
  response.body = std::string();
  return true;
}

void ApplyConditions(const Request& request, Response& response) {
  const bool encode = ChooseZstd(request, response);
  if (encode && response.headers.Has("ETag")) {
    response.headers.Set("ETag", ZstdTag(std::string(response.headers.Get("ETag"))));
  }
  if (ApplyNoneMatch(request, response)) return;
  if (encode) {
    EncodeAsZstd(request, response);
  } else if (response.status == 200) {
    ApplyRange(request, response);
  }
}

void Finish(const Request& request, Response& response) {
  response.headers.Set("X-Request-Id", request.id);
  response.headers.Set("X-Content-Type-Options", "nosniff");
  if (!response.headers.Has("Cache-Control")) response.headers.Set("Cache-Control", "no-cache");
}

}  // namespace

std::string RequestId(std::string_view sent) {
  const auto fine = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == ':' || c == '-';
  };
  if (!sent.empty() && sent.size() <= 128 && std::all_of(sent.begin(), sent.end(), fine)) {
    return std::string(sent);
  }
  static constexpr char kHex[] = "0123456789abcdef";
  thread_local std::mt19937_64 random{std::random_device{}()};
  std::string id;
  for (std::uint64_t bits = random(); id.size() < 16; bits >>= 4) id += kHex[bits & 15];
  return id;
}

Response Service::Refuse(const std::exception& error, const std::string& request_id) {
  if (const auto* fault = dynamic_cast<const Error*>(&error)) {
    return ToProblem(*fault, request_id);
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return ToProblem(Error(Code::kUnavailable, "the server is out of memory"), request_id);
  }
  Log(LogLevel::kError, "a handler failed",
      {{"request_id", request_id}, {"error", std::string(error.what())}});
  return ToProblem(Error(Code::kInternal, error.what()), request_id);
}

Response Service::Refuse(const std::exception& error, const Request& request) {
  Response response = Refuse(error, request.id);
  Finish(request, response);
  return response;
}

Service::Admission Service::Admit(Request& request) const {
  Admission admission;
  request.id = RequestId(request.headers.Get("X-Request-Id"));
  try {
    CheckOrigin(request, options_.origins);
    Router::Match match = router_.Find(request.method, request.path);
    if (match.route == nullptr && match.allow.empty()) {
      throw Error(Code::kNotFound, "there is no '" + request.path + "' here")
          .WithHint("GET /openapi.json lists every path");
    }
    if (match.route == nullptr) {
      const std::string allow = Join(match.allow, ", ");
      throw ProblemError("method-not-allowed", request.path + " takes " + allow)
          .WithHeader("Allow", allow);
    }
    admission.route = match.route;
    request.params = std::move(match.params);
    if (options_.gatekeeper != nullptr) options_.gatekeeper->Admit(*match.route, request);
    CheckBody(*match.route, request);
  } catch (const std::exception& error) {
    admission.refusal = Refuse(error, request);
    if (options_.gatekeeper != nullptr && request.grant != nullptr) {
      options_.gatekeeper->Answered(*admission.route, request, *admission.refusal);
    }
  }
  return admission;
}

Response Service::Run(const Route& route, Request& request) const {
  Response response;
  try {
    if (options_.gatekeeper != nullptr) options_.gatekeeper->Begin(route, request);
    response = IsZstd(request) ? route.handler(Decoded(request, route.max_body_bytes))
                               : route.handler(request);
    ApplyConditions(request, response);
  } catch (const std::exception& error) {
    response = Refuse(error, request.id);
  }
  Finish(request, response);
  if (options_.gatekeeper != nullptr && request.grant != nullptr) {
    options_.gatekeeper->Answered(route, request, response);
  }
  return response;
}

Response Service::Answer(Request request) const {
  Admission admission = Admit(request);
  return admission.refusal ? std::move(*admission.refusal) : Run(*admission.route, request);
}

}  // namespace lares::http
