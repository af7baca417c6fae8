// The HTTP server: sockets in front of a Service.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "server/http/connection_loop.h"
#include "server/http/service.h"

namespace lares::http {

struct ServerOptions {
  std::string host = "127.0.0.1";  // a loopback name or address; anything else is refused
  int port = 8080;                 // 0: any free one
  LoopOptions loop;
  bool access_log = true;  // one line a request
};

// Serves from construction on. Throws kForbidden for a host that is not this machine's loopback,
// kConflict when the port is taken, kIo for anything else the socket says.
class Server {
 public:
  Server(std::shared_ptr<const Service> service, const ServerOptions& options);
  ~Server();  // stops without grace

  int port() const;
  std::string url() const;
  // No new connections; running requests are finished, up to `grace`. True when all were.
  bool Stop(std::chrono::milliseconds grace);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::http
