// Long computations beside answers that others wait for.
#pragma once

#include <functional>

namespace lares {

// Makes the calling thread give way to all others, for good (on Linux: by its niceness).
void GiveWay();

// Runs `work` on a thread of its own that gives way to all others, and waits for it; throws what it
// throws. A closure or a query that keeps a processor busy for seconds then makes nobody wait who
// asks for little. It costs the start of a thread.
void RunAside(const std::function<void()>& work);

// The same for what gives a value.
template <typename Work>
auto Aside(const Work& work) {
  decltype(work()) value{};
  RunAside([&] { value = work(); });
  return value;
}

}  // namespace lares
