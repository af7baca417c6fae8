// The way to one client that is told of events: it holds no thread while nothing happens.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "server/http/connection.h"
#include "server/http/events.h"

namespace lares::http {

struct ChannelLimits {
  std::chrono::milliseconds keep_alive{15'000};  // a comment, when there was no event for so long
  std::chrono::milliseconds stall_time{30'000};  // without a byte moving, while something waits
};

// All members are thread-safe, and none waits. At most one event is on its way: what is held for a
// slow client is bounded by the largest event that is sent.
class EventChannel {
 public:
  // `arm(waits_for_room)` has Pump() called when there is room, MarkGone() when the peer goes; it
  // runs under the channel's lock and is not called after End or MarkGone.
  EventChannel(std::unique_ptr<Connection> connection, bool chunked, const ChannelLimits& limits,
               std::function<void(bool)> arm);

  // kBusy: the event before has not left yet, this one was not taken. kGone: nor will any.
  enum class Sent { kTaken, kBusy, kGone };
  Sent Send(const Event& event);
  bool drained() const;
  bool gone() const;
  // Ends the stream as a whole one, at once; what has not left yet is cut off.
  void End();

  // For the loop that owns the connection.
  void MarkGone();
  void Pump();
  // Keeps an idle stream alive, gives a stalled one up. False once it is gone.
  bool Tick(std::chrono::steady_clock::time_point now);

 private:
  void Begin(std::string_view text);
  void Push();
  void Forget();

  mutable std::mutex mutex_;
  std::unique_ptr<Connection> connection_;
  const bool chunked_;
  const ChannelLimits limits_;
  std::function<void(bool)> arm_;
  std::string waiting_;
  bool gone_ = false;
  std::chrono::steady_clock::time_point moved_at_ = std::chrono::steady_clock::now();
};

}  // namespace lares::http
