// Grids made for robots, kept while there is room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "server/knowledge/package.h"

namespace lares::server {

// Thread-safe. Making one may take much memory and some seconds: one is made at a time, and those
// who wait for the same one get it without making it again.
class RobotGrids {
 public:
  // Keeps at most `max_bytes` of images, the least recently used forgotten; one that alone is
  // larger is given and not kept.
  explicit RobotGrids(std::size_t max_bytes = std::size_t{64} << 20);

  // The grid of `key`, made by `make` when it is not there. That a layer makes no grid (kInvalid,
  // kTooLarge) is kept as well, and thrown again; what else `make` throws is not.
  std::shared_ptr<const RobotGrid> Get(const std::string& key,
                                       const std::function<RobotGrid()>& make);
  std::size_t kept_bytes() const;

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const RobotGrid> grid;  // null: `fault`
    std::optional<Error> fault;
  };

  // Throws the fault that is kept under `key`.
  std::shared_ptr<const RobotGrid> Find(const std::string& key);
  void Keep(Entry entry);
  static std::size_t BytesOf(const Entry& entry);

  const std::size_t max_bytes_;
  std::mutex making_;
  mutable std::mutex mutex_;
  std::list<Entry> by_use_;  // most recent first
  std::unordered_map<std::string, std::list<Entry>::iterator> by_key_;
  std::size_t bytes_ = 0;
};

}  // namespace lares::server
