#include "mapping/environment/facts.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

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

void BoundsBuilder::Add(double x_m, double y_m, double z_m) {
  const double point[3] = {x_m, y_m, z_m};
  if (!bounds_m_) bounds_m_ = {x_m, y_m, z_m, x_m, y_m, z_m};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (*bounds_m_)[axis] = std::min((*bounds_m_)[axis], point[axis]);
    (*bounds_m_)[axis + 3] = std::max((*bounds_m_)[axis + 3], point[axis]);
  }
}

}  // namespace lares::environment
