// One accepted socket: what has arrived, what is to be sent, and for how long we wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "server/http/long_transfers.h"
#include "server/http/tls.h"

namespace lares::http {

struct ConnectionLimits {
  std::size_t max_header_bytes = 32 * 1024;       // request line and all fields
  std::chrono::milliseconds header_time{10'000};  // from a request's first byte to its empty line
  std::chrono::milliseconds idle_time{30'000};    // between two requests
  std::chrono::milliseconds stall_time{10'000};   // without a byte moving in a body or response
  // A request whose body is announced to be no longer is waited for whole before a thread takes it.
  std::size_t max_gathered_bytes = 64 * 1024;
  // While the peer is waited for, over each `stall_time` of waiting.
  std::uint64_t min_bytes_per_second = 16 * 1024;
};

// Owns the descriptor. Used by one thread at a time.
class Connection {
 public:
  // `slow_readers`: places for threads that wait until a peer takes a short answer.
  Connection(int fd, std::string remote, const ConnectionLimits& limits,
             LongTransfers* slow_readers = nullptr, std::unique_ptr<TlsSession> tls = nullptr);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  enum class Arrived { kPart, kHeader, kTooLarge, kClosed };
  // Takes what is there without waiting, until a whole request header is, with its body when that
  // is short.
  Arrived Fill();
  // Sends what the peer takes at once: how many bytes, -1 once it has gone.
  long SendNow(std::string_view bytes);
  // The handshake of TLS waits for room to write instead of for bytes to read.
  bool wants_room() const { return wants_room_; }
  // Requests make sense: there is no TLS, or its handshake is done.
  bool is_open() const { return tls_ == nullptr || tls_->is_open(); }
  // Says that nothing more comes.
  void FinishSending() noexcept;
  // The transfer that follows has its place among the long ones: waiting takes no other.
  void MarkLong() { is_long_ = true; }
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
  // early, so that it gets to read the answer; when too many take their time, not this one. The
  // connection is of no use afterwards.
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
  // As recv() and send() with MSG_DONTWAIT: -1 with EAGAIN when the peer has to be waited for,
  // which `awaited_` then says how.
  long Receive(char* bytes, std::size_t size);
  long Send(const char* bytes, std::size_t size);
  long Judge(const TlsResult& result);
  bool ShakeHands();
  bool HasBody(std::size_t header_end) const;
  bool Wait(std::chrono::milliseconds time);
  bool WaitForRoom();
  bool TooSlow();
  void TakeRest(std::uint64_t bytes);

  int fd_;
  std::string remote_;
  const ConnectionLimits& limits_;
  LongTransfers* slow_readers_;
  std::unique_ptr<TlsSession> tls_;
  short awaited_ = 0;  // POLLIN or POLLOUT
  bool wants_room_ = false;
  bool is_long_ = false;
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
