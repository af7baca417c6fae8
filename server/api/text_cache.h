// Texts made once from things that never change, such as one version of a document.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <shared_mutex>
#include <string>
#include <unordered_map>

namespace lares::api {

// Thread-safe. Forgets everything when it is full, so that nobody outside can make it grow.
class TextCache {
 public:
  explicit TextCache(std::size_t max_entries = 4096) : max_entries_(max_entries) {}

  // The text of `key`, made by `make` when it is not there yet.
  std::shared_ptr<const std::string> Get(const std::string& key,
                                         const std::function<std::string()>& make);

 private:
  std::size_t max_entries_;
  std::shared_mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<const std::string>> texts_;
};

}  // namespace lares::api
