// Any bytes as a body of Content-Encoding: zstd, in pieces of any size: decoded within the limits
// or refused; and every text comes back from its compressed form.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "server/http/zstd.h"

namespace {

std::string Decode(std::string_view bytes, std::size_t piece,
                   const lares::http::DecodeLimits& limits) {
  std::string decoded;
  lares::http::ZstdDecoder decoder(limits);
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    decoder.Feed(bytes.substr(at, piece), [&](std::string_view part) { decoded += part; });
    if (decoded.size() > limits.max_bytes) std::abort();
  }
  decoder.Finish();
  return decoded;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  lares::http::DecodeLimits limits;
  limits.max_bytes = 1 << 20;
  const std::size_t piece = size == 0 ? 1 : 1 + data[0] % 64;
  try {
    Decode(text, piece, limits);
  } catch (const lares::Error&) {
  }
  std::string encoded;
  lares::http::ZstdEncoder encoder;
  const auto give = [&](std::string_view part) { encoded += part; };
  encoder.Feed(text.substr(0, size / 2), give);
  if (size % 2 == 0) encoder.Flush(give);
  encoder.Feed(text.substr(size / 2), give);
  encoder.End(give);
  limits.max_bytes = size;
  if (Decode(encoded, piece, limits) != text) std::abort();
  return 0;
}
