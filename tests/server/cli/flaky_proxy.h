// Stands between a client and a server and breaks connections.
#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace lares::testing {

// One thread, a connection after the other. The first `breaks` connections that carry more than
// `bytes` (both ways together) are cut off there.
class FlakyProxy {
 public:
  FlakyProxy(int server_port, int breaks, std::uint64_t bytes)
      : server_port_(server_port), breaks_(breaks), bytes_(bytes) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = Loopback(0);
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    ::listen(listener_, 16);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { Run(); });
  }
  ~FlakyProxy() {
    stopping_ = true;
    thread_.join();
    ::close(listener_);
  }
  FlakyProxy(const FlakyProxy&) = delete;
  FlakyProxy& operator=(const FlakyProxy&) = delete;

  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_); }
  int broken() const { return broken_; }
  std::uint64_t carried() const { return carried_; }

 private:
  static sockaddr_in Loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }

  static bool IsReady(int socket, int milliseconds) {
    pollfd waiting{socket, POLLIN, 0};
    return ::poll(&waiting, 1, milliseconds) > 0;
  }

  void Run() {
    while (!stopping_) {
      if (!IsReady(listener_, 20)) continue;
      const int client = ::accept(listener_, nullptr, nullptr);
      const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      sockaddr_in address = Loopback(server_port_);
      if (::connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
        Carry(client, server);
      }
      ::close(client);
      ::close(server);
    }
  }

  // False at the end of the connection.
  bool Pass(int from, int to, std::uint64_t& done) {
    std::array<char, 16 * 1024> bytes{};
    const ssize_t got = ::recv(from, bytes.data(), bytes.size(), 0);
    if (got <= 0) return false;
    done += static_cast<std::uint64_t>(got);
    carried_ += static_cast<std::uint64_t>(got);
    for (ssize_t sent = 0; sent < got;) {
      const ssize_t now =
          ::send(to, bytes.data() + sent, static_cast<std::size_t>(got - sent), MSG_NOSIGNAL);
      if (now <= 0) return false;
      sent += now;
    }
    return true;
  }

  void Carry(int client, int server) {
    std::uint64_t done = 0;
    std::array<pollfd, 2> ends{{{client, POLLIN, 0}, {server, POLLIN, 0}}};
    while (!stopping_) {
      if (::poll(ends.data(), ends.size(), 20) <= 0) {
        if (IsReady(listener_, 0)) return;  // the client has begun another
        continue;
      }
      if (ends[0].revents != 0 && !Pass(client, server, done)) return;
      if (ends[1].revents != 0 && !Pass(server, client, done)) return;
      if (broken_ < breaks_ && done > bytes_) {
        ++broken_;
        return;
      }
    }
  }

  const int server_port_;
  const int breaks_;
  const std::uint64_t bytes_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<bool> stopping_{false};
  std::atomic<int> broken_{0};
  std::atomic<std::uint64_t> carried_{0};
  std::thread thread_;
};

}  // namespace lares::testing
