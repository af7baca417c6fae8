// What a process may still do once it runs a goal from outside. Irrevocable.
#pragma once

#include <cstddef>

namespace lares::prolog {

struct Confinement {
  std::size_t memory_bytes = std::size_t{512} << 20;  // address space beyond what is mapped already
  int cpu_s = 60;  // the parent's wall clock normally comes first
};

// Lays down everything that can be laid down, from the outside in: low priority and first choice of
// the kernel when memory runs out, nobody's rights instead of root's, death with the parent, limits
// (address space, CPU, no core dump, no file longer than nothing, no further descriptor or
// process), a network namespace without a network where that is allowed, and a filter of system
// calls that knows no file, socket, process or thread. Throws kUnavailable when the limits or the
// filter cannot be had: then no goal may run.
void Confine(const Confinement& confinement);

// As the last step of Confine(): from here on only memory, clocks, and reading and writing what is
// open. Anything else fails with EPERM; what can only be meant to escape (running programs,
// tracing, loading modules) ends the process with SIGSYS.
void FilterSystemCalls();

}  // namespace lares::prolog
