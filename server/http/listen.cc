#include "server/http/listen.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/text.h"
#include "server/http/origin_check.h"

namespace lares::http {
namespace {

constexpr int kBacklog = 512;

struct Address {
  sockaddr_storage storage{};
  socklen_t length = 0;
};

Address AddressOf(const std::string& host, int port) {
  if (port < 0 || port > 65535) {
    throw Error(Code::kInvalid, std::to_string(port) + " is no port: 0 to 65535");
  }
  std::string name = ToLower(host) == "localhost" ? "127.0.0.1" : host;
  if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
  Address address;
  auto& ipv4 = reinterpret_cast<sockaddr_in&>(address.storage);
  if (::inet_pton(AF_INET, name.c_str(), &ipv4.sin_addr) == 1) {
    ipv4.sin_family = AF_INET;
    ipv4.sin_port = htons(static_cast<std::uint16_t>(port));
    address.length = sizeof(sockaddr_in);
    return address;
  }
  auto& ipv6 = reinterpret_cast<sockaddr_in6&>(address.storage);
  if (::inet_pton(AF_INET6, name.c_str(), &ipv6.sin6_addr) != 1) {
    throw Error(Code::kInvalid, "'" + host + "' is no address to listen on")
        .WithHint("give it in digits, as 192.168.1.5, or 0.0.0.0 for every one of this machine");
  }
  ipv6.sin6_family = AF_INET6;
  ipv6.sin6_port = htons(static_cast<std::uint16_t>(port));
  address.length = sizeof(sockaddr_in6);
  return address;
}

[[noreturn]] void CloseAndThrow(int descriptor, const std::string& host, int port) {
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  const std::string where = host + ":" + std::to_string(port);
  if (error == EADDRINUSE) {
    throw Error(Code::kConflict,
                "port " + std::to_string(port) + " of " + host + " is taken by another program")
        .WithHint("choose another with --port, or stop that program");
  }
  throw Error(Code::kIo, "cannot listen on " + where + ": " + std::strerror(error));
}

}  // namespace

Listener ListenOnLoopback(const std::string& host, int port) {
  if (!IsLoopbackHost(host)) {
    throw Error(Code::kForbidden, "'" + host + "' is not this machine's loopback")
        .WithHint(
            "use 127.0.0.1, localhost or ::1, or see lares serve --help for what serving "
            "other machines takes");
  }
  return ListenOn(host, port);
}

Listener ListenOn(const std::string& host, int port) {
  Address address = AddressOf(host, port);
  auto* const raw = reinterpret_cast<sockaddr*>(&address.storage);
  const int descriptor =
      ::socket(address.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) CloseAndThrow(descriptor, host, port);
  const int on = 1;
  // Only REUSEADDR: with REUSEPORT two servers would share a port and neither would know.
  ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (::bind(descriptor, raw, address.length) != 0 || ::listen(descriptor, kBacklog) != 0 ||
      ::getsockname(descriptor, raw, &address.length) != 0) {
    CloseAndThrow(descriptor, host, port);
  }
  const std::uint16_t bound = address.storage.ss_family == AF_INET
                                  ? reinterpret_cast<sockaddr_in*>(raw)->sin_port
                                  : reinterpret_cast<sockaddr_in6*>(raw)->sin6_port;
  return {descriptor, ntohs(bound)};
}

}  // namespace lares::http
