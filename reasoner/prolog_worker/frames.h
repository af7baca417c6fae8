// Messages between a server and its worker process, over a local socket.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lares::prolog {

enum class FrameKind : char {
  kRequest = 'Q',  // with the snapshot's descriptor
  kAnswer = 'A',   // a JSON object
  kEnd = 'E',      // a JSON object: how it ended
};

struct Frame {
  FrameKind kind = FrameKind::kEnd;
  std::string bytes;
};

inline constexpr std::size_t kMaxFrame = 16u << 20;

// Waits until everything is with the kernel; false when the other side is gone. `passed`: a
// descriptor for the worker; -1: the worker itself sends, and is ended by SIGPIPE with its server.
bool SendFrame(int socket, FrameKind kind, std::string_view bytes, int passed = -1);

// For the worker: waits for one whole frame and the descriptor that comes with it. False when the
// other side is gone.
bool ReceiveFrame(int socket, Frame* frame, int* passed);

// For the server, which believes nothing: takes frames out of what has arrived.
class FrameReader {
 public:
  explicit FrameReader(int socket) : socket_(socket) {}

  enum class Got { kFrame, kTimeout, kClosed, kNonsense };
  // Whether something has arrived, after waiting for it up to `time`.
  bool InputWithin(std::chrono::milliseconds time) const;
  Got Next(Frame* frame, std::chrono::steady_clock::time_point deadline);

 private:
  Got Take(Frame* frame);

  int socket_;
  std::string input_;
  std::size_t taken_ = 0;
};

}  // namespace lares::prolog
