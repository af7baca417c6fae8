#include "mapping/environment/facts.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace lares::environment {

std::string ToText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}

std::string Excerpt(std::string_view text) {
  std::string excerpt(text.substr(0, 40));
  for (char& c : excerpt) {
    if (c < 0x20 || c > 0x7E) c = '?';
  }
  return text.size() > 40 ? excerpt + "…" : excerpt;
}

std::optional<double> ToNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (text.empty() || parsed.ptr != end) return std::nullopt;
  // Too large is an infinity and too small is zero, as strtod has it.
  if (parsed.ec == std::errc::result_out_of_range)
    return std::strtod(std::string(text).c_str(), nullptr);
  if (parsed.ec != std::errc()) return std::nullopt;
  return number;
}

void BoundsBuilder::Add(double x_m, double y_m, double z_m) {
  const double point[3] = {x_m, y_m, z_m};
  if (!bounds_m_) bounds_m_ = {x_m, y_m, z_m, x_m, y_m, z_m};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (*bounds_m_)[axis] = std::min((*bounds_m_)[axis], point[axis]);
    (*bounds_m_)[axis + 3] = std::max((*bounds_m_)[axis + 3], point[axis]);
  }
}

}  // namespace lares::environment
