#include "server/access/use.h"

#include <algorithm>
#include <cmath>

namespace lares::access {

std::optional<std::chrono::seconds> TokenBucket::Take(std::int64_t per_minute,
                                                      Clock::time_point now) {
  if (per_minute <= 0) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const auto most = static_cast<double>(per_minute);
  const double per_second = most / 60;
  if (left_ < 0) {
    left_ = most;
  } else {
    const double elapsed_s = std::chrono::duration<double>(now - at_).count();
    left_ = std::min(most, left_ + std::max(0.0, elapsed_s) * per_second);
  }
  at_ = now;
  if (left_ >= 1) {
    left_ -= 1;
    return std::nullopt;
  }
  return std::chrono::seconds(
      std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil((1 - left_) / per_second))));
}

Held::~Held() {
  const std::lock_guard lock(use_->mutex);
  if (is_query_) --use_->queries_running;
  use_->bytes_arriving -= bytes_;
}

bool Held::BeginQuery(std::int64_t most) {
  const std::lock_guard lock(use_->mutex);
  if (most > 0 && use_->queries_running >= most) return false;
  ++use_->queries_running;
  is_query_ = true;
  return true;
}

std::uint64_t Held::Arriving(std::uint64_t bytes) {
  const std::lock_guard lock(use_->mutex);
  if (bytes > bytes_) {
    use_->bytes_arriving += bytes - bytes_;
    bytes_ = bytes;
  }
  return use_->bytes_arriving;
}

void Held::EndQuery() {
  const std::lock_guard lock(use_->mutex);
  if (is_query_) --use_->queries_running;
  is_query_ = false;
}

void Held::Arrived() {
  const std::lock_guard lock(use_->mutex);
  use_->bytes_arriving -= bytes_;
  bytes_ = 0;
}

}  // namespace lares::access
