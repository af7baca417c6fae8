#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mapping/environment/layer_format.h"

namespace lares::environment {
namespace {

constexpr double kGrossRatio = 3;
constexpr double kGrossDifference_m = 8;
constexpr double kGrossGap_m = 1;

using Bounds = std::array<double, 6>;

double LongerSide_m(const Bounds& bounds_m) {
  return std::max(bounds_m[3] - bounds_m[0], bounds_m[4] - bounds_m[1]);
}

// How far two boxes are apart on the floor plan; 0 when they touch.
double Gap_m(const Bounds& a_m, const Bounds& b_m) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double gap = std::max({a_m[axis] - b_m[axis + 3], b_m[axis] - a_m[axis + 3], 0.0});
    squared += gap * gap;
  }
  return std::sqrt(squared);
}

std::string Metres(double length_m) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g m", length_m);
  return text;
}

std::string Compare(const std::string& larger, const Bounds& larger_m, const std::string& smaller,
                    const Bounds& smaller_m) {
  const double long_m = LongerSide_m(larger_m), short_m = LongerSide_m(smaller_m);
  // A robot may well have stayed in one corner.
  const bool may_be_part = smaller == "trajectory";
  if (!may_be_part && long_m > kGrossRatio * short_m && long_m - short_m > kGrossDifference_m) {
    return "the " + larger + " layer is " + Metres(long_m) + " long but the " + smaller +
           " layer only " + Metres(short_m) + ": are they of one environment?";
  }
  const double gap_m = Gap_m(larger_m, smaller_m);
  if (gap_m > kGrossGap_m) {
    return "the " + larger + " layer and the " + smaller + " layer lie " + Metres(gap_m) +
           " apart: are they in one frame?";
  }
  return {};
}

}  // namespace

std::vector<std::string> WarnOnExtents(const std::map<std::string, LayerFacts>& layers) {
  std::vector<std::string> warnings;
  for (auto a = layers.begin(); a != layers.end(); ++a) {
    for (auto b = std::next(a); b != layers.end(); ++b) {
      if (!a->second.bounds_m || !b->second.bounds_m) continue;
      const bool a_is_larger =
          LongerSide_m(*a->second.bounds_m) >= LongerSide_m(*b->second.bounds_m);
      const auto& larger = a_is_larger ? *a : *b;
      const auto& smaller = a_is_larger ? *b : *a;
      std::string warning =
          Compare(larger.first, *larger.second.bounds_m, smaller.first, *smaller.second.bounds_m);
      if (!warning.empty()) warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace lares::environment
