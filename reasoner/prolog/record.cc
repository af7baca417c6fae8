#include "reasoner/prolog/record.h"

#include <SWI-Prolog.h>

#include "base/error.h"

namespace lares::prolog {

Record::Record(std::uintptr_t term) : record_(PL_record(term)) {
  if (record_ != nullptr) return;
  PL_clear_exception();
  throw Error(Code::kTooLarge, "Prolog has no room to keep an answer");
}

// Needs no engine.
Record::~Record() { PL_erase(static_cast<record_t>(record_)); }

void Record::Put(std::uintptr_t term) const {
  if (PL_recorded(static_cast<record_t>(record_), term)) return;
  PL_clear_exception();
  throw Error(Code::kTooLarge, "a kept answer does not fit Prolog's stacks");
}

}  // namespace lares::prolog
