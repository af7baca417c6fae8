// Times as people write them on the command line.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "base/time.h"

namespace lares::cli {

// "90d", "12h", "30m", "45s". Throws kInvalid for anything else, and beyond a hundred years.
std::chrono::milliseconds ParseSpan(std::string_view text);

// A span from `now` on (`sign` 1) or back (-1), or a time such as 2026-01-31T12:00:00Z.
Time ParseWhen(const std::string& text, Time now, int sign);

}  // namespace lares::cli
