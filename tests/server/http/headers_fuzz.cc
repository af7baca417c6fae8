// One text through every reader of a header's value.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "server/http/content_coding.h"
#include "server/http/etag.h"
#include "server/http/header_check.h"
#include "server/http/media_type.h"
#include "server/http/origin_check.h"
#include "server/http/range.h"
#include "server/http/tus.h"
#include "server/http/url.h"

namespace {

// What is no fault of the interface's own must come out as a refusal.
template <typename Read>
void Try(const Read& read) {
  try {
    read();
  } catch (const lares::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::uint64_t length : {std::uint64_t{0}, std::uint64_t{10}, UINT64_MAX}) {
    const lares::http::ByteRange range = lares::http::ParseRange(text, length);
    if (range.kind != lares::http::ByteRange::Kind::kPart) continue;
    if (range.length == 0 || range.offset >= length || range.length > length - range.offset) {
      std::abort();
    }
  }
  lares::http::ParseEntityTags(text);
  lares::http::NoneMatchHits(text, "\"a\"");
  lares::http::ParseMediaType(text);
  lares::http::ChooseMediaType(text, {"text/turtle", "application/rdf+xml"});
  lares::http::ParseQuery(text);
  lares::http::AwaitedLength(text);
  lares::http::AwaitedLength("GET / HTTP/1.1\r\nContent-Length:" + std::string(text));
  lares::http::PercentDecode(text);
  lares::http::AcceptsZstd(text);
  const auto bytes = lares::http::DecodeBase64(text);
  if (bytes && bytes->size() > text.size()) std::abort();
  lares::http::Request request;
  request.method = "PUT";
  for (const char* name : {"Host", "Origin", "Upload-Offset"}) {
    request.headers.Add(name, std::string(text));
  }
  Try([&] { lares::http::CheckOrigin(request); });
  Try([&] {
    if (lares::http::ReadUploadNumber(request, "Upload-Offset") > INT64_MAX) std::abort();
  });
  Try([&] {
    if (lares::http::ParseUploadMetadata(text).count("") != 0) std::abort();
  });
  Try([&] {
    const auto checksum = lares::http::ParseUploadChecksum(text);
    if (checksum && checksum->size() != 64) std::abort();
  });
  return 0;
}
