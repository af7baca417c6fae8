// Prolog terms to Values and back. Inside this folder only; needs an attached engine.
#pragma once

#include <cstdint>
#include <string>

#include "reasoner/prolog/value.h"

namespace lares::prolog {

using TermRef = std::uintptr_t;  // a term_t
using AtomRef = std::uintptr_t;  // an atom_t

// Makes `term` refer to `value`. Throws kInvalid (text that is not UTF-8), kTooLarge (nesting
// beyond kMaxDepth, Prolog's stacks full).
void PutValue(const Value& value, TermRef term);

// Throws kInternal for what no Value can hold: unbound variables, integers beyond 64 bits,
// rationals, cyclic terms, partial lists, streams and other blobs, dict keys that are not atoms;
// kTooLarge beyond kMaxDepth or kMaxNodes.
Value GetValue(TermRef term);

// The text of an atom or string; "" for anything else.
std::string TextOf(TermRef term);

inline constexpr int kMaxDepth = 2000;
inline constexpr std::size_t kMaxNodes = 1'000'000;

}  // namespace lares::prolog
