#include "server/api/once.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "server/access/grant.h"
#include "server/api/json.h"
#include "server/http/log.h"
#include "server/http/media_type.h"
#include "server/http/multipart.h"
#include "server/http/problem.h"
#include "server/store/idempotency.h"

namespace lares::api {
namespace {

using State = store::KeyRecord::State;

// As it was sent, or as a quoted string of a structured field (RFC 8941).
std::string ReadKey(const http::Request& request) {
  std::string_view key = Trim(request.headers.Get("Idempotency-Key"));
  if (key.size() >= 2 && key.front() == '"' && key.back() == '"')
    key = key.substr(1, key.size() - 2);
  const bool visible =
      std::all_of(key.begin(), key.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (key.empty() || key.size() > 255 || !visible) {
    throw Error(Code::kInvalid, "Idempotency-Key is 1 to 255 visible ASCII characters");
  }
  // Keys of different tokens do not meet.
  const std::string owner = request.grant == nullptr ? "" : request.grant->token;
  return owner.empty() ? std::string(key) : owner + " " + std::string(key);
}

// What makes two requests the same one.
class Fingerprinter {
 public:
  explicit Fingerprinter(const http::Request& request) {
    Add(request.method);
    Add(request.path);
    for (const auto& [name, value] : request.query) {
      Add(name);
      Add(value);
    }
    for (const char* condition : {"If-Match", "If-None-Match"}) {
      Add(request.headers.GetList(condition));
    }
    const auto media = http::ParseMediaType(request.headers.Get("Content-Type"));
    Add(media ? media->type : "");
    if (!media || media->type != "multipart/form-data") return;
    form_ = std::make_unique<http::MultipartParser>(
        http::MultipartBoundary(request.headers.Get("Content-Type")),
        http::MultipartHandler{[this](const http::PartHeader& part) {
                                 Add(part.name);
                                 Add(part.file_name);
                                 Add(part.content_type);
                               },
                               [this](std::string_view bytes) { Stream(bytes); },
                               [this] { EndStream(); }},
        http::MultipartLimits{4096, 8192});  // what any form here may have
  }

  void Feed(std::string_view bytes) {
    if (form_ == nullptr) return Stream(bytes);
    if (malformed_) return;
    try {
      form_->Feed(bytes);
    } catch (const Error&) {
      malformed_ = true;  // the handler's to tell
    }
  }

  // Once the body was fed.
  std::string Hex() {
    if (hex_.empty()) {
      EndStream();
      hex_ = hash_.FinishHex();
    }
    return hex_;
  }

 private:
  void Stream(std::string_view bytes) {
    hash_.Update(bytes);
    streamed_ += bytes.size();
  }
  void EndStream() { hash_.Update("/" + std::to_string(std::exchange(streamed_, 0)) + "\n"); }
  void Add(std::string_view text) {
    Stream(text);
    EndStream();
  }

  Sha256 hash_;
  std::uint64_t streamed_ = 0;
  std::unique_ptr<http::MultipartParser> form_;
  bool malformed_ = false;
  std::string hex_;
};

http::Response Again(const store::KeyRecord& record) {
  http::Response response;
  response.status = record.status;
  for (const auto& field : Json::parse(record.headers)) {
    response.headers.Add(field.at(0).get<std::string>(), field.at(1).get<std::string>());
  }
  response.body = record.body;
  return response;
}

store::KeyRecord ToRecord(const http::Response& response, std::string fingerprint) {
  store::KeyRecord record;
  record.fingerprint = std::move(fingerprint);
  record.status = response.status;
  Json headers = Json::array();
  for (const auto& [name, value] : response.headers.all()) headers.push_back({name, value});
  record.headers = headers.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (const auto* text = std::get_if<std::string>(&response.body)) record.body = *text;
  return record;
}

// The request with its body read past the fingerprinter.
http::Request Watched(const http::Request& request,
                      const std::shared_ptr<Fingerprinter>& fingerprinter) {
  http::Request watched = request;
  watched.read_body = [read = request.read_body, fingerprinter](const http::Sink& sink) {
    read([&](std::string_view piece) {
      fingerprinter->Feed(piece);
      sink(piece);
    });
  };
  return watched;
}

http::Response AnswerAgain(const http::Request& request, const store::KeyRecord& record,
                           Fingerprinter& fingerprinter, const OnceHandler& handler) {
  request.read_body([&](std::string_view piece) { fingerprinter.Feed(piece); });
  if (fingerprinter.Hex() != record.fingerprint) {
    throw http::ProblemError("idempotency-key-reused",
                             "this Idempotency-Key was sent with another request before")
        .WithHint("take a new key for each new request, the old one only to repeat a request");
  }
  http::Response response =
      record.state == State::kWritten ? handler.recover(record.written) : Again(record);
  response.headers.Set("Idempotency-Replayed", "true");
  return response;
}

// What was written is written: that its answer cannot be kept is no fault of the request's.
void KeepAnswer(store::IdempotencyKeys& keys, const std::string& key, store::KeyRecord record) {
  try {
    keys.Finish(key, record);
  } catch (const Error& error) {
    http::Log(http::LogLevel::kWarning, "an answer was not kept for its idempotency key",
              {{"error", std::string(error.what())}});
  }
}

http::Response AnswerFirst(const http::Request& request, store::IdempotencyKeys& keys,
                           const std::string& key,
                           const std::shared_ptr<Fingerprinter>& fingerprinter,
                           const OnceHandler& handler) {
  http::Response response;
  try {
    response = handler.handle(Watched(request, fingerprinter),
                              {key, [fingerprinter] { return fingerprinter->Hex(); }});
  } catch (...) {
    keys.Release(key);
    throw;
  }
  if (response.status < 200 || response.status >= 300) {
    keys.Release(key);
  } else {
    KeepAnswer(keys, key, ToRecord(response, fingerprinter->Hex()));
  }
  return response;
}

}  // namespace

http::Handler Once(Context& context, OnceHandler handler) {
  return [&context, handler = std::move(handler)](const http::Request& request) {
    if (!request.headers.Has("Idempotency-Key")) return handler.handle(request, {});
    const std::string key = ReadKey(request);
    const auto fingerprinter = std::make_shared<Fingerprinter>(request);
    store::IdempotencyKeys& keys = context.store.idempotency_keys();
    const store::KeyRecord record = keys.Take(key);
    if (record.state == State::kInProgress) {
      throw http::ProblemError("request-in-progress",
                               "a request with this Idempotency-Key is being answered")
          .WithHeader("Retry-After", "1");
    }
    if (record.state != State::kNew) return AnswerAgain(request, record, *fingerprinter, handler);
    return AnswerFirst(request, keys, key, fingerprinter, handler);
  };
}

http::Handler Once(Context& context, http::Handler handler) {
  return Once(context, OnceHandler{[handler = std::move(handler)](const http::Request& request,
                                                                  const RequestMark&) {
                                     return handler(request);
                                   },
                                   nullptr});
}

}  // namespace lares::api
