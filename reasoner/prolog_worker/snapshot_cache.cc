#include "reasoner/prolog_worker/snapshot_cache.h"

#include <algorithm>

namespace lares::prolog {
namespace {

bool AreOf(const rdf::View& view, const std::vector<std::weak_ptr<const rdf::Layer>>& layers) {
  return std::equal(layers.begin(), layers.end(), view.layers().begin(), view.layers().end(),
                    [](const auto& weak, const auto& layer) { return weak.lock() == layer; });
}

}  // namespace

std::shared_ptr<const SnapshotFile> SnapshotCache::Find(const rdf::View& view) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(by_use_.begin(), by_use_.end(),
                                  [&](const Entry& entry) { return AreOf(view, entry.layers); });
  if (found == by_use_.end()) return nullptr;
  by_use_.splice(by_use_.begin(), by_use_, found);
  return found->file;
}

std::shared_ptr<const SnapshotFile> SnapshotCache::Of(const rdf::View& view) {
  if (auto file = Find(view)) return file;
  const std::lock_guard making(making_);
  if (auto file = Find(view)) return file;
  Prune();
  auto file = std::make_shared<const SnapshotFile>(view);
  const std::lock_guard lock(mutex_);
  by_use_.push_front({Layers(view.layers().begin(), view.layers().end()), file});
  if (by_use_.size() > kCapacity) by_use_.pop_back();
  return file;
}

void SnapshotCache::Prune() {
  const std::lock_guard lock(mutex_);
  by_use_.remove_if([](const Entry& entry) {
    return std::any_of(entry.layers.begin(), entry.layers.end(),
                       [](const auto& layer) { return layer.expired(); });
  });
}

std::size_t SnapshotCache::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const Entry& entry : by_use_) bytes += entry.file->size();
  return bytes;
}

}  // namespace lares::prolog
