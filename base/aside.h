// Long computations beside answers that others wait for.
#pragma once

#include <functional>

namespace lares {

// Runs `work` on a thread of its own that gives way to all others (on Linux: by its niceness) and
// waits for it; throws what it throws. A closure or a query that keeps a processor busy for seconds
// then makes nobody wait who asks for little. It costs about 50 µs.
void RunAside(const std::function<void()>& work);

// The same for what gives a value.
template <typename Work>
auto Aside(const Work& work) {
  decltype(work()) value{};
  RunAside([&] { value = work(); });
  return value;
}

}  // namespace lares
