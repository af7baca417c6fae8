// The Prolog engine of the calling thread. Inside this folder only.
#pragma once

#include <cstddef>

namespace lares::prolog {

// Attaches an engine to the calling thread, made at its first goal and kept for the next ones until
// the thread ends. (An engine must stay on one thread: SWI-Prolog 9.0.4 remembers where the C stack
// of the first one is, and an engine that is moved by PL_set_engine aborts the process at the first
// check.) Throws kUnavailable when Prolog gives none.
void AttachThreadEngine(std::size_t stack_limit_bytes);

// Destroys the calling thread's engine, and with it the memory that its stacks have grown to. None
// of its terms or queries may be in use.
void DropThreadEngine();

// Engines that threads now have.
int LiveThreadEngines();

}  // namespace lares::prolog
