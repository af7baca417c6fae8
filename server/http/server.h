// The HTTP server: sockets in front of a Service.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "server/http/connection_loop.h"
#include "server/http/service.h"

namespace lares::http {

struct ServerOptions {
  std::string host = "127.0.0.1";  // a loopback name or address, unless `beyond_loopback`
  // Other machines may be answered: `host` may be any address of this one. Who allows it sees to
  // it that somebody asks for tokens, and that nobody can listen in.
  bool beyond_loopback = false;
  std::optional<TlsOptions> tls;
  int port = 8080;  // 0: any free one
  LoopOptions loop;
  bool access_log = true;  // one line a request
};

// Serves from construction on. Throws as TlsContext does, kForbidden for a host that is not this
// machine's loopback (unless allowed), kInvalid for what is no address, kConflict when the port is
// taken, kIo for anything else the socket says.
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
