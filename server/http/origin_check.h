// Who may ask: this machine, and no web page of another origin.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"

namespace lares::http {

// True for localhost, 127.x.y.z, ::1 (with or without brackets).
bool IsLoopbackHost(std::string_view host);

struct OriginRules {
  std::vector<std::string> hosts;  // names beside the loopback's that the server answers to
  bool tls = false;                // pages of this server are https
  bool either_scheme = false;      // a proxy in front of it decides that
};

// Throws kForbidden unless the Host header names this machine by a loopback name or one of the
// rules' (a page that rebinds its own name to 127.0.0.1 still sends its own name) and, for anything
// but GET and HEAD, Origin and Sec-Fetch-Site, where present, say the same origin. Throws
// "bad-request" for a Host header that is absent or sent twice.
void CheckOrigin(const Request& request, const OriginRules& rules = {});

}  // namespace lares::http
