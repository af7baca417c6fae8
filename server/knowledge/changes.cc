#include "server/knowledge/changes.h"

#include <utility>

namespace lares::server {

void Changes::Notify() {
  ++generation_;
  const std::lock_guard lock(listeners_->mutex);
  for (const auto& [number, listener] : listeners_->by_number) listener();
}

std::shared_ptr<void> Changes::Listen(std::function<void()> listener) {
  const std::lock_guard lock(listeners_->mutex);
  const std::uint64_t number = listeners_->next++;
  listeners_->by_number.emplace(number, std::move(listener));
  return {nullptr, [listeners = listeners_, number](void*) {
            const std::lock_guard inner(listeners->mutex);
            listeners->by_number.erase(number);
          }};
}

}  // namespace lares::server
