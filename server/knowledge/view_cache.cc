#include "server/knowledge/view_cache.h"

namespace lares::server {

rdf::View ViewCache::GetOrMake(const std::string& key, const std::function<rdf::View()>& make) {
  std::promise<rdf::View> promise;
  std::shared_future<rdf::View> view;
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = by_key_.find(key); known != by_key_.end()) {
      by_use_.splice(by_use_.begin(), by_use_, known->second);
      view = known->second->second;
    } else {
      by_use_.emplace_front(key, promise.get_future().share());
      by_key_[key] = by_use_.begin();
      if (by_use_.size() > capacity_) {
        by_key_.erase(by_use_.back().first);
        by_use_.pop_back();
      }
    }
  }
  if (view.valid()) return view.get();
  try {
    rdf::View made = make();
    promise.set_value(made);
    return made;
  } catch (...) {
    Forget(key);
    promise.set_exception(std::current_exception());
    throw;
  }
}

void ViewCache::Forget(const std::string& key) {
  const std::lock_guard lock(mutex_);
  if (const auto known = by_key_.find(key); known != by_key_.end()) {
    by_use_.erase(known->second);
    by_key_.erase(known);
  }
}

std::size_t ViewCache::size() const {
  const std::lock_guard lock(mutex_);
  return by_use_.size();
}

}  // namespace lares::server
