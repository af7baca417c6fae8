#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "recipes/plan/export_fragment.h"

// Any bytes: decorators, or problems; never both.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto fragment =
      lares::recipes::ParseTreeFragment(std::string(reinterpret_cast<const char*>(data), size));
  if (!fragment.problems.empty() && !fragment.decorators.empty()) std::abort();
  if (fragment.decorators.size() > 16) std::abort();
  return 0;
}
