// Wall-clock time as text.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace lares {

using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::milliseconds>;

Time Now();
// RFC 3339 in UTC with milliseconds: "2026-01-31T12:00:00.000Z".
std::string ToRfc3339(Time time);
// Accepts what ToRfc3339 writes, with or without fraction. Nothing when it is not a time.
std::optional<Time> FromRfc3339(std::string_view text);
// "3 days ago", "2 minutes ago", "just now".
std::string ToAge(Time then, Time now);

}  // namespace lares
