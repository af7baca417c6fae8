// Numbers and quotations as the checks print them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lares::environment {

// Up to six significant digits, without trailing zeros: "0.08", "1e-05".
std::string ToText(double number);

// At most 40 bytes of foreign text, printable ASCII only, for error messages.
std::string Excerpt(std::string_view text);

// The smallest box around points.
class BoundsBuilder {
 public:
  void Add(double x_m, double y_m, double z_m);
  // min x y z, max x y z; nothing before the first point.
  std::optional<std::array<double, 6>> bounds_m() const { return bounds_m_; }

 private:
  std::optional<std::array<double, 6>> bounds_m_;
};

}  // namespace lares::environment
