#include "server/http/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace lares::http {
namespace {

constexpr std::size_t kReadBytes = 64 * 1024;
constexpr std::size_t kWriteBytes = 64 * 1024;
constexpr std::chrono::milliseconds kLingerTime{2000};
constexpr double kLingerPace = 1 << 20;  // bytes a second
constexpr std::string_view kHeaderEnd = "\r\n\r\n";

}  // namespace

Connection::Connection(int fd, std::string remote, const ConnectionLimits& limits)
    : fd_(fd), remote_(std::move(remote)), limits_(limits), patience_(limits.stall_time) {}

Connection::~Connection() { ::close(fd_); }

Connection::Arrived Connection::Fill() {
  if (taken_ > 0) {
    input_.erase(0, taken_);
    taken_ = scanned_ = 0;
  }
  std::array<char, 16 * 1024> piece;
  while (true) {
    const std::size_t from = scanned_ < 3 ? 0 : scanned_ - 3;
    const std::size_t end = input_.find(kHeaderEnd, from);
    scanned_ = input_.size();
    if (std::min(end, input_.size()) > limits_.max_header_bytes) return Arrived::kTooLarge;
    if (end != std::string::npos) {
      scanned_ = end;
      return Arrived::kHeader;
    }
    const ssize_t got = ::recv(fd_, piece.data(), piece.size(), MSG_DONTWAIT);
    if (got > 0) {
      input_.append(piece.data(), static_cast<std::size_t>(got));
    } else if (got < 0 && errno == EINTR) {
      continue;
    } else {
      return got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? Arrived::kPart
                                                                  : Arrived::kClosed;
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
  waited_ = {};
}

bool Connection::Wait(short events, std::chrono::milliseconds time) {
  pollfd waiting{fd_, events, 0};
  const auto start = std::chrono::steady_clock::now();
  int ready = -1;
  do {
    ready = ::poll(&waiting, 1, static_cast<int>(time.count()));
  } while (ready < 0 && errno == EINTR);
  waited_ += std::chrono::steady_clock::now() - start;
  if (ready == 0) stalled_ = true;
  return ready > 0;
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
    ssize_t got = -1;
    while (got < 0) {
      got = ::recv(fd_, input_.data(), input_.size(), MSG_DONTWAIT);
      if (got >= 0 || errno == EINTR) continue;
      if ((errno != EAGAIN && errno != EWOULDBLOCK) || !Wait(POLLIN, patience_)) break;
    }
    input_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    scanned_ = 0;
    moved_ += input_.size();
    if (got <= 0) {
      read_failed_ = true;
      return static_cast<long>(got);
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
    const ssize_t sent = ::send(fd_, rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(sent));
      moved_ += static_cast<std::size_t>(sent);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      write_failed_ = TooSlow() || !Wait(POLLOUT, limits_.stall_time);
    } else if (errno != EINTR) {
      write_failed_ = true;
    }
  }
  output_.clear();
  return !write_failed_;
}

void Connection::Linger(std::uint64_t bytes) {
  Flush();
  ::shutdown(fd_, SHUT_WR);
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
