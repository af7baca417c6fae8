#include "base/number.h"

#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

namespace lares {

std::optional<double> ToNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (text.empty() || parsed.ptr != end) return std::nullopt;
  if (parsed.ec == std::errc::result_out_of_range) {
    return std::strtod(std::string(text).c_str(), nullptr);
  }
  if (parsed.ec != std::errc()) return std::nullopt;
  return number;
}

}  // namespace lares
