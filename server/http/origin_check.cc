#include "server/http/origin_check.h"

#include <arpa/inet.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

// "host:port" → "host", with the brackets of IPv6 taken off; "" when malformed.
std::string HostOf(std::string_view authority) {
  std::string_view host;
  std::string_view port;
  if (authority.starts_with('[')) {
    const std::size_t close = authority.find(']');
    if (close == std::string_view::npos) return "";
    host = authority.substr(1, close - 1);
    port = authority.substr(close + 1);
  } else {
    const std::size_t colon = std::min(authority.find(':'), authority.size());
    host = authority.substr(0, colon);
    port = authority.substr(colon);
  }
  const bool port_ok =
      port.empty() || (port.size() <= 6 && port.starts_with(':') &&
                       port.find_first_not_of("0123456789", 1) == std::string_view::npos);
  return port_ok ? ToLower(host) : "";
}

bool IsOurs(const std::string& host, const OriginRules& rules) {
  if (IsLoopbackHost(host)) return true;
  return std::any_of(rules.hosts.begin(), rules.hosts.end(),
                     [&](const std::string& name) { return ToLower(name) == host; });
}

bool IsSameOrigin(const std::string& origin, const std::string& host, const OriginRules& rules) {
  if (rules.either_scheme) return origin == "http://" + host || origin == "https://" + host;
  return origin == (rules.tls ? "https://" : "http://") + host;
}

bool ChangesNothing(const std::string& method) { return method == "GET" || method == "HEAD"; }

}  // namespace

bool IsLoopbackHost(std::string_view host) {
  std::string name = ToLower(host);
  if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
  if (name == "localhost") return true;
  in_addr ipv4{};
  if (::inet_pton(AF_INET, name.c_str(), &ipv4) == 1) return (ntohl(ipv4.s_addr) >> 24) == 127;
  in6_addr ipv6{};
  return ::inet_pton(AF_INET6, name.c_str(), &ipv6) == 1 && IN6_IS_ADDR_LOOPBACK(&ipv6);
}

void CheckOrigin(const Request& request, const OriginRules& rules) {
  const auto& fields = request.headers.all();
  const auto hosts = std::count_if(fields.begin(), fields.end(), [](const auto& field) {
    return ToLower(field.first) == "host";
  });
  if (hosts != 1) throw ProblemError("bad-request", "a request has exactly one Host header");
  const std::string_view host = Trim(request.headers.Get("Host"));
  if (!IsOurs(HostOf(host), rules)) {
    std::string names = rules.hosts.empty() ? "" : Join(rules.hosts, ", ") + ", ";
    throw Error(Code::kForbidden, "this server answers to " + names +
                                      "localhost, 127.0.0.1 and [::1] only, not to '" +
                                      std::string(host) + "'");
  }
  if (ChangesNothing(request.method)) return;
  const auto origins = std::count_if(fields.begin(), fields.end(), [](const auto& field) {
    return ToLower(field.first) == "origin";
  });
  if (origins > 1) throw Error(Code::kForbidden, "a request has at most one Origin header");
  if (const std::string* origin = request.headers.Find("Origin")) {
    if (!IsSameOrigin(ToLower(Trim(*origin)), ToLower(host), rules)) {
      throw Error(Code::kForbidden, "a page of '" + *origin + "' may not change anything here");
    }
  }
  if (const std::string* site = request.headers.Find("Sec-Fetch-Site")) {
    if (*site != "same-origin" && *site != "none") {
      throw Error(Code::kForbidden, "a page of another origin may not change anything here");
    }
  }
}

}  // namespace lares::http
