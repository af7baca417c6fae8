// Copies of views for worker processes, made once for each view that is asked about again.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog_worker/snapshot_file.h"

namespace lares::prolog {

// Pins no view: a copy is dropped once a layer of its view is gone. Thread-safe.
class SnapshotCache {
 public:
  // Throws as SnapshotFile does. Threads that ask for one view at once wait for one making of it.
  std::shared_ptr<const SnapshotFile> Of(const rdf::View& view);
  // Drops what nobody can ask for any more.
  void Prune();
  std::size_t bytes() const;

 private:
  using Layers = std::vector<std::weak_ptr<const rdf::Layer>>;
  struct Entry {
    Layers layers;
    std::shared_ptr<const SnapshotFile> file;
  };
  static constexpr std::size_t kCapacity = 4;

  std::shared_ptr<const SnapshotFile> Find(const rdf::View& view);

  std::mutex making_;
  mutable std::mutex mutex_;
  std::list<Entry> by_use_;  // most recent first
};

}  // namespace lares::prolog
