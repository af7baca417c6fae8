// xsd:decimal and xsd:integer as exact numbers of up to 38 digits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lares::sparql {

__extension__ using Int128 = __int128;

// digits / 10^scale, without trailing zeros after the point. What does not fit is nothing: the
// arithmetic of a query turns that into an error value.
struct Decimal {
  Int128 digits = 0;
  int scale = 0;  // at least 0

  static constexpr int kMaxScale = 18;
};

// "[+-]digits[.digits]", all of the text.
std::optional<Decimal> ParseDecimal(std::string_view text);
// A finite number; fractions are cut after kMaxScale digits.
std::optional<Decimal> DecimalOf(double number);
double ToDouble(const Decimal& number);
// As XPath writes it: "5", "-0.25".
std::string ToText(const Decimal& number);

std::optional<Decimal> Add(const Decimal& a, const Decimal& b);
std::optional<Decimal> Subtract(const Decimal& a, const Decimal& b);
std::optional<Decimal> Multiply(const Decimal& a, const Decimal& b);
// Nothing also for b = 0.
std::optional<Decimal> Divide(const Decimal& a, const Decimal& b);
int Compare(const Decimal& a, const Decimal& b);  // -1, 0, 1

// To whole numbers: towards -∞, towards +∞, to the nearest (halves towards +∞), towards 0.
Decimal Floor(const Decimal& number);
Decimal Ceil(const Decimal& number);
Decimal Round(const Decimal& number);
Decimal Truncate(const Decimal& number);

}  // namespace lares::sparql
