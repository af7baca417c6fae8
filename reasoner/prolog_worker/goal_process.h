// A worker process as its parent holds it. Inside this folder, and for tests.
#pragma once

#include <sys/types.h>

#include <string>

namespace lares::prolog {

// How a process ended.
struct ProcessEnd {
  int signal = 0;     // 0: it exited by itself
  int exit_code = 0;  // when it did
};

// Owns a child process and one end of a socket to it. Not thread-safe, Kill() apart.
class GoalProcess {
 public:
  // Runs `program prolog-worker` with the socket, /dev/null three times, and nothing else of this
  // process: no descriptor, no environment, no signal mask. Throws kUnavailable.
  explicit GoalProcess(const std::string& program);
  // Kills and reaps it: whatever it was doing, it is gone afterwards.
  ~GoalProcess();
  GoalProcess(const GoalProcess&) = delete;
  GoalProcess& operator=(const GoalProcess&) = delete;

  int socket() const { return socket_; }
  pid_t pid() const { return pid_; }
  // From any thread, while the object lives and End() has not been called.
  void Kill() const;
  // Kills it when it still runs, and reaps it.
  ProcessEnd End();

 private:
  pid_t pid_ = -1;  // -1: reaped
  int socket_ = -1;
};

}  // namespace lares::prolog
