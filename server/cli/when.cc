#include "server/cli/when.h"

#include <charconv>

#include "base/error.h"

namespace lares::cli {
namespace {

constexpr std::int64_t kLongest_s = std::int64_t{100} * 366 * 86'400;

std::int64_t SecondsOf(char unit) {
  switch (unit) {
    case 'd':
      return 86'400;
    case 'h':
      return 3'600;
    case 'm':
      return 60;
    case 's':
      return 1;
    default:
      return 0;
  }
}

}  // namespace

std::chrono::milliseconds ParseSpan(std::string_view text) {
  std::int64_t count = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, count);
  const std::int64_t unit_s = rest + 1 == end ? SecondsOf(*rest) : 0;
  if (error != std::errc() || unit_s == 0 || count < 0 || count > kLongest_s / unit_s) {
    throw Error(Code::kInvalid, "'" + std::string(text) + "' is no span of time")
        .WithHint("write it as 90d, 12h, 30m or 45s, or as a time: 2030-01-31T12:00:00Z");
  }
  return std::chrono::seconds(count * unit_s);
}

Time ParseWhen(const std::string& text, Time now, int sign) {
  if (const auto time = FromRfc3339(text)) return *time;
  return now + sign * ParseSpan(text);
}

}  // namespace lares::cli
