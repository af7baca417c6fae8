// Many connections, few threads: a connection holds a thread only while a whole request is there,
// and none while it waits for events.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "server/http/connection.h"
#include "server/http/event_channel.h"

namespace lares::http {

struct LoopOptions {
  int threads = 64;  // at most half of them in long transfers
  // Beyond it one is closed: the oldest that has not asked anything yet, else the one idle for
  // longest.
  std::size_t max_connections = 1024;
  std::size_t max_connections_per_peer = 0;  // of one address, likewise; 0: no other bound
  int max_event_streams = 256;               // at most half of the connections
  ConnectionLimits limits;
  ChannelLimits channels;  // of event streams
};

// What becomes of a connection once its request is answered.
struct Served {
  bool keep = false;  // it may serve more
  // An event stream: gets the channel that the connection becomes.
  std::function<void(std::shared_ptr<EventChannel>)> subscribe;
  bool chunked = false;         // the stream's body
  std::shared_ptr<void> place;  // dropped when the stream ends
};

struct LoopHandlers {
  // Answers the one request whose header has arrived. `closing`: it is the last one of this
  // connection.
  std::function<Served(Connection&, bool closing)> serve;
  // The bytes to send for a problem kind of the protocol ("headers-too-large",
  // "request-timeout") before the connection is closed.
  std::function<std::string(const std::string& problem_code)> refusal;
};

// Threads wait together on one epoll: idle connections and those whose header dribbles in cost no
// thread, and are closed when their time is over. Takes over `listener`, a listening socket.
class ConnectionLoop {
 public:
  // `tls` null: none. It must outlive the loop.
  ConnectionLoop(int listener, const LoopOptions& options, LoopHandlers handlers,
                 const TlsContext* tls = nullptr);
  ~ConnectionLoop();  // stops at once

  // Refuses new connections, closes idle ones, ends event streams, and waits for running requests
  // up to `grace`; what is left is cut off. True when nothing had to be. Called once.
  bool Stop(std::chrono::milliseconds grace);
  bool stopping() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
