// A listening socket on this machine's loopback.
#pragma once

#include <string>

namespace lares::http {

struct Listener {
  int descriptor = -1;  // non-blocking; owned by the caller
  int port = 0;
};

// Throws as Server does.
Listener ListenOnLoopback(const std::string& host, int port);

}  // namespace lares::http
