// Memory for the many tables of one closure.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace lares::owl {

// Arrays whose sizes are powers of two, cut from few large blocks: one that a table has outgrown
// serves the next. All of it goes with the value.
class TableMemory {
 public:
  TableMemory() = default;
  TableMemory(const TableMemory&) = delete;
  TableMemory& operator=(const TableMemory&) = delete;

  void* Take(std::size_t bytes) {
    bytes = std::bit_ceil(std::max<std::size_t>(bytes, sizeof(Free)));
    Free*& free = free_[ClassOf(bytes)];
    if (free != nullptr) {
      void* array = free;
      free = free->next;
      return array;
    }
    if (bytes > left_) AddBlock(bytes);
    std::byte* array = at_;
    at_ += bytes;
    left_ -= bytes;
    return array;
  }
  void Give(void* array, std::size_t bytes) {
    Free*& free = free_[ClassOf(std::bit_ceil(std::max<std::size_t>(bytes, sizeof(Free))))];
    free = new (array) Free{free};
  }

 private:
  struct Free {
    Free* next;
  };
  static constexpr std::size_t kFirstBlock = std::size_t{16} << 10;
  static constexpr std::size_t kLargestBlock = std::size_t{16} << 20;

  static std::size_t ClassOf(std::size_t bytes) {
    return static_cast<std::size_t>(std::countr_zero(bytes));
  }

  void AddBlock(std::size_t bytes) {
    const std::size_t size = std::max(next_block_, bytes);
    next_block_ = std::min(2 * next_block_, kLargestBlock);
    blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(size));
    at_ = blocks_.back().get();
    left_ = size;
  }

  std::array<Free*, 64> free_{};
  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::byte* at_ = nullptr;
  std::size_t left_ = 0;
  std::size_t next_block_ = kFirstBlock;
};

// For containers; without a memory of tables it is ordinary memory.
template <typename T>
struct TableAllocator {
  static_assert(alignof(T) <= alignof(void*), "arrays are aligned as a pointer is");
  using value_type = T;

  TableAllocator(TableMemory* of = nullptr) : memory(of) {}  // NOLINT: as allocators convert
  template <typename U>
  TableAllocator(const TableAllocator<U>& other) : memory(other.memory) {}  // NOLINT

  T* allocate(std::size_t count) {
    if (memory == nullptr) return std::allocator<T>().allocate(count);
    return static_cast<T*>(memory->Take(count * sizeof(T)));
  }
  void deallocate(T* array, std::size_t count) {
    if (memory == nullptr) return std::allocator<T>().deallocate(array, count);
    memory->Give(array, count * sizeof(T));
  }
  friend bool operator==(const TableAllocator& a, const TableAllocator& b) {
    return a.memory == b.memory;
  }

  TableMemory* memory;
};

}  // namespace lares::owl
