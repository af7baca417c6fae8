// A client that speaks bytes instead of HTTP.
#pragma once

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>

namespace lares::http {

// A socket that says what the test wants and reads what comes back.
class RawClient {
 public:
  explicit RawClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~RawClient() { ::close(socket_); }

  bool connected() const { return connected_; }
  bool Say(std::string_view text) {
    while (!text.empty()) {
      const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }
  void FinishSaying() { ::shutdown(socket_, SHUT_WR); }
  // Until `wanted` occurs, the peer closes, or time is over.
  std::string Hear(const std::string& wanted = "",
                   std::chrono::milliseconds time = std::chrono::seconds(10)) {
    const auto end = std::chrono::steady_clock::now() + time;
    char bytes[16 * 1024];
    std::size_t looked_at = 0;  // of what was heard
    while (wanted.empty() || heard_.find(wanted, looked_at) == std::string::npos) {
      looked_at = heard_.size() - std::min(heard_.size(), wanted.size());
      pollfd waiting{socket_, POLLIN, 0};
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
          end - std::chrono::steady_clock::now());
      if (left.count() <= 0 || ::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) break;
      const ssize_t got = ::recv(socket_, bytes, sizeof bytes, 0);
      if (got <= 0) {
        closed_ = true;
        break;
      }
      heard_.append(bytes, static_cast<std::size_t>(got));
    }
    return std::exchange(heard_, "");
  }
  bool closed() const { return closed_; }

 private:
  int socket_;
  bool connected_ = false;
  bool closed_ = false;
  std::string heard_;
};

}  // namespace lares::http
