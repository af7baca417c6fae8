#include "reasoner/sparql/decimal.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lares::sparql {
namespace {

constexpr int kMaxDigits = 38;

Int128 Power(int exponent) {
  Int128 power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

bool Scaled(Int128 digits, int by, Int128& out) {
  if (by > kMaxDigits) return digits == 0 ? (out = 0, true) : false;
  return !__builtin_mul_overflow(digits, Power(by), &out);
}

// Both with the same scale.
struct Pair {
  Int128 a, b;
  int scale;
};

std::optional<Pair> Align(const Decimal& a, const Decimal& b) {
  Pair pair{a.digits, b.digits, std::max(a.scale, b.scale)};
  if (!Scaled(a.digits, pair.scale - a.scale, pair.a)) return std::nullopt;
  if (!Scaled(b.digits, pair.scale - b.scale, pair.b)) return std::nullopt;
  return pair;
}

Decimal Normal(Int128 digits, int scale) {
  while (scale > 0 && digits % 10 == 0) {
    digits /= 10;
    --scale;
  }
  while (scale > Decimal::kMaxScale) {
    digits /= 10;
    --scale;
  }
  return {digits, scale};
}

// The whole part towards zero, and whether something was cut off.
Int128 Whole(const Decimal& number, bool& has_rest) {
  const Int128 power = Power(number.scale);
  has_rest = number.digits % power != 0;
  return number.digits / power;
}

}  // namespace

std::optional<Decimal> ParseDecimal(std::string_view text) {
  bool is_negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    is_negative = text[0] == '-';
    text.remove_prefix(1);
  }
  Int128 digits = 0;
  int scale = -1;
  bool has_digit = false;
  for (const char c : text) {
    if (c == '.' && scale < 0) {
      scale = 0;
      continue;
    }
    if (c < '0' || c > '9') return std::nullopt;
    has_digit = true;
    if (scale >= Decimal::kMaxScale) continue;
    if (__builtin_mul_overflow(digits, 10, &digits)) return std::nullopt;
    if (__builtin_add_overflow(digits, c - '0', &digits)) return std::nullopt;
    if (scale >= 0) ++scale;
  }
  if (!has_digit) return std::nullopt;
  return Normal(is_negative ? -digits : digits, std::max(scale, 0));
}

std::optional<Decimal> DecimalOf(double number) {
  if (!std::isfinite(number) || std::fabs(number) >= 1e37) return std::nullopt;
  char text[128];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed).ptr;
  return ParseDecimal({text, static_cast<std::size_t>(end - text)});
}

double ToDouble(const Decimal& number) {
  const std::string text = ToText(number);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string ToText(const Decimal& number) {
  const bool is_negative = number.digits < 0;
  std::string text;
  Int128 digits = number.digits;
  for (int i = 0; digits != 0 || i <= number.scale; ++i) {
    if (i == number.scale && i > 0) text += '.';
    const int digit = static_cast<int>(digits % 10);
    text += static_cast<char>('0' + (digit < 0 ? -digit : digit));
    digits /= 10;
  }
  if (is_negative) text += '-';
  std::reverse(text.begin(), text.end());
  return text;
}

std::optional<Decimal> Add(const Decimal& a, const Decimal& b) {
  const auto pair = Align(a, b);
  Int128 sum = 0;
  if (!pair || __builtin_add_overflow(pair->a, pair->b, &sum)) return std::nullopt;
  return Normal(sum, pair->scale);
}

std::optional<Decimal> Subtract(const Decimal& a, const Decimal& b) {
  const auto pair = Align(a, b);
  Int128 difference = 0;
  if (!pair || __builtin_sub_overflow(pair->a, pair->b, &difference)) return std::nullopt;
  return Normal(difference, pair->scale);
}

std::optional<Decimal> Multiply(const Decimal& a, const Decimal& b) {
  Int128 product = 0;
  if (__builtin_mul_overflow(a.digits, b.digits, &product)) return std::nullopt;
  return Normal(product, a.scale + b.scale);
}

std::optional<Decimal> Divide(const Decimal& a, const Decimal& b) {
  if (b.digits == 0) return std::nullopt;
  // The quotient at the greatest scale for which the dividend still fits.
  for (int scale = Decimal::kMaxScale; scale >= 0; --scale) {
    Int128 dividend = 0;
    const int by = scale + b.scale - a.scale;
    if (by < 0) {
      dividend = a.digits / Power(-by);
    } else if (!Scaled(a.digits, by, dividend)) {
      continue;
    }
    return Normal(dividend / b.digits, scale);
  }
  return std::nullopt;
}

int Compare(const Decimal& a, const Decimal& b) {
  if (const auto pair = Align(a, b)) return pair->a < pair->b ? -1 : pair->a > pair->b ? 1 : 0;
  const double x = ToDouble(a);
  const double y = ToDouble(b);
  return x < y ? -1 : x > y ? 1 : 0;
}

Decimal Floor(const Decimal& number) {
  bool has_rest = false;
  const Int128 whole = Whole(number, has_rest);
  return {has_rest && number.digits < 0 ? whole - 1 : whole, 0};
}

Decimal Ceil(const Decimal& number) {
  bool has_rest = false;
  const Int128 whole = Whole(number, has_rest);
  return {has_rest && number.digits > 0 ? whole + 1 : whole, 0};
}

Decimal Round(const Decimal& number) {
  const auto moved = Add(number, Decimal{5, 1});
  return moved ? Floor(*moved) : Truncate(number);
}

Decimal Truncate(const Decimal& number) {
  bool has_rest = false;
  return {Whole(number, has_rest), 0};
}

}  // namespace lares::sparql
