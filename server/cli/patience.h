// Asking again after a broken connection, for as long as that is worth it.
#pragma once

#include <chrono>
#include <exception>

namespace lares::cli {

// Whether the same request may work in a moment: the connection broke, or the server was still busy
// with what was sent over the one before.
bool IsPassing(const std::exception& error);

// Used by one thread.
class Patience {
 public:
  explicit Patience(std::chrono::seconds time) : time_(time) {}

  // Something went well: the waiting begins anew, should it have to.
  void Progress() { waiting_ = false; }
  // Waits a little longer each time. False, at once, when nothing has gone well for the whole time,
  // or the user asked to stop.
  bool Wait();

 private:
  std::chrono::seconds time_;
  bool waiting_ = false;
  std::chrono::steady_clock::time_point since_{};
  std::chrono::milliseconds pause_{};
};

}  // namespace lares::cli
