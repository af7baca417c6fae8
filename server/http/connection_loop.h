// Many connections, few threads: a connection holds a thread only while a whole request is there.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "server/http/connection.h"

namespace lares::http {

struct LoopOptions {
  int threads = 64;                    // at most half of them in long transfers
  std::size_t max_connections = 1024;  // beyond it the one idle for longest is closed
  ConnectionLimits limits;
};

struct LoopHandlers {
  // Answers the one request whose header has arrived; true: the connection may serve more.
  // `closing`: it is the last one of this connection.
  std::function<bool(Connection&, bool closing)> serve;
  // The bytes to send for a problem kind of the protocol ("headers-too-large",
  // "request-timeout") before the connection is closed.
  std::function<std::string(const std::string& problem_code)> refusal;
};

// Threads wait together on one epoll: idle connections and those whose header dribbles in cost no
// thread, and are closed when their time is over. Takes over `listener`, a listening socket.
class ConnectionLoop {
 public:
  ConnectionLoop(int listener, const LoopOptions& options, LoopHandlers handlers);
  ~ConnectionLoop();  // stops at once

  // Refuses new connections, closes idle ones, and waits for running requests up to `grace`; what
  // is left is cut off. True when nothing had to be. Called once.
  bool Stop(std::chrono::milliseconds grace);
  bool stopping() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
