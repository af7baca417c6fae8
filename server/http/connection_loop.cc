#include "server/http/connection_loop.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "server/http/log.h"

namespace lares::http {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kListenerId = 0;
constexpr std::uint64_t kStopId = 1;

constexpr std::uint32_t kPeerGone = EPOLLRDHUP | EPOLLHUP | EPOLLERR;

// A connection and who has it: nobody (parked, watched by epoll), one thread (busy), or the channel
// of an event stream.
struct Slot {
  std::unique_ptr<Connection> connection;  // null once it is the channel's
  std::shared_ptr<EventChannel> channel;
  std::shared_ptr<void> place;           // of an event stream
  std::optional<std::stop_source> gone;  // of a busy connection whose peer is watched
  bool busy = false;
  bool header_begun = false;
  Clock::time_point parked_at{};
  Clock::time_point deadline{};
};

std::string RemoteAddress(const sockaddr_storage& address) {
  char text[INET6_ADDRSTRLEN] = "";
  if (address.ss_family == AF_INET) {
    const auto& ipv4 = reinterpret_cast<const sockaddr_in&>(address);
    ::inet_ntop(AF_INET, &ipv4.sin_addr, text, sizeof text);
  } else {
    const auto& ipv6 = reinterpret_cast<const sockaddr_in6&>(address);
    ::inet_ntop(AF_INET6, &ipv6.sin6_addr, text, sizeof text);
  }
  return text;
}

}  // namespace

struct ConnectionLoop::State {
  LoopOptions options;
  LoopHandlers handlers;
  int listener = -1;
  int epoll = -1;
  int stop_event = -1;
  std::atomic<bool> stopping{false};
  std::atomic<bool> ending{false};

  std::mutex mutex;  // of everything below
  std::condition_variable changed;
  std::unordered_map<std::uint64_t, Slot> slots;
  std::uint64_t next_id = 2;
  std::size_t busy = 0;

  std::vector<std::thread> threads;

  void Watch(int operation, int fd, std::uint64_t id, std::uint32_t events) const {
    epoll_event event{};
    event.events = events;
    event.data.u64 = id;
    ::epoll_ctl(epoll, operation, fd, &event);
  }

  void Work();
  void Accept();
  void Adopt(int fd, const sockaddr_storage& address);
  void Handle(std::uint64_t id, std::uint32_t events);
  void HandleChannel(std::uint64_t id, EventChannel& channel, std::uint32_t events);
  Served ServeWhatArrived(Connection& connection, bool& header_begun);
  std::stop_token WatchPeer(std::uint64_t id);
  void HandOver(std::uint64_t id, Served served);
  void Park(std::uint64_t id, bool header_begun);
  void Close(std::uint64_t id);
  void CloseIdlest();
  void CloseExpired();
  void CloseParked();
  void SendRefusal(Connection& connection, const std::string& problem_code) const;
};

ConnectionLoop::ConnectionLoop(int listener, const LoopOptions& options, LoopHandlers handlers)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.options = options;
  state.handlers = std::move(handlers);
  state.listener = listener;
  state.epoll = ::epoll_create1(EPOLL_CLOEXEC);
  state.stop_event = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (state.epoll < 0 || state.stop_event < 0) {
    throw Error(Code::kIo, std::string("cannot wait for connections: ") + std::strerror(errno));
  }
  state.Watch(EPOLL_CTL_ADD, state.stop_event, kStopId, EPOLLIN);
  state.Watch(EPOLL_CTL_ADD, listener, kListenerId, EPOLLIN | EPOLLONESHOT);
  for (int i = 0; i < options.threads; ++i) state.threads.emplace_back([&state] { state.Work(); });
  state.threads.emplace_back([&state] {
    std::unique_lock lock(state.mutex);
    while (!state.ending) {
      state.changed.wait_for(lock, std::chrono::milliseconds(100),
                             [&state] { return state.ending.load(); });
      state.CloseExpired();
    }
  });
}

ConnectionLoop::~ConnectionLoop() {
  if (!state_->threads.empty()) Stop(std::chrono::milliseconds(0));
  ::close(state_->epoll);
  ::close(state_->stop_event);
}

bool ConnectionLoop::stopping() const { return state_->stopping; }

bool ConnectionLoop::Stop(std::chrono::milliseconds grace) {
  State& state = *state_;
  state.stopping = true;
  bool clean = true;
  std::vector<std::stop_source> given_up;
  {
    std::unique_lock lock(state.mutex);
    ::shutdown(state.listener, SHUT_RDWR);  // from now on the kernel refuses
    state.CloseParked();
    clean = state.changed.wait_for(lock, grace, [&state] { return state.busy == 0; });
    for (auto& [id, slot] : state.slots) {
      if (slot.connection != nullptr) ::shutdown(slot.connection->fd(), SHUT_RDWR);
      if (slot.gone) given_up.push_back(*slot.gone);
    }
    state.ending = true;
  }
  for (std::stop_source& gone : given_up) gone.request_stop();
  state.changed.notify_all();
  const std::uint64_t one = 1;
  if (::write(state.stop_event, &one, sizeof one) < 0) clean = false;
  for (std::thread& thread : state.threads) thread.join();
  state.threads.clear();
  state.slots.clear();
  ::close(state.listener);
  return clean;
}

void ConnectionLoop::State::Work() {
  while (!ending) {
    epoll_event event{};
    const int ready = ::epoll_wait(epoll, &event, 1, -1);
    if (ready <= 0) continue;
    if (event.data.u64 == kStopId) return;
    try {
      if (event.data.u64 == kListenerId) {
        Accept();
      } else {
        Handle(event.data.u64, event.events);
      }
    } catch (const std::exception& error) {
      Log(LogLevel::kError, "a connection failed", {{"error", std::string(error.what())}});
      Close(event.data.u64);
    }
  }
}

void ConnectionLoop::State::Accept() {
  while (!stopping) {
    sockaddr_storage address{};
    socklen_t length = sizeof address;
    const int fd =
        ::accept4(listener, reinterpret_cast<sockaddr*>(&address), &length, SOCK_CLOEXEC);
    if (fd >= 0) {
      Adopt(fd, address);
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
      const std::lock_guard lock(mutex);
      CloseIdlest();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } else if (errno != EINTR && errno != ECONNABORTED) {
      break;
    }
  }
  if (!stopping) Watch(EPOLL_CTL_MOD, listener, kListenerId, EPOLLIN | EPOLLONESHOT);
}

void ConnectionLoop::State::Adopt(int fd, const sockaddr_storage& address) {
  const int on = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  Slot slot;
  slot.connection = std::make_unique<Connection>(fd, RemoteAddress(address), options.limits);
  slot.parked_at = Clock::now();
  slot.deadline = slot.parked_at + options.limits.idle_time;
  const std::lock_guard lock(mutex);
  if (stopping) return;
  if (slots.size() >= options.max_connections) CloseIdlest();
  const std::uint64_t id = next_id++;
  slot.connection->SetWatch([this, id] { return WatchPeer(id); });
  slots.emplace(id, std::move(slot));
  Watch(EPOLL_CTL_ADD, fd, id, EPOLLIN | EPOLLRDHUP | EPOLLONESHOT);
}

void ConnectionLoop::State::Handle(std::uint64_t id, std::uint32_t events) {
  Connection* connection = nullptr;
  std::shared_ptr<EventChannel> channel;
  std::optional<std::stop_source> gone;
  bool header_begun = false;
  {
    const std::lock_guard lock(mutex);
    const auto found = slots.find(id);
    if (found == slots.end()) return;  // closed meanwhile
    Slot& slot = found->second;
    if (slot.busy) {
      gone = slot.gone;
    } else if (slot.channel != nullptr) {
      channel = slot.channel;
    } else {
      slot.busy = true;
      ++busy;
      connection = slot.connection.get();
      header_begun = slot.header_begun;
    }
  }
  if (channel != nullptr) return HandleChannel(id, *channel, events);
  if (connection == nullptr) {
    if (gone && (events & kPeerGone) != 0) gone->request_stop();
    return;
  }
  Served served = ServeWhatArrived(*connection, header_begun);
  if (served.subscribe) {
    HandOver(id, std::move(served));
  } else if (served.keep) {
    Park(id, header_begun);
  } else {
    Close(id);
  }
}

void ConnectionLoop::State::HandleChannel(std::uint64_t id, EventChannel& channel,
                                          std::uint32_t events) {
  if ((events & kPeerGone) != 0) {
    channel.MarkGone();
  } else {
    channel.Pump();
  }
  if (channel.gone()) Close(id);
}

std::stop_token ConnectionLoop::State::WatchPeer(std::uint64_t id) {
  const std::lock_guard lock(mutex);
  Slot& slot = slots.at(id);
  if (!slot.gone) {
    slot.gone.emplace();
    Watch(EPOLL_CTL_MOD, slot.connection->fd(), id, EPOLLRDHUP | EPOLLONESHOT);
  }
  return slot.gone->get_token();
}

// The connection becomes an event stream, and the thread is free.
void ConnectionLoop::State::HandOver(std::uint64_t id, Served served) {
  std::shared_ptr<EventChannel> channel;
  {
    const std::lock_guard lock(mutex);
    Slot& slot = slots.at(id);
    const int fd = slot.connection->fd();
    channel = std::make_shared<EventChannel>(
        std::move(slot.connection), served.chunked, options.channels,
        [this, fd, id](bool waits_for_room) {
          const std::uint32_t room = waits_for_room ? std::uint32_t{EPOLLOUT} : 0;
          Watch(EPOLL_CTL_MOD, fd, id, EPOLLRDHUP | EPOLLONESHOT | room);
        });
    slot.channel = channel;
    slot.place = std::move(served.place);
    slot.gone.reset();
    slot.busy = false;
    --busy;
    changed.notify_all();
    if (stopping) {
      channel->End();
      slots.erase(id);
      return;
    }
  }
  try {
    served.subscribe(channel);
  } catch (...) {
    channel->MarkGone();
    throw;  // Work() closes it
  }
}

// Kept when the connection waits for more.
Served ConnectionLoop::State::ServeWhatArrived(Connection& connection, bool& header_begun) {
  while (true) {
    switch (connection.Fill()) {
      case Connection::Arrived::kClosed:
        return {};
      case Connection::Arrived::kTooLarge:
        connection.BeginRequest();
        connection.Write(handlers.refusal("headers-too-large"));
        connection.Linger(1u << 20);
        return {};
      case Connection::Arrived::kPart:
        header_begun = connection.has_input();
        return {!stopping, {}, false, {}};
      case Connection::Arrived::kHeader: {
        header_begun = false;
        connection.BeginRequest();
        Served served = handlers.serve(connection, stopping);
        if (served.subscribe) return served;
        if (!served.keep || !connection.Flush() || stopping) return {};
      }
    }
  }
}

void ConnectionLoop::State::Park(std::uint64_t id, bool header_begun) {
  const std::lock_guard lock(mutex);
  const auto found = slots.find(id);
  if (found == slots.end()) return;
  Slot& slot = found->second;
  slot.gone.reset();
  if (stopping) {
    slots.erase(found);
    --busy;
    changed.notify_all();
    return;
  }
  const Clock::time_point now = Clock::now();
  // A header that dribbles in keeps the deadline that it got with its first byte.
  if (!header_begun) {
    slot.deadline = now + options.limits.idle_time;
  } else if (!slot.header_begun) {
    slot.deadline = now + options.limits.header_time;
  }
  slot.header_begun = header_begun;
  slot.parked_at = now;
  slot.busy = false;
  --busy;
  Watch(EPOLL_CTL_MOD, slot.connection->fd(), id, EPOLLIN | EPOLLRDHUP | EPOLLONESHOT);
}

void ConnectionLoop::State::Close(std::uint64_t id) {
  const std::lock_guard lock(mutex);
  const auto found = slots.find(id);
  if (found == slots.end()) return;
  if (found->second.busy) --busy;
  slots.erase(found);
  changed.notify_all();
}

void ConnectionLoop::State::CloseIdlest() {
  auto idlest = slots.end();
  for (auto slot = slots.begin(); slot != slots.end(); ++slot) {
    if (slot->second.busy || slot->second.channel != nullptr) continue;
    if (idlest == slots.end() || slot->second.parked_at < idlest->second.parked_at) idlest = slot;
  }
  if (idlest != slots.end()) slots.erase(idlest);
}

void ConnectionLoop::State::CloseExpired() {
  const Clock::time_point now = Clock::now();
  for (auto slot = slots.begin(); slot != slots.end();) {
    if (EventChannel* channel = slot->second.channel.get()) {
      slot = channel->Tick(now) ? std::next(slot) : slots.erase(slot);
      continue;
    }
    if (slot->second.busy || slot->second.deadline > now) {
      ++slot;
      continue;
    }
    if (slot->second.header_begun) SendRefusal(*slot->second.connection, "request-timeout");
    slot = slots.erase(slot);
  }
}

void ConnectionLoop::State::CloseParked() {
  for (auto& [id, slot] : slots) {
    if (slot.channel != nullptr) slot.channel->End();
  }
  std::erase_if(slots, [](const auto& entry) { return !entry.second.busy; });
}

void ConnectionLoop::State::SendRefusal(Connection& connection,
                                        const std::string& problem_code) const {
  const std::string bytes = handlers.refusal(problem_code);
  if (::send(connection.fd(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) < 0) return;
  ::shutdown(connection.fd(), SHUT_WR);
}

}  // namespace lares::http
