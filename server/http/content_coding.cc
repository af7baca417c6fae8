#include "server/http/content_coding.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"
#include "server/http/zstd.h"

namespace lares::http {
namespace {

constexpr std::uint64_t kWorthwhile = 1024;
constexpr std::uint64_t kAtOnce = 1 << 20;  // up to here the length is known beforehand
constexpr std::string_view kSuffix = "-zstd";
constexpr std::chrono::milliseconds kPatience{100};

// Handed on to the client like any other open body, at the pace at which it is made.
class EncodingSink : public OpenSink {
 public:
  explicit EncodingSink(OpenSink& to)
      : to_(to), give_([&to](std::string_view piece) { to.Write(piece); }) {}

  void Write(std::string_view bytes) override {
    encoder_.Feed(bytes, give_);
    if (std::chrono::steady_clock::now() - flushed_at_ > kPatience) Flush();
  }
  void Flush() override {
    encoder_.Flush(give_);
    to_.Flush();
    flushed_at_ = std::chrono::steady_clock::now();
  }
  std::stop_token gone() override { return to_.gone(); }
  void End() { encoder_.End(give_); }

 private:
  OpenSink& to_;
  Sink give_;
  ZstdEncoder encoder_;
  std::chrono::steady_clock::time_point flushed_at_ = std::chrono::steady_clock::now();
};

void ReadFileBody(const FileBody& file, const Sink& sink) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.path.c_str(), "rb"),
                                                               &std::fclose);
  const bool placed =
      handle && ::fseeko(handle.get(), static_cast<off_t>(file.offset), SEEK_SET) == 0;
  std::array<char, 64 * 1024> piece;
  for (std::uint64_t left = file.length; left > 0;) {
    const std::size_t wanted = std::min<std::uint64_t>(piece.size(), left);
    const std::size_t got = placed ? std::fread(piece.data(), 1, wanted, handle.get()) : 0;
    if (got == 0) throw Error(Code::kIo, "cannot read '" + file.path.string() + "'");
    sink({piece.data(), got});
    left -= got;
  }
}

// Of every body with a length.
void Produce(const decltype(Response::body)& body, const Sink& sink) {
  if (const auto* text = std::get_if<std::string>(&body)) {
    sink(*text);
  } else if (const auto* file = std::get_if<FileBody>(&body)) {
    ReadFileBody(*file, sink);
  } else if (const auto* stream = std::get_if<StreamBody>(&body)) {
    stream->produce(sink);
  }
}

std::string CompressedAtOnce(const decltype(Response::body)& body) {
  std::string compressed;
  const Sink give = [&compressed](std::string_view piece) { compressed += piece; };
  ZstdEncoder encoder;
  Produce(body, [&](std::string_view piece) { encoder.Feed(piece, give); });
  encoder.End(give);
  return compressed;
}

OpenBody CompressedWhileSent(decltype(Response::body) body) {
  const auto kept = std::make_shared<const decltype(Response::body)>(std::move(body));
  return {[kept](OpenSink& to) {
    EncodingSink sink(to);
    if (const auto* open = std::get_if<OpenBody>(kept.get())) {
      open->produce(sink);
    } else {
      Produce(*kept, [&sink](std::string_view piece) { sink.Write(piece); });
    }
    sink.End();
  }};
}

}  // namespace

bool AcceptsZstd(std::string_view accept_encoding) {
  for (const std::string& entry : Split(accept_encoding, ',')) {
    const std::size_t semicolon = entry.find(';');
    if (ToLower(Trim(std::string_view(entry).substr(0, semicolon))) != "zstd") continue;
    if (semicolon == std::string::npos) return true;
    const std::string weight = ToLower(Trim(std::string_view(entry).substr(semicolon + 1)));
    return !weight.starts_with("q=") || weight.find_first_of("123456789") != std::string::npos;
  }
  return false;
}

bool IsCompressible(std::string_view media_type) {
  const auto media = ParseMediaType(media_type);
  if (!media) return false;
  const std::string& type = media->type;
  if (type.starts_with("text/")) return type != "text/event-stream";
  if (type.ends_with("+json") || type.ends_with("+xml")) return true;
  static constexpr std::array<std::string_view, 13> kTypes = {
      "application/json",       "application/xml",          "application/yaml",
      "application/trig",       "application/n-triples",    "application/n-quads",
      "application/x-ndjson",   "application/javascript",   "application/x-tar",
      "application/x-octomap",  "image/x-portable-graymap", "application/ply",
      "image/x-portable-pixmap"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

std::string ZstdTag(const std::string& etag) {
  if (etag.size() < 2 || !etag.ends_with('"')) return etag;
  return etag.substr(0, etag.size() - 1) + std::string(kSuffix) + "\"";
}

std::string IdentityTag(const std::string& etag) {
  const std::string end = std::string(kSuffix) + "\"";
  if (!etag.ends_with(end)) return etag;
  return etag.substr(0, etag.size() - end.size()) + "\"";
}

bool ChooseZstd(const Request& request, Response& response) {
  const bool whole = response.status == 200 || response.status == 201;
  const bool open = std::holds_alternative<OpenBody>(response.body);
  if (!whole || std::holds_alternative<EventsBody>(response.body) ||
      (!open && BodyLength(response) < kWorthwhile) || response.headers.Has("Content-Encoding") ||
      !IsCompressible(response.headers.Get("Content-Type"))) {
    return false;
  }
  const std::string vary = response.headers.GetList("Vary");
  response.headers.Set("Vary", vary.empty() ? "Accept-Encoding" : vary + ", Accept-Encoding");
  return AcceptsZstd(request.headers.GetList("Accept-Encoding")) && !request.headers.Has("Range");
}

void EncodeAsZstd(const Request& request, Response& response) {
  response.headers.Set("Content-Encoding", "zstd");
  response.headers.Remove("Accept-Ranges");  // ranges are of the body as it is
  response.headers.Remove("Content-Length");
  if (request.method == "HEAD") {
    response.body = OpenBody{[](OpenSink&) {}};
  } else if (!std::holds_alternative<OpenBody>(response.body) && BodyLength(response) <= kAtOnce) {
    response.body = CompressedAtOnce(response.body);
  } else {
    response.body = CompressedWhileSent(std::move(response.body));
  }
}

void CheckContentEncoding(const Request& request) {
  const std::string coding = ToLower(Trim(request.headers.GetList("Content-Encoding")));
  if (coding.empty() || coding == "identity" || coding == "zstd") return;
  throw ProblemError("unsupported",
                     "bodies are taken as they are or as zstd, not as " + coding.substr(0, 80))
      .WithHeader("Accept-Encoding", "zstd");
}

bool IsZstd(const Request& request) {
  return request.has_body && request.headers.Has("Content-Encoding") &&
         ToLower(Trim(request.headers.GetList("Content-Encoding"))) == "zstd";
}

Request Decoded(const Request& request, std::uint64_t max_bytes) {
  Request decoded = request;
  decoded.content_length.reset();
  decoded.read_body = [read = request.read_body, max_bytes](const Sink& sink) {
    DecodeLimits limits;
    limits.max_bytes = max_bytes;
    ZstdDecoder decoder(limits);
    read([&](std::string_view piece) { decoder.Feed(piece, sink); });
    decoder.Finish();
  };
  return decoded;
}

}  // namespace lares::http
