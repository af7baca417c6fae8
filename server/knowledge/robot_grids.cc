#include "server/knowledge/robot_grids.h"

#include <utility>

namespace lares::server {

std::size_t RobotGrids::BytesOf(const Entry& entry) {
  return 1024 + (entry.grid ? entry.grid->yaml.size() + entry.grid->pgm.size() : 0);
}

RobotGrids::RobotGrids(std::size_t max_bytes) : max_bytes_(max_bytes) {}

std::shared_ptr<const RobotGrid> RobotGrids::Get(const std::string& key,
                                                 const std::function<RobotGrid()>& make) {
  if (auto found = Find(key)) return found;
  const std::lock_guard lock(making_);
  if (auto found = Find(key)) return found;  // made while this thread waited
  try {
    auto grid = std::make_shared<const RobotGrid>(make());
    Keep({key, grid, std::nullopt});
    return grid;
  } catch (const Error& error) {
    const bool is_of_the_layer = error.code() == Code::kInvalid || error.code() == Code::kTooLarge;
    if (is_of_the_layer) Keep({key, nullptr, error});
    throw;
  }
}

std::size_t RobotGrids::kept_bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::shared_ptr<const RobotGrid> RobotGrids::Find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return nullptr;
  by_use_.splice(by_use_.begin(), by_use_, found->second);
  if (found->second->fault) throw Error(*found->second->fault);
  return found->second->grid;
}

void RobotGrids::Keep(Entry entry) {
  const std::size_t size = BytesOf(entry);
  if (size > max_bytes_) return;
  const std::lock_guard lock(mutex_);
  while (bytes_ + size > max_bytes_) {
    bytes_ -= BytesOf(by_use_.back());
    by_key_.erase(by_use_.back().key);
    by_use_.pop_back();
  }
  by_use_.push_front(std::move(entry));
  by_key_[by_use_.front().key] = by_use_.begin();
  bytes_ += size;
}

}  // namespace lares::server
