// What matching looks at, kept from question to question.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "recipes/match/needs.h"
#include "recipes/match/profile.h"
#include "recipes/plan/reading.h"

namespace lares::server {

// Values by key; of more than `capacity` the least recently used are forgotten. Thread-safe; two
// threads that miss the same key at once both make it.
template <typename Value>
class Kept {
 public:
  explicit Kept(std::size_t capacity) : capacity_(capacity) {}

  std::shared_ptr<const Value> Get(const std::string& key, const std::function<Value()>& make) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = by_key_.find(key);
      if (found != by_key_.end()) {
        by_use_.splice(by_use_.begin(), by_use_, found->second);
        return found->second->second;
      }
    }
    auto value = std::make_shared<const Value>(make());
    const std::lock_guard lock(mutex_);
    if (by_key_.contains(key)) return value;
    by_use_.emplace_front(key, value);
    by_key_[key] = by_use_.begin();
    if (by_use_.size() > capacity_) {
      by_key_.erase(by_use_.back().first);
      by_use_.pop_back();
    }
    return value;
  }

 private:
  using Entries = std::list<std::pair<std::string, std::shared_ptr<const Value>>>;
  const std::size_t capacity_;
  std::mutex mutex_;
  Entries by_use_;  // most recent first
  std::unordered_map<std::string, typename Entries::iterator> by_key_;
};

// What a task asks of any robot.
struct TaskKnowledge {
  recipes::Needs needs;
  recipes::Reading reading;
};

// Keys name the document's bytes, the thing of it that is meant, and the catalogue's generation.
struct MatchMemory {
  Kept<TaskKnowledge> tasks{256};
  Kept<recipes::RobotProfile> profiles{2048};
};

}  // namespace lares::server
