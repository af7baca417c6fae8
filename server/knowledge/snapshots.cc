#include "server/knowledge/snapshots.h"

#include <utility>

namespace lares::server {

std::size_t Snapshots::count() const {
  const std::lock_guard lock(mutex_);
  return pins_.size();
}

Snapshots::Clock::duration Snapshots::OldestAge(Clock::time_point now) const {
  const std::lock_guard lock(mutex_);
  return pins_.empty() ? Clock::duration::zero() : now - *pins_.begin();
}

PinnedView::PinnedView(std::shared_ptr<Snapshots> snapshots, rdf::View view,
                       Snapshots::Clock::time_point now)
    : snapshots_(std::move(snapshots)), view_(std::move(view)) {
  const std::lock_guard lock(snapshots_->mutex_);
  pin_ = snapshots_->pins_.insert(now);
}

PinnedView::~PinnedView() {
  const std::lock_guard lock(snapshots_->mutex_);
  snapshots_->pins_.erase(pin_);
}

}  // namespace lares::server
