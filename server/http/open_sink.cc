#include "server/http/open_sink.h"

#include "base/error.h"

namespace lares::http {
namespace {

constexpr std::size_t kChunk = 32 * 1024;
constexpr std::chrono::milliseconds kPatience{100};

}  // namespace

void BufferedSink::Write(std::string_view bytes) {
  buffer_ += bytes;
  bytes_ += bytes.size();
  if (buffer_.size() >= kChunk || std::chrono::steady_clock::now() - sent_at_ > kPatience) Flush();
}

void BufferedSink::Flush() {
  const bool sent = (buffer_.empty() || write_(buffer_)) && connection_.Flush();
  buffer_.clear();
  if (!sent) throw Error(Code::kIo, "the client has gone");
  sent_at_ = std::chrono::steady_clock::now();
}

}  // namespace lares::http
