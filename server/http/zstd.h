// Zstandard (RFC 8878) in pieces and in constant memory; the one door to libzstd.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "server/http/message.h"

namespace lares::http {

struct DecodeLimits {
  std::uint64_t max_bytes = UINT64_MAX;  // decoded
  // Beyond so many decoded bytes, not more than `max_ratio` of them for each that was sent.
  std::uint64_t ratio_free_bytes = std::uint64_t{256} << 20;
  std::uint64_t max_ratio = 200;
  int max_window_log = 23;  // 8 MiB of memory, what RFC 8878 asks every decoder to have
};

// One or more frames. Throws kTooLarge for a limit, "bad-request" for what is no Zstandard; what
// the sink throws passes through. Not usable after a throw.
class ZstdDecoder {
 public:
  explicit ZstdDecoder(const DecodeLimits& limits);
  ~ZstdDecoder();
  ZstdDecoder(const ZstdDecoder&) = delete;
  ZstdDecoder& operator=(const ZstdDecoder&) = delete;

  void Feed(std::string_view bytes, const Sink& sink);
  void Finish() const;  // throws "bad-request" in the middle of a frame

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// One frame.
class ZstdEncoder {
 public:
  ZstdEncoder();
  ~ZstdEncoder();
  ZstdEncoder(const ZstdEncoder&) = delete;
  ZstdEncoder& operator=(const ZstdEncoder&) = delete;

  void Feed(std::string_view bytes, const Sink& sink);
  void Flush(const Sink& sink);  // all that was fed can be decoded from what was sunk
  void End(const Sink& sink);    // once, at the end

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
