#include "server/http/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "server/http/header_check.h"

namespace lares::http {
namespace {

constexpr std::size_t kReadBytes = 64 * 1024;
constexpr std::size_t kWriteBytes = 64 * 1024;
constexpr std::chrono::milliseconds kLingerTime{2000};
constexpr double kLingerPace = 1 << 20;  // bytes a second
constexpr std::string_view kHeaderEnd = "\r\n\r\n";

}  // namespace

Connection::Connection(int fd, std::string remote, const ConnectionLimits& limits,
                       LongTransfers* slow_readers, std::unique_ptr<TlsSession> tls)
    : fd_(fd),
      remote_(std::move(remote)),
      limits_(limits),
      slow_readers_(slow_readers),
      tls_(std::move(tls)),
      patience_(limits.stall_time) {}

Connection::~Connection() {
  if (tls_ != nullptr) tls_->Close();
  ::close(fd_);
}

long Connection::Judge(const TlsResult& result) {
  switch (result.kind) {
    case TlsResult::Kind::kMoved:
      return static_cast<long>(result.bytes);
    case TlsResult::Kind::kEnd:
      return 0;
    case TlsResult::Kind::kWantsRead:
    case TlsResult::Kind::kWantsWrite:
      awaited_ = result.kind == TlsResult::Kind::kWantsRead ? POLLIN : POLLOUT;
      errno = EAGAIN;
      return -1;
    case TlsResult::Kind::kFailed:
      break;
  }
  errno = ECONNRESET;
  return -1;
}

long Connection::Receive(char* bytes, std::size_t size) {
  if (tls_ != nullptr) return Judge(tls_->Read(bytes, size));
  awaited_ = POLLIN;
  return ::recv(fd_, bytes, size, MSG_DONTWAIT);
}

long Connection::Send(const char* bytes, std::size_t size) {
  if (tls_ != nullptr) return Judge(tls_->Write(bytes, size));
  awaited_ = POLLOUT;
  return ::send(fd_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL);
}

long Connection::SendNow(std::string_view bytes) {
  std::size_t sent_bytes = 0;
  while (sent_bytes < bytes.size()) {
    const long sent = Send(bytes.data() + sent_bytes, bytes.size() - sent_bytes);
    if (sent > 0) {
      sent_bytes += static_cast<std::size_t>(sent);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      break;
    } else if (errno != EINTR) {
      return -1;
    }
  }
  return static_cast<long>(sent_bytes);
}

void Connection::FinishSending() noexcept {
  if (tls_ != nullptr) tls_->Close();
  ::shutdown(fd_, SHUT_WR);
}

// False when the connection is of no use; else `is_open` tells whether it is done.
bool Connection::ShakeHands() {
  const TlsResult result = tls_->Handshake();
  wants_room_ = result.kind == TlsResult::Kind::kWantsWrite;
  return result.kind == TlsResult::Kind::kMoved || result.kind == TlsResult::Kind::kWantsRead ||
         wants_room_;
}

// Whether the body is there too, or none that is waited for.
bool Connection::HasBody(std::size_t header_end) const {
  const std::size_t end = header_end + kHeaderEnd.size();
  const std::size_t length = AwaitedLength(std::string_view(input_).substr(0, end));
  return length > limits_.max_gathered_bytes || input_.size() - end >= length;
}

Connection::Arrived Connection::Fill() {
  if (taken_ > 0) {
    input_.erase(0, taken_);
    taken_ = scanned_ = 0;
  }
  if (tls_ != nullptr && !tls_->is_open()) {
    if (!ShakeHands()) return Arrived::kClosed;
    if (!tls_->is_open()) return Arrived::kPart;
  }
  std::array<char, 16 * 1024> piece;
  while (true) {
    const std::size_t from = scanned_ < 3 ? 0 : scanned_ - 3;
    const std::size_t end = input_.find(kHeaderEnd, from);
    scanned_ = input_.size();
    if (std::min(end, input_.size()) > limits_.max_header_bytes) return Arrived::kTooLarge;
    if (end != std::string::npos) {
      scanned_ = end;
      if (HasBody(end)) return Arrived::kHeader;
    }
    const long got = Receive(piece.data(), piece.size());
    if (got > 0) {
      input_.append(piece.data(), static_cast<std::size_t>(got));
    } else if (got < 0 && errno == EINTR) {
      continue;
    } else if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      return Arrived::kPart;
    } else {
      // A peer that has finished in the middle of its body is told so.
      return got == 0 && end != std::string::npos ? Arrived::kHeader : Arrived::kClosed;
    }
  }
}

std::string Connection::TakeHeader() {
  const std::size_t end = input_.find(kHeaderEnd) + kHeaderEnd.size();
  std::string header = input_.substr(0, end);
  input_.erase(0, end);
  scanned_ = 0;
  return header;
}

void Connection::PutBack(std::string header) { input_.insert(0, header); }

void Connection::BeginRequest() {
  bytes_in_ = bytes_out_ = moved_ = 0;
  is_long_ = false;
  waited_ = {};
}

bool Connection::Wait(std::chrono::milliseconds time) {
  pollfd waiting{fd_, awaited_, 0};
  const auto start = std::chrono::steady_clock::now();
  int ready = -1;
  do {
    ready = ::poll(&waiting, 1, static_cast<int>(time.count()));
  } while (ready < 0 && errno == EINTR);
  waited_ += std::chrono::steady_clock::now() - start;
  if (ready == 0) stalled_ = true;
  return ready > 0;
}

// Slow readers of short answers must not hold every thread: beyond their places they are given up.
bool Connection::WaitForRoom() {
  if (is_long_ || slow_readers_ == nullptr) return Wait(limits_.stall_time);
  if (!slow_readers_->TryBegin()) return false;
  const bool has_room = Wait(limits_.stall_time);
  slow_readers_->End();
  return has_room;
}

bool Connection::TooSlow() {
  if (waited_ <= limits_.stall_time) return false;
  const double seconds = std::chrono::duration<double>(waited_).count();
  const bool slow =
      static_cast<double>(moved_) < seconds * static_cast<double>(limits_.min_bytes_per_second);
  waited_ = {};
  moved_ = 0;
  return slow;
}

long Connection::Read(char* bytes, std::size_t size) {
  if (read_failed_) return -1;
  if (!has_input()) {
    if (TooSlow()) {
      stalled_ = read_failed_ = true;
      return -1;
    }
    if (!Flush()) return -1;  // the peer may be waiting for what we said (100 Continue)
    input_.resize(kReadBytes);
    taken_ = 0;
    long got = -1;
    while (got < 0) {
      got = Receive(input_.data(), input_.size());
      if (got >= 0 || errno == EINTR) continue;
      if ((errno != EAGAIN && errno != EWOULDBLOCK) || !Wait(patience_)) break;
    }
    input_.resize(static_cast<std::size_t>(std::max<long>(got, 0)));
    scanned_ = 0;
    moved_ += input_.size();
    if (got <= 0) {
      read_failed_ = true;
      return got;
    }
  }
  const std::size_t count = std::min(size, input_.size() - taken_);
  std::memcpy(bytes, input_.data() + taken_, count);
  taken_ += count;
  bytes_in_ += count;
  return static_cast<long>(count);
}

bool Connection::Write(std::string_view bytes) {
  output_ += bytes;
  bytes_out_ += bytes.size();
  return output_.size() < kWriteBytes ? !write_failed_ : Flush();
}

bool Connection::Flush() {
  std::string_view rest = output_;
  while (!rest.empty() && !write_failed_) {
    const long sent = Send(rest.data(), rest.size());
    if (sent >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(sent));
      moved_ += static_cast<std::size_t>(sent);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      write_failed_ = TooSlow() || !WaitForRoom();
    } else if (errno != EINTR) {
      write_failed_ = true;
    }
  }
  output_.clear();
  return !write_failed_;
}

void Connection::Linger(std::uint64_t bytes) {
  Flush();
  FinishSending();
  if (slow_readers_ != nullptr && !slow_readers_->TryBegin()) return;
  TakeRest(bytes);
  if (slow_readers_ != nullptr) slow_readers_->End();
}

void Connection::TakeRest(std::uint64_t bytes) {
  patience_ = std::min(patience_, kLingerTime);
  const auto start = std::chrono::steady_clock::now();
  std::array<char, 16 * 1024> piece;
  for (std::uint64_t taken = 0; bytes > 0;) {
    const long got = Read(piece.data(), std::min<std::uint64_t>(piece.size(), bytes));
    if (got <= 0) return;
    bytes -= static_cast<std::uint64_t>(got);
    taken += static_cast<std::uint64_t>(got);
    const auto elapsed = std::chrono::steady_clock::now() - start;
    const double seconds = std::chrono::duration<double>(elapsed).count();
    if (elapsed > kLingerTime && static_cast<double>(taken) < seconds * kLingerPace) return;
  }
}

}  // namespace lares::http
