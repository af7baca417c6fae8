// One accepted socket: what has arrived, what is to be sent, and for how long we wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace lares::http {

struct ConnectionLimits {
  std::size_t max_header_bytes = 32 * 1024;       // request line and all fields
  std::chrono::milliseconds header_time{10'000};  // from a request's first byte to its empty line
  std::chrono::milliseconds idle_time{30'000};    // between two requests
  std::chrono::milliseconds stall_time{10'000};   // without a byte moving in a body or response
  // While the peer is waited for, over each `stall_time` of waiting.
  std::uint64_t min_bytes_per_second = 16 * 1024;
};

// Owns the descriptor. Used by one thread at a time.
class Connection {
 public:
  Connection(int fd, std::string remote, const ConnectionLimits& limits);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  enum class Arrived { kPart, kHeader, kTooLarge, kClosed };
  // Takes what is there without waiting, until a whole request header is.
  Arrived Fill();
  // The header that Fill() found, with its empty line; for changes before it is read.
  std::string TakeHeader();
  void PutBack(std::string header);

  // Waits for at least one byte: the number read, 0 at the end, -1 on failure or when the peer
  // stalls. `stalled()` tells the two apart.
  long Read(char* bytes, std::size_t size);
  // Buffers; false once the peer is gone.
  bool Write(std::string_view bytes);
  bool Flush();
  // Lets the peer finish sending (up to `bytes`, and only at a good pace) after it was answered
  // early, so that it gets to read the answer; the connection is of no use afterwards.
  void Linger(std::uint64_t bytes);

  // A token that is stopped when the peer goes away before the request is answered; `watch` of
  // SetWatch gives it.
  std::stop_token WatchPeer() const { return watch_ ? watch_() : std::stop_token(); }
  void SetWatch(std::function<std::stop_token()> watch) { watch_ = std::move(watch); }

  void BeginRequest();
  bool has_input() const { return input_.size() > taken_; }
  bool stalled() const { return stalled_; }
  std::uint64_t bytes_in() const { return bytes_in_; }    // read since BeginRequest
  std::uint64_t bytes_out() const { return bytes_out_; }  // written since BeginRequest
  int fd() const { return fd_; }
  const std::string& remote() const { return remote_; }

 private:
  bool Wait(short events, std::chrono::milliseconds time);
  bool TooSlow();

  int fd_;
  std::string remote_;
  const ConnectionLimits& limits_;
  std::function<std::stop_token()> watch_;
  std::chrono::milliseconds patience_;  // with a peer that sends nothing
  std::string input_;
  std::size_t taken_ = 0;    // of input_
  std::size_t scanned_ = 0;  // of input_, for the empty line
  std::string output_;
  bool read_failed_ = false;
  bool write_failed_ = false;
  bool stalled_ = false;
  std::uint64_t bytes_in_ = 0;
  std::uint64_t bytes_out_ = 0;
  // Since BeginRequest or the last look at the pace.
  std::chrono::steady_clock::duration waited_{};  // for the peer
  std::uint64_t moved_ = 0;                       // bytes, either way
};

}  // namespace lares::http
