#include "server/http/connection_loop.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
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
  std::string peer;                      // its address
  bool busy = false;
  bool header_begun = false;
  bool has_served = false;  // a request was answered
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
  const TlsContext* tls = nullptr;
  std::unique_ptr<LongTransfers> slow_readers;
  int listener = -1;
  int epoll = -1;
  int stop_event = -1;
  std::atomic<bool> stopping{false};
  std::atomic<bool> ending{false};

  std::mutex mutex;  // of everything below
  std::condition_variable changed;
  std::unordered_map<std::uint64_t, Slot> slots;
  std::unordered_map<std::string, std::size_t> of_peer;  // connections by address
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
  Served ServeWhatArrived(Connection& connection, bool& header_begun, bool& has_served);
  std::stop_token WatchPeer(std::uint64_t id);
  void HandOver(std::uint64_t id, Served served);
  void Park(std::uint64_t id, bool header_begun, bool served);
  void Close(std::uint64_t id);
  using Slots = std::unordered_map<std::uint64_t, Slot>;
  Slots::iterator Erase(Slots::iterator slot);
  bool CloseIdlest(const std::string* peer = nullptr);
  void CloseExpired();
  void CloseParked();
  void SendRefusal(Connection& connection, const std::string& problem_code) const;
};

ConnectionLoop::ConnectionLoop(int listener, const LoopOptions& options, LoopHandlers handlers,
                               const TlsContext* tls)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.options = options;
  state.handlers = std::move(handlers);
  state.tls = tls;
  state.slow_readers = std::make_unique<LongTransfers>(std::max(1, options.threads / 4));
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
  const std::string peer = RemoteAddress(address);
  std::unique_ptr<TlsSession> session;
  try {
    if (tls != nullptr) session = tls->Accept(fd);
  } catch (...) {
    ::close(fd);
    throw;
  }
  slot.connection = std::make_unique<Connection>(fd, peer, options.limits, slow_readers.get(),
                                                 std::move(session));
  slot.peer = peer;
  slot.parked_at = Clock::now();
  // A handshake has to come as soon as a header that has begun.
  slot.deadline =
      slot.parked_at + (tls != nullptr ? options.limits.header_time : options.limits.idle_time);
  const std::lock_guard lock(mutex);
  if (stopping) return;
  const std::size_t most = options.max_connections_per_peer;
  if (most > 0 && of_peer[peer] >= most && !CloseIdlest(&peer)) return;
  if (slots.size() >= options.max_connections) CloseIdlest();
  const std::uint64_t id = next_id++;
  ++of_peer[peer];
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
  bool has_served = false;
  Served served = ServeWhatArrived(*connection, header_begun, has_served);
  if (served.subscribe) {
    HandOver(id, std::move(served));
  } else if (served.keep) {
    Park(id, header_begun, has_served);
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
      Erase(slots.find(id));
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
Served ConnectionLoop::State::ServeWhatArrived(Connection& connection, bool& header_begun,
                                               bool& has_served) {
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
        has_served = true;
        connection.BeginRequest();
        Served served = handlers.serve(connection, stopping);
        if (served.subscribe) return served;
        if (!served.keep || !connection.Flush() || stopping) return {};
      }
    }
  }
}

ConnectionLoop::State::Slots::iterator ConnectionLoop::State::Erase(Slots::iterator slot) {
  const auto peer = of_peer.find(slot->second.peer);
  if (peer != of_peer.end() && --peer->second == 0) of_peer.erase(peer);
  return slots.erase(slot);
}

void ConnectionLoop::State::Park(std::uint64_t id, bool header_begun, bool served) {
  const std::lock_guard lock(mutex);
  const auto found = slots.find(id);
  if (found == slots.end()) return;
  Slot& slot = found->second;
  slot.gone.reset();
  if (stopping) {
    Erase(found);
    --busy;
    changed.notify_all();
    return;
  }
  const Clock::time_point now = Clock::now();
  // A header that dribbles in keeps the deadline that it got with its first byte, and a handshake
  // that of its connection.
  const bool is_open = slot.connection->is_open();
  if (is_open && !header_begun) {
    slot.deadline = now + options.limits.idle_time;
  } else if (is_open && (!slot.header_begun || served)) {
    slot.deadline = now + options.limits.header_time;
  }
  slot.header_begun = header_begun;
  slot.has_served = slot.has_served || served;
  // Who has asked something is idle since then; who has not, since it came.
  if (served) slot.parked_at = now;
  slot.busy = false;
  --busy;
  const std::uint32_t awaited =
      slot.connection->wants_room() ? std::uint32_t{EPOLLOUT} : std::uint32_t{EPOLLIN};
  Watch(EPOLL_CTL_MOD, slot.connection->fd(), id, awaited | EPOLLRDHUP | EPOLLONESHOT);
}

void ConnectionLoop::State::Close(std::uint64_t id) {
  const std::lock_guard lock(mutex);
  const auto found = slots.find(id);
  if (found == slots.end()) return;
  if (found->second.busy) --busy;
  Erase(found);
  changed.notify_all();
}

// Before those that have asked something go those that have not: who keeps asking is not pushed out
// by who only connects. False when there is none to close.
bool ConnectionLoop::State::CloseIdlest(const std::string* peer) {
  const auto rank = [](const Slot& slot) { return std::pair(slot.has_served, slot.parked_at); };
  auto idlest = slots.end();
  for (auto slot = slots.begin(); slot != slots.end(); ++slot) {
    if (slot->second.busy || slot->second.channel != nullptr) continue;
    if (peer != nullptr && slot->second.peer != *peer) continue;
    if (idlest == slots.end() || rank(slot->second) < rank(idlest->second)) idlest = slot;
  }
  if (idlest == slots.end()) return false;
  Erase(idlest);
  return true;
}

void ConnectionLoop::State::CloseExpired() {
  const Clock::time_point now = Clock::now();
  for (auto slot = slots.begin(); slot != slots.end();) {
    if (EventChannel* channel = slot->second.channel.get()) {
      slot = channel->Tick(now) ? std::next(slot) : Erase(slot);
      continue;
    }
    if (slot->second.busy || slot->second.deadline > now) {
      ++slot;
      continue;
    }
    if (slot->second.header_begun) SendRefusal(*slot->second.connection, "request-timeout");
    slot = Erase(slot);
  }
}

void ConnectionLoop::State::CloseParked() {
  for (auto& [id, slot] : slots) {
    if (slot.channel != nullptr) slot.channel->End();
  }
  for (auto slot = slots.begin(); slot != slots.end();) {
    slot = slot->second.busy ? std::next(slot) : Erase(slot);
  }
}

void ConnectionLoop::State::SendRefusal(Connection& connection,
                                        const std::string& problem_code) const {
  if (connection.SendNow(handlers.refusal(problem_code)) >= 0) connection.FinishSending();
}

}  // namespace lares::http
