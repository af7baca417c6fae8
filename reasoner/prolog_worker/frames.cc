#include "reasoner/prolog_worker/frames.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace lares::prolog {
namespace {

constexpr std::size_t kHeader = 1 + sizeof(std::uint32_t);
constexpr std::size_t kReadSize = 64 * 1024;

// The worker may only write(); a server must not be ended by a worker that is gone.
ssize_t WriteSome(int socket, std::string_view bytes, bool quietly) {
  return quietly ? ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                 : ::write(socket, bytes.data(), bytes.size());
}

bool WriteAll(int socket, std::string_view bytes, bool quietly) {
  while (!bytes.empty()) {
    const ssize_t written = WriteSome(socket, bytes, quietly);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool ReadAll(int socket, char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t got = ::read(socket, bytes, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

// The first byte of a frame carries the descriptor.
bool SendWithDescriptor(int socket, char byte, int passed) {
  iovec part{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(header), &passed, sizeof(int));
  return ::sendmsg(socket, &message, MSG_NOSIGNAL) == 1;
}

bool ReceiveWithDescriptor(int socket, char* byte, int* passed) {
  iovec part{byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  if (::recvmsg(socket, &message, MSG_CMSG_CLOEXEC) != 1) return false;
  const cmsghdr* const header = CMSG_FIRSTHDR(&message);
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    std::memcpy(passed, CMSG_DATA(header), sizeof(int));
  }
  return true;
}

std::uint32_t LengthIn(const char* bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes, sizeof length);
  return length;
}

}  // namespace

bool SendFrame(int socket, FrameKind kind, std::string_view bytes, int passed) {
  std::string frame(1, static_cast<char>(kind));
  const auto length = static_cast<std::uint32_t>(bytes.size());
  frame.append(reinterpret_cast<const char*>(&length), sizeof length);
  frame.append(bytes);
  if (passed < 0) return WriteAll(socket, frame, false);
  return SendWithDescriptor(socket, frame[0], passed) &&
         WriteAll(socket, std::string_view(frame).substr(1), true);
}

bool ReceiveFrame(int socket, Frame* frame, int* passed) {
  char header[kHeader];
  if (!ReceiveWithDescriptor(socket, header, passed) || !ReadAll(socket, header + 1, kHeader - 1)) {
    return false;
  }
  const std::size_t length = LengthIn(header + 1);
  if (length > kMaxFrame) return false;
  frame->kind = static_cast<FrameKind>(header[0]);
  frame->bytes.resize(length);
  return ReadAll(socket, frame->bytes.data(), length);
}

FrameReader::Got FrameReader::Take(Frame* frame) {
  const std::size_t left = input_.size() - taken_;
  if (left < kHeader) return Got::kTimeout;
  const char* const header = input_.data() + taken_;
  const std::size_t length = LengthIn(header + 1);
  const auto kind = static_cast<FrameKind>(header[0]);
  if (length > kMaxFrame || (kind != FrameKind::kAnswer && kind != FrameKind::kEnd)) {
    return Got::kNonsense;
  }
  if (left < kHeader + length) return Got::kTimeout;
  frame->kind = kind;
  frame->bytes.assign(header + kHeader, length);
  taken_ += kHeader + length;
  return Got::kFrame;
}

bool FrameReader::InputWithin(std::chrono::milliseconds time) const {
  if (taken_ < input_.size()) return true;
  pollfd wanted{socket_, POLLIN, 0};
  return ::poll(&wanted, 1, static_cast<int>(time.count())) > 0;
}

FrameReader::Got FrameReader::Next(Frame* frame, std::chrono::steady_clock::time_point deadline) {
  using std::chrono::milliseconds;
  while (true) {
    const Got got = Take(frame);
    if (got != Got::kTimeout) return got;
    input_.erase(0, taken_);
    taken_ = 0;
    const auto left = std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd wanted{socket_, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, static_cast<int>(std::max<long>(0, left.count())));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return Got::kTimeout;
    const std::size_t size = input_.size();
    input_.resize(size + kReadSize);
    const ssize_t count = ::recv(socket_, input_.data() + size, kReadSize, MSG_DONTWAIT);
    input_.resize(size + static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return Got::kClosed;
  }
}

}  // namespace lares::prolog
