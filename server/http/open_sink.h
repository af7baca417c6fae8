// Bytes of an answer whose length is not known, gathered into chunks worth sending.
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
  // `write` frames and buffers a piece for `connection`; false once the peer has gone.
  BufferedSink(Connection& connection, std::function<bool(std::string_view)> write)
      : connection_(connection), write_(std::move(write)) {}

  void Write(std::string_view bytes) override;
  void Flush() override;
  std::stop_token gone() override { return connection_.WatchPeer(); }
  std::uint64_t bytes() const { return bytes_; }

 private:
  Connection& connection_;
  std::function<bool(std::string_view)> write_;
  std::string buffer_;
  std::uint64_t bytes_ = 0;
  std::chrono::steady_clock::time_point sent_at_ = std::chrono::steady_clock::now();
};

}  // namespace lares::http
