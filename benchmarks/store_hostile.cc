// store_hostile PORT [SECONDS]: a good client of the server at 127.0.0.1:PORT alone, and beside
// hostile ones. Prints two rows: the good client's errors, and its 99th percentile as a multiple of
// that alone (medians of five rounds of SECONDS each way).
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <deque>
#include <random>
#include <thread>

#include "benchmarks/measure.h"
#include "server/http/client.h"

namespace lares::bench {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kRounds = 5;

// ---- Hostile -----------------------------------------------------------------------------------

// A socket that says what no client should, and never waits.
class Socket {
 public:
  explicit Socket(int port) : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int small = 4096;  // of what it would take in, so that answers to it get stuck
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    ::connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address);
  }
  ~Socket() { ::close(fd_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // False once the server has closed it.
  bool Say(const std::string& bytes) const {
    return ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0 || errno == EAGAIN ||
           errno == ENOTCONN;
  }
  bool IsClosed() const {
    char byte = 0;
    const ssize_t got = ::recv(fd_, &byte, 1, MSG_PEEK);
    return got == 0 || (got < 0 && errno != EAGAIN && errno != ENOTCONN);
  }

 private:
  int fd_;
};

using Sockets = std::deque<std::unique_ptr<Socket>>;

// `count` connections that each say `first` and then `more` every `pause`; new ones for those that
// the server closes.
void Hold(int port, std::size_t count, const std::string& first, const std::string& more,
          milliseconds pause) {
  Sockets sockets;
  while (true) {
    std::erase_if(sockets, [&](const auto& socket) {
      return socket->IsClosed() || (!more.empty() && !socket->Say(more));
    });
    for (int i = 0; i < 50 && sockets.size() < count; ++i) {
      sockets.push_back(std::make_unique<Socket>(port));
      std::this_thread::sleep_for(milliseconds(1));
      sockets.back()->Say(first);
    }
    std::this_thread::sleep_for(pause);
  }
}

// Connects and says nothing: some hundred a second, the oldest of `count` goes.
void Flood(int port, std::size_t count) {
  Sockets sockets;
  while (true) {
    for (int i = 0; i < 5; ++i) sockets.push_back(std::make_unique<Socket>(port));
    while (sockets.size() > count) sockets.pop_front();
    std::this_thread::sleep_for(milliseconds(10));
  }
}

void Bomb(int port) {
  const std::string field = "X-Bomb: " + std::string(60'000, 'b') + "\r\n";
  while (true) {
    const Socket socket(port);
    socket.Say("GET / HTTP/1.1\r\nHost: localhost\r\n");
    for (int i = 0; i < 50 && socket.Say(field); ++i) std::this_thread::sleep_for(milliseconds(2));
  }
}

void Garble(int port) {
  std::mt19937 random(7);
  Sockets sockets;
  while (true) {
    std::string bytes(4096, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    sockets.push_back(std::make_unique<Socket>(port));
    std::this_thread::sleep_for(milliseconds(10));
    sockets.back()->Say(bytes + "\r\n\r\n");
    if (sockets.size() > 100) sockets.pop_front();
  }
}

std::string Post(const std::string& more) {
  return "POST /v1/sparql HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
         "application/sparql-query\r\n" +
         more + "\r\n\r\n";
}

[[noreturn]] void BeHostile(int port) {
  // Their own work should not be what slows the good client down: it would be other machines'.
  ::setpriority(PRIO_PROCESS, 0, 19);
  const std::string get = "GET /openapi.json HTTP/1.1\r\nHost: localhost\r\n";
  std::vector<std::thread> threads;
  const auto hold = [&](std::size_t count, const std::string& first, const std::string& more,
                        int pause_ms) {
    threads.emplace_back([=] { Hold(port, count, first, more, milliseconds(pause_ms)); });
  };
  hold(300, "GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: ", "s", 1000);  // slow headers
  hold(100, Post("Content-Length: 60000") + "ASK", "", 200);              // half requests
  hold(60, Post("Content-Length: 60000\r\nExpect: 100-continue"), "", 200);
  hold(60, Post("Transfer-Encoding: chunked") + "5\r\nASK", "", 200);
  hold(60, Post("Content-Length: 1000000") + "ASK", "A", 1000);  // slow bodies
  hold(60, get + "\r\n", "", 200);                               // never read
  hold(20, Post("Content-Encoding: gzip\r\nContent-Length: 4") + "\x1f\x8b\x08", "", 200);
  threads.emplace_back([=] { Flood(port, 800); });
  threads.emplace_back([=] { Bomb(port); });
  threads.emplace_back([=] { Garble(port); });
  for (std::thread& thread : threads) thread.join();
  std::_Exit(0);
}

// ---- Good --------------------------------------------------------------------------------------

struct Served {
  std::vector<double> seconds;
  int errors = 0;
};

// Two kinds of questions over a connection that is kept, each tenth over a new one.
Served Ask(const std::string& url, std::chrono::duration<double> time) {
  Served served;
  http::Client kept(url);
  const auto end = Clock::now() + time;
  for (int i = 0; Clock::now() < end; ++i) {
    http::ClientRequest request{"GET", "/v1/status", {}, {}, {}};
    if (i % 2 == 1) {
      request = {"POST", "/v1/sparql", {}, {}, std::string("ASK {?s ?p ?o}")};
      request.headers.Set("Content-Type", "application/sparql-query");
    }
    const auto begin = Clock::now();
    try {
      const int status =
          (i % 10 == 9 ? http::Client(url).Send(request) : kept.Send(request)).status;
      if (status != 200) ++served.errors;
    } catch (const Error&) {
      ++served.errors;
    }
    served.seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    std::this_thread::sleep_for(milliseconds(2));
  }
  return served;
}

double P99(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() * 99 / 100];
}

int Run(int port, double seconds) {
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 8192);
  ::setrlimit(RLIMIT_NOFILE, &files);
  const std::string url = "http://127.0.0.1:" + std::to_string(port);
  const std::chrono::duration<double> time(seconds);
  Ask(url, std::chrono::seconds(1));  // warm
  std::vector<double> alone, beside;
  int errors = 0;
  std::size_t asked = 0;
  for (int round = 0; round < kRounds; ++round) {
    alone.push_back(P99(Ask(url, time).seconds));
    const pid_t hostile = ::fork();
    if (hostile == 0) BeHostile(port);
    std::this_thread::sleep_for(std::chrono::seconds(2));  // until all are there
    const Served served = Ask(url, time);
    ::kill(hostile, SIGKILL);
    ::waitpid(hostile, nullptr, 0);
    beside.push_back(P99(served.seconds));
    errors += served.errors;
    asked += served.seconds.size();
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  Row("errors of a good client beside hostile ones, of " + std::to_string(asked), "==", 0, "errors",
      errors);
  Row("its 99th percentile beside them, to that alone", "<", 2, "times",
      MedianOf(beside) / MedianOf(alone));
  Note("  alone", "ms", 1000 * MedianOf(alone));
  return 0;
}

}  // namespace
}  // namespace lares::bench

int main(int argc, char** argv) {
  const int port = argc > 1 ? std::atoi(argv[1]) : 0;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 4;
  if (port < 1 || port > 65535 || !(seconds > 0)) {
    std::fputs("usage: store_hostile PORT [SECONDS]\n", stderr);
    return 2;
  }
  return lares::bench::Run(port, seconds);
}
