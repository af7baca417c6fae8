// Closed views by key: made once, shared, the least recently used forgotten.
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "ontology/triples/view.h"

namespace lares::server {

// Thread-safe. Threads that ask for one key at once wait for one making of it.
class ViewCache {
 public:
  explicit ViewCache(std::size_t capacity) : capacity_(capacity) {}

  // `make` runs at most once per key while the view is kept; what it throws reaches every waiter
  // and is not kept.
  rdf::View GetOrMake(const std::string& key, const std::function<rdf::View()>& make);
  std::size_t size() const;

 private:
  using Entry = std::pair<std::string, std::shared_future<rdf::View>>;

  void Forget(const std::string& key);

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::list<Entry> by_use_;  // most recent first
  std::unordered_map<std::string, std::list<Entry>::iterator> by_key_;
};

}  // namespace lares::server
