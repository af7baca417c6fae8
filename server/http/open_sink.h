// An answer whose length is not known: held back until there is a chunk worth sending, so that a
// short one gets a length and an early fault a status of its own.
#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "server/http/connection.h"
#include "server/http/message.h"

namespace lares::http {

class BufferedSink : public OpenSink {
 public:
  // `head` is what goes before the first chunk, up to the empty line.
  BufferedSink(Connection& connection, std::function<std::string()> head, bool chunked)
      : connection_(connection), head_(std::move(head)), chunked_(chunked) {}

  void Write(std::string_view bytes) override;
  void Flush() override;
  std::stop_token gone() override { return connection_.WatchPeer(); }

  // Whether the head was sent.
  bool begun() const { return begun_; }
  std::string TakeBuffered() { return std::move(buffer_); }
  // Flush without a word about a client that has gone.
  void TryFlush() noexcept;
  // The last chunk, of what has begun.
  void End();
  std::uint64_t bytes() const { return bytes_; }

 private:
  Connection& connection_;
  std::function<std::string()> head_;
  const bool chunked_;
  bool begun_ = false;
  std::string buffer_;
  std::uint64_t bytes_ = 0;
  std::chrono::steady_clock::time_point sent_at_ = std::chrono::steady_clock::now();
};

}  // namespace lares::http
