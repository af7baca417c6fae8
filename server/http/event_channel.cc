#include "server/http/event_channel.h"

#include <sys/socket.h>

#include <cstdio>

namespace lares::http {

EventChannel::EventChannel(std::unique_ptr<Connection> connection, bool chunked,
                           const ChannelLimits& limits, std::function<void(bool)> arm)
    : connection_(std::move(connection)), chunked_(chunked), limits_(limits), arm_(std::move(arm)) {
  arm_(false);
}

EventChannel::Sent EventChannel::Send(const Event& event) {
  const std::lock_guard lock(mutex_);
  if (gone_) return Sent::kGone;
  if (!waiting_.empty()) return Sent::kBusy;
  Begin(FormatEvent(event));
  return gone_ ? Sent::kGone : Sent::kTaken;
}

bool EventChannel::drained() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

bool EventChannel::gone() const {
  const std::lock_guard lock(mutex_);
  return gone_;
}

void EventChannel::End() {
  const std::lock_guard lock(mutex_);
  if (gone_) return;
  if (chunked_ && waiting_.empty()) {
    waiting_ = "0\r\n\r\n";
    Push();
  }
  Forget();
}

void EventChannel::MarkGone() {
  const std::lock_guard lock(mutex_);
  if (!gone_) Forget();
}

void EventChannel::Pump() {
  const std::lock_guard lock(mutex_);
  if (gone_) return;
  Push();
  if (!gone_) arm_(!waiting_.empty());
}

bool EventChannel::Tick(std::chrono::steady_clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (gone_) return false;
  const auto still = now - moved_at_;
  if (!waiting_.empty() && still > limits_.stall_time) {
    Forget();
  } else if (waiting_.empty() && still > limits_.keep_alive) {
    Begin(":\n\n");
  }
  return !gone_;
}

void EventChannel::Begin(std::string_view text) {
  if (chunked_) {
    char size[24];
    std::snprintf(size, sizeof size, "%zx\r\n", text.size());
    waiting_ = size;
    waiting_ += text;
    waiting_ += "\r\n";
  } else {
    waiting_ = text;
  }
  moved_at_ = std::chrono::steady_clock::now();
  Push();
  if (!gone_ && !waiting_.empty()) arm_(true);
}

void EventChannel::Push() {
  const long sent_bytes = connection_->SendNow(waiting_);
  if (sent_bytes < 0) return Forget();
  if (sent_bytes > 0) moved_at_ = std::chrono::steady_clock::now();
  waiting_.erase(0, static_cast<std::size_t>(sent_bytes));
}

// The descriptor stays open until nobody holds the channel: its number must not come to mean
// another connection meanwhile.
void EventChannel::Forget() {
  gone_ = true;
  waiting_ = std::string();
  arm_ = nullptr;
  connection_->FinishSending();
  ::shutdown(connection_->fd(), SHUT_RDWR);
}

}  // namespace lares::http
