// A view as one file in memory, for another process.
#pragma once

#include <cstddef>
#include <memory>

#include "ontology/triples/view.h"

namespace lares::prolog {

// Owns a descriptor that nobody can write to any more: sealed, closed on exec.
class SnapshotFile {
 public:
  // Terms, graphs and triples of the view, inferred ones too; renumbered densely, so that its size
  // is that of what the view holds and not of its dictionary. Linear. Throws kTooLarge beyond
  // kMaxTriples, kUnavailable when memory or descriptors are short.
  explicit SnapshotFile(const rdf::View& view);
  ~SnapshotFile();
  SnapshotFile(const SnapshotFile&) = delete;
  SnapshotFile& operator=(const SnapshotFile&) = delete;

  int fd() const { return fd_; }
  std::size_t size() const { return size_; }

  static constexpr std::size_t kMaxTriples = 20'000'000;

 private:
  int fd_ = -1;
  std::size_t size_ = 0;
};

// The view in such a file, on a dictionary of its own and in one layer; the file may be closed
// afterwards. Throws kInvalid for a file that is cut short or damaged.
rdf::View ReadSnapshot(int fd);

}  // namespace lares::prolog
