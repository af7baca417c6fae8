// A hash map from 64-bit keys to small values, for the reasoner's inner loops.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reasoner/owl/table_memory.h"

namespace lares::owl {

inline std::uint64_t MixBits(std::uint64_t key) {
  key *= 0x9E3779B97F4A7C15ULL;
  return key ^ (key >> 32);
}

// Open addressing; keys are never 0 and never erased.
class FlatMap {
 public:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
    std::uint32_t count = 0;  // for the owner's use
  };

  explicit FlatMap(TableMemory* memory = nullptr) : cells_(memory) {}

  // 0 for a key that is absent.
  std::uint32_t Find(std::uint64_t key) const {
    if (cells_.empty()) return 0;
    const Entry& cell = cells_[IndexOf(key)];
    return cell.key == key ? cell.value : 0;
  }
  std::uint32_t CountOf(std::uint64_t key) const {
    if (cells_.empty()) return 0;
    const Entry& cell = cells_[IndexOf(key)];
    return cell.key == key ? cell.count : 0;
  }

  bool Contains(std::uint64_t key) const {
    return !cells_.empty() && cells_[IndexOf(key)].key == key;
  }

  // The value of `key`, 0 when it is new. Valid until the next call.
  std::uint32_t& operator[](std::uint64_t key) { return EntryOf(key).value; }
  Entry& EntryOf(std::uint64_t key) {
    if (2 * (size_ + 1) > cells_.size()) Grow();
    Entry& cell = cells_[IndexOf(key)];
    if (cell.key == 0) {
      cell.key = key;
      ++size_;
    }
    return cell;
  }

  std::size_t size() const { return size_; }

 private:
  std::size_t IndexOf(std::uint64_t key) const {
    const std::size_t mask = cells_.size() - 1;
    std::size_t i = MixBits(key) & mask;
    while (cells_[i].key != 0 && cells_[i].key != key) i = (i + 1) & mask;
    return i;
  }

  using Cells = std::vector<Entry, TableAllocator<Entry>>;

  void Grow() {
    Cells old(cells_.empty() ? 16 : 2 * cells_.size(), cells_.get_allocator());
    old.swap(cells_);
    for (const Entry& cell : old) {
      if (cell.key != 0) cells_[IndexOf(cell.key)] = cell;
    }
  }

  Cells cells_;
  std::size_t size_ = 0;
};

// The same for keys alone.
class FlatSet {
 public:
  bool Contains(std::uint64_t key) const { return !cells_.empty() && cells_[IndexOf(key)] == key; }

  // False when it was there.
  bool Insert(std::uint64_t key) {
    if (2 * (size_ + 1) > cells_.size()) Grow();
    std::uint64_t& cell = cells_[IndexOf(key)];
    if (cell == key) return false;
    cell = key;
    ++size_;
    return true;
  }

  std::size_t size() const { return size_; }

 private:
  std::size_t IndexOf(std::uint64_t key) const {
    const std::size_t mask = cells_.size() - 1;
    std::size_t i = MixBits(key) & mask;
    while (cells_[i] != 0 && cells_[i] != key) i = (i + 1) & mask;
    return i;
  }

  using Cells = std::vector<std::uint64_t>;

  void Grow() {
    Cells old(cells_.empty() ? 16 : 2 * cells_.size());
    old.swap(cells_);
    for (const std::uint64_t cell : old) {
      if (cell != 0) cells_[IndexOf(cell)] = cell;
    }
  }

  Cells cells_;
  std::size_t size_ = 0;
};

inline std::uint64_t PairKey(std::uint32_t first, std::uint32_t second) {
  return std::uint64_t{first} << 32 | second;
}

}  // namespace lares::owl
