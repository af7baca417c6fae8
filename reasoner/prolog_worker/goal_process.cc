#include "reasoner/prolog_worker/goal_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "base/error.h"
#include "reasoner/prolog_worker/worker_main.h"

namespace lares::prolog {
namespace {

[[noreturn]] void FailToStart(int error) {
  throw Error(Code::kUnavailable,
              std::string("no process for the goal can be started: ") + std::strerror(error));
}

void Check(int error) {
  if (error != 0) FailToStart(error);
}

class Actions {
 public:
  explicit Actions(int socket) {
    Check(::posix_spawn_file_actions_init(&actions_));
    Check(::posix_spawn_file_actions_adddup2(&actions_, socket, kWorkerSocket));
    for (const int fd : {0, 1, 2}) {
      Check(::posix_spawn_file_actions_addopen(&actions_, fd, "/dev/null", O_RDWR, 0));
    }
    Check(::posix_spawn_file_actions_addclosefrom_np(&actions_, kWorkerSocket + 1));
  }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Signals as a fresh process has them, and a group of its own: a terminal's Ctrl-C is for the
// server.
class Attributes {
 public:
  Attributes() {
    Check(::posix_spawnattr_init(&attributes_));
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

pid_t Spawn(const std::string& program, int socket) {
  const Actions actions(socket);
  const Attributes attributes;
  std::string name = "lares", command = kWorkerCommand;
  char* const arguments[] = {name.data(), command.data(), nullptr};
  std::vector<char*> environment;
  // Only a sanitizer asks for anything.
  std::string sanitizer = "ASAN_OPTIONS=";
  if (const char* options = std::getenv("ASAN_OPTIONS")) {
    sanitizer += options;
    environment.push_back(sanitizer.data());
  }
  environment.push_back(nullptr);
  pid_t pid = -1;
  Check(::posix_spawn(&pid, program.c_str(), actions.get(), attributes.get(), arguments,
                      environment.data()));
  return pid;
}

}  // namespace

GoalProcess::GoalProcess(const std::string& program) {
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) FailToStart(errno);
  socket_ = sockets[0];
  // Only a request that does not fit the socket waits, for a worker that begins.
  const timeval patience{10, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  try {
    pid_ = Spawn(program, sockets[1]);
  } catch (...) {
    ::close(sockets[0]);
    ::close(sockets[1]);
    throw;
  }
  ::close(sockets[1]);
}

GoalProcess::~GoalProcess() {
  End();
  ::close(socket_);
}

void GoalProcess::Kill() const {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

ProcessEnd GoalProcess::End() {
  if (pid_ < 0) return {};
  ::kill(pid_, SIGKILL);  // one that has exited already keeps its own status
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status)) return {WTERMSIG(status), 0};
  return {0, WEXITSTATUS(status)};
}

}  // namespace lares::prolog
