#include "server/http/open_sink.h"

#include <cstdio>
#include <utility>

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
  if (buffer_.empty()) return;
  bool sent = std::exchange(begun_, true) || connection_.Write(head_());
  if (sent && chunked_) {
    char size[24];
    std::snprintf(size, sizeof size, "%zx\r\n", buffer_.size());
    sent = connection_.Write(size) && connection_.Write(buffer_) && connection_.Write("\r\n");
  } else if (sent) {
    sent = connection_.Write(buffer_);
  }
  sent = sent && connection_.Flush();
  buffer_.clear();
  if (!sent) throw Error(Code::kIo, "the client has gone");
  sent_at_ = std::chrono::steady_clock::now();
}

void BufferedSink::TryFlush() noexcept {
  try {
    Flush();
  } catch (const std::exception&) {  // it has gone: nobody is left to be told
  }
}

void BufferedSink::End() {
  Flush();
  if (chunked_ && (!connection_.Write("0\r\n\r\n") || !connection_.Flush())) {
    throw Error(Code::kIo, "the client has gone");
  }
}

}  // namespace lares::http
