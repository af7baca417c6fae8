#include "ontology/rdf/jsonld_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace lares::rdf::jsonld {
namespace {

std::string CanonicalDouble(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15E", number);
  const std::string all(text);
  const std::size_t e = all.find('E');
  std::string mantissa = all.substr(0, e);
  while (mantissa.ends_with('0') && !mantissa.ends_with(".0")) mantissa.pop_back();
  return mantissa + "E" + std::to_string(std::atoi(all.c_str() + e + 1));
}

// ECMAScript's Number::toString: the shortest digits that give the number back.
std::string EcmaNumber(double number) {
  if (number == 0) return "0";
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(number),
                                 std::chars_format::scientific)
                       .ptr;
  const std::string text(buffer.data(), end);
  const std::size_t e = text.find('e');
  const int exponent = std::atoi(text.c_str() + e + 1);
  std::string digits = text.substr(0, e);
  std::erase(digits, '.');
  const int count = static_cast<int>(digits.size());
  const int point = exponent + 1;  // digits before the decimal point
  std::string out = number < 0 ? "-" : "";
  if (count <= point && point <= 21) {
    return out + digits + std::string(static_cast<std::size_t>(point - count), '0');
  }
  if (point > 0 && point <= 21) {
    return out + digits.insert(static_cast<std::size_t>(point), ".");
  }
  if (point > -6 && point <= 0) {
    return out + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  }
  if (count > 1) digits.insert(1, ".");
  return out + digits + "e" + (exponent < 0 ? "-" : "+") + std::to_string(std::abs(exponent));
}

std::string EscapedString(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    static constexpr std::string_view kShort = "\"\\\b\f\n\r\t";
    static constexpr std::string_view kLetters = "\"\\bfnrt";
    if (const std::size_t at = kShort.find(c); at != std::string_view::npos) {
      out += '\\';
      out += kLetters[at];
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
    } else {
      out += c;
    }
  }
  return out + '"';
}

// UTF-8's order is that of code points; in UTF-16 those beyond U+FFFF come before U+E000–U+FFFF.
bool IsBeforeInUtf16(const std::string& a, const std::string& b) {
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (x == a.end() || y == b.end()) return x == a.end() && y != b.end();
  const auto left = static_cast<unsigned char>(*x);
  const auto right = static_cast<unsigned char>(*y);
  if (left >= 0xF0 && (right == 0xEE || right == 0xEF)) return true;
  if (right >= 0xF0 && (left == 0xEE || left == 0xEF)) return false;
  return left < right;
}

void Append(const Value& value, std::string& out);

void AppendObject(const Value& value, std::string& out) {
  std::vector<const Member*> members;
  for (const Member& member : value.members) members.push_back(&member);
  std::sort(members.begin(), members.end(),
            [](const Member* a, const Member* b) { return IsBeforeInUtf16(a->key, b->key); });
  const char* separator = "{";
  for (const Member* member : members) {
    out += separator + EscapedString(member->key) + ":";
    Append(member->value, out);
    separator = ",";
  }
  out += members.empty() ? "{}" : "}";
}

void Append(const Value& value, std::string& out) {
  switch (value.kind) {
    case Value::Kind::kNull:
      out += "null";
      break;
    case Value::Kind::kBoolean:
      out += value.boolean ? "true" : "false";
      break;
    case Value::Kind::kNumber:
      out += EcmaNumber(std::strtod(value.text.c_str(), nullptr));
      break;
    case Value::Kind::kString:
      out += EscapedString(value.text);
      break;
    case Value::Kind::kArray: {
      const char* separator = "[";
      for (const Value& item : value.items) {
        out += separator;
        Append(item, out);
        separator = ",";
      }
      out += value.items.empty() ? "[]" : "]";
      break;
    }
    case Value::Kind::kObject:
      AppendObject(value, out);
  }
}

bool IsInteger(const std::string& text) {
  const std::size_t start = text.starts_with('-') ? 1 : 0;
  return text.find_first_not_of("0123456789", start) == std::string::npos;
}

}  // namespace

Numeral ToNumeral(const std::string& json_number, bool as_double) {
  const double number = std::strtod(json_number.c_str(), nullptr);
  if (as_double || std::abs(number) >= 1e21 || number != std::floor(number)) {
    return {CanonicalDouble(number), true};
  }
  if (number == 0) return {"0", false};
  if (IsInteger(json_number)) return {json_number, false};  // all its digits
  char text[40];
  std::snprintf(text, sizeof text, "%.0f", number);
  return {text, false};
}

std::string Canonical(const Value& value) {
  std::string out;
  Append(value, out);
  return out;
}

}  // namespace lares::rdf::jsonld
