// A listening socket of this machine.
#pragma once

#include <string>

namespace lares::http {

struct Listener {
  int descriptor = -1;  // non-blocking; owned by the caller
  int port = 0;
};

// Throw as Server does. `host` is localhost or an address in digits, IPv6 with or without brackets.
Listener ListenOnLoopback(const std::string& host, int port);
Listener ListenOn(const std::string& host, int port);  // any address: 0.0.0.0 and :: are all

}  // namespace lares::http
