// Linked into a program, this makes its large arrays live in large pages (2 MiB) where the kernel
// has them to give: a table of a hundred megabytes that is read here and there misses the cache of
// small pages at each look-up, and each small page of it has to be faulted in by itself. It
// replaces the global operator new; what is small is malloc's, as ever.
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kPage = std::size_t{2} << 20;
constexpr std::size_t kLarge = 2 * kPage;

void* Allocate(std::size_t bytes) {
  if (bytes < kLarge) return std::malloc(bytes == 0 ? 1 : bytes);
  void* memory = std::aligned_alloc(kPage, bytes);
  // Whole pages only, so that no more memory is used. It does without where there are none.
  if (memory != nullptr) ::madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
  while (true) {
    if (void* memory = Allocate(bytes)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
