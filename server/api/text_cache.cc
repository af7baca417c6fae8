#include "server/api/text_cache.h"

#include <mutex>

namespace lares::api {

std::shared_ptr<const std::string> TextCache::Get(const std::string& key,
                                                  const std::function<std::string()>& make) {
  {
    const std::shared_lock lock(mutex_);
    const auto found = texts_.find(key);
    if (found != texts_.end()) return found->second;
  }
  auto text = std::make_shared<const std::string>(make());
  const std::unique_lock lock(mutex_);
  if (texts_.size() >= max_entries_) texts_.clear();
  return texts_.emplace(key, std::move(text)).first->second;
}

}  // namespace lares::api
