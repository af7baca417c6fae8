// An answer in Prolog's own form.
#pragma once

#include <cstdint>

namespace lares::prolog {

// What a rule answered, kept to be given to other goals: a large term is neither taken apart nor
// put together again. Any thread may give it to a goal or drop it. Made by EnginePool::Keep().
class Record {
 public:
  // Of this folder: the term_t that is recorded, and the one that becomes it. Needs an attached
  // engine. Throws kTooLarge when Prolog has no room.
  explicit Record(std::uintptr_t term);
  void Put(std::uintptr_t term) const;

  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

 private:
  void* record_;
};

}  // namespace lares::prolog
