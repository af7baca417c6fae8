#include "ontology/rdf/literal_value.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/xml_fragment.h"
#include "ontology/rdf/xml_names.h"

namespace lares::rdf {
namespace {

using Space = DataValue::Space;
using Text = std::string_view;

enum class Kind : unsigned char {
  kString,
  kNormalizedString,
  kToken,
  kLanguage,
  kName,
  kNcName,
  kNmToken,
  kPlain,
  kDecimal,
  kInteger,
  kFloat,
  kDouble,
  kBoolean,
  kDateTime,
  kDateTimeStamp,
  kHex,
  kBase64,
  kUri,
  kXml,
  kLiteral
};

// Bounds are canonical integers; empty for none.
struct Datatype {
  Text iri;
  Kind kind;
  Text least, most;
};

#define LARES_XSD "http://www.w3.org/2001/XMLSchema#"
constexpr Datatype kDatatypes[] = {
    {LARES_XSD "string", Kind::kString, "", ""},
    {LARES_XSD "normalizedString", Kind::kNormalizedString, "", ""},
    {LARES_XSD "token", Kind::kToken, "", ""},
    {LARES_XSD "language", Kind::kLanguage, "", ""},
    {LARES_XSD "Name", Kind::kName, "", ""},
    {LARES_XSD "NCName", Kind::kNcName, "", ""},
    {LARES_XSD "NMTOKEN", Kind::kNmToken, "", ""},
    {"http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral", Kind::kPlain, "", ""},
    {LARES_XSD "decimal", Kind::kDecimal, "", ""},
    {LARES_XSD "integer", Kind::kInteger, "", ""},
    {LARES_XSD "nonNegativeInteger", Kind::kInteger, "0", ""},
    {LARES_XSD "nonPositiveInteger", Kind::kInteger, "", "0"},
    {LARES_XSD "positiveInteger", Kind::kInteger, "1", ""},
    {LARES_XSD "negativeInteger", Kind::kInteger, "", "-1"},
    {LARES_XSD "long", Kind::kInteger, "-9223372036854775808", "9223372036854775807"},
    {LARES_XSD "int", Kind::kInteger, "-2147483648", "2147483647"},
    {LARES_XSD "short", Kind::kInteger, "-32768", "32767"},
    {LARES_XSD "byte", Kind::kInteger, "-128", "127"},
    {LARES_XSD "unsignedLong", Kind::kInteger, "0", "18446744073709551615"},
    {LARES_XSD "unsignedInt", Kind::kInteger, "0", "4294967295"},
    {LARES_XSD "unsignedShort", Kind::kInteger, "0", "65535"},
    {LARES_XSD "unsignedByte", Kind::kInteger, "0", "255"},
    {LARES_XSD "float", Kind::kFloat, "", ""},
    {LARES_XSD "double", Kind::kDouble, "", ""},
    {LARES_XSD "boolean", Kind::kBoolean, "", ""},
    {LARES_XSD "dateTime", Kind::kDateTime, "", ""},
    {LARES_XSD "dateTimeStamp", Kind::kDateTimeStamp, "", ""},
    {LARES_XSD "hexBinary", Kind::kHex, "", ""},
    {LARES_XSD "base64Binary", Kind::kBase64, "", ""},
    {LARES_XSD "anyURI", Kind::kUri, "", ""},
    {"http://www.w3.org/1999/02/22-rdf-syntax-ns#XMLLiteral", Kind::kXml, "", ""},
    {"http://www.w3.org/2000/01/rdf-schema#Literal", Kind::kLiteral, "", ""},
};
#undef LARES_XSD

const Datatype* FindDatatype(Text iri) {
  const auto* found = std::find_if(std::begin(kDatatypes), std::end(kDatatypes),
                                   [&](const Datatype& type) { return type.iri == iri; });
  return found == std::end(kDatatypes) ? nullptr : found;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsAlpha(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool AreDigits(Text text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), IsDigit);
}

// "-12.5", "0"; nothing when it is no decimal.
std::optional<std::string> CanonicalDecimal(Text text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t dot = text.find('.');
  Text whole = text.substr(0, dot);
  Text part = dot == Text::npos ? Text() : text.substr(dot + 1);
  if (whole.empty() && part.empty()) return std::nullopt;
  if ((!whole.empty() && !AreDigits(whole)) || (!part.empty() && !AreDigits(part))) {
    return std::nullopt;
  }
  while (whole.starts_with('0')) whole.remove_prefix(1);
  while (part.ends_with('0')) part.remove_suffix(1);
  std::string canonical;
  if (is_negative && !(whole.empty() && part.empty())) canonical = "-";
  canonical += whole.empty() ? Text("0") : whole;
  if (!part.empty()) canonical.append(".").append(part);
  return canonical;
}

bool IsInteger(Text lexical) {
  if (lexical.starts_with('-') || lexical.starts_with('+')) lexical.remove_prefix(1);
  return AreDigits(lexical);
}

// Of canonical integers.
bool IsLess(Text a, Text b) {
  const bool a_negative = a.starts_with('-'), b_negative = b.starts_with('-');
  if (a_negative != b_negative) return a_negative;
  const bool less = a.size() != b.size() ? a.size() < b.size() : a < b;
  return a_negative ? !less && a != b : less;
}

bool IsWithin(Text canonical, const Datatype& type) {
  return canonical.find('.') == Text::npos &&
         (type.least.empty() || !IsLess(canonical, type.least)) &&
         (type.most.empty() || !IsLess(type.most, canonical));
}

// Whether the text has the form "digits [. digits] [e digits]" with signs, as xsd:float wants it.
bool IsFloatForm(Text text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t e = text.find_first_of("eE");
  Text mantissa = text.substr(0, e);
  if (e != Text::npos && !IsInteger(text.substr(e + 1))) return false;
  return !mantissa.empty() && IsDigit(mantissa[0]) + IsDigit(mantissa.back()) > 0 &&
         CanonicalDecimal(mantissa).has_value() && IsDigit(mantissa[mantissa[0] == '.' ? 1 : 0]);
}

template <typename Float>
std::optional<std::string> CanonicalFloat(Text text) {
  if (text == "INF" || text == "+INF") return "INF";
  if (text == "-INF" || text == "NaN") return std::string(text);
  if (!IsFloatForm(text)) return std::nullopt;
  if (text.starts_with('+')) text.remove_prefix(1);
  Float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  std::array<char, 64> buffer{};
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), written.ptr);
}

int Number(Text digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

bool IsLeapYear(long long year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

int DaysOf(long long year, int month) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && IsLeapYear(year) ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

// "+05:00", "Z" for zero, "" for none; nothing when it is malformed.
std::optional<std::string> CanonicalZone(Text zone) {
  if (zone.empty()) return "";
  if (zone == "Z" || zone == "+00:00" || zone == "-00:00") return "Z";
  if (zone.size() != 6 || (zone[0] != '+' && zone[0] != '-') || zone[3] != ':' ||
      !AreDigits(zone.substr(1, 2)) || !AreDigits(zone.substr(4, 2))) {
    return std::nullopt;
  }
  const int hours = Number(zone.substr(1, 2)), minutes = Number(zone.substr(4, 2));
  if (minutes > 59 || hours * 60 + minutes > 14 * 60) return std::nullopt;
  return std::string(zone);
}

// "2009-04-21T12:30:15.5Z" without needless zeros; 24:00:00 is the next day's beginning.
std::optional<std::string> CanonicalDateTime(Text text, bool needs_zone) {
  const bool is_before_zero = text.starts_with('-');
  if (is_before_zero) text.remove_prefix(1);
  const std::size_t dash = text.find('-');
  if (dash == Text::npos || dash < 4 || dash > 12 || !AreDigits(text.substr(0, dash)) ||
      (dash > 4 && text[0] == '0')) {
    return std::nullopt;
  }
  long long year = 0;
  std::from_chars(text.data(), text.data() + dash, year);
  if (is_before_zero) year = -year;
  const Text rest = text.substr(dash);
  const auto two = [&](std::size_t at) {
    return at + 2 <= rest.size() && AreDigits(rest.substr(at, 2)) ? Number(rest.substr(at, 2)) : -1;
  };
  if (rest.size() < 15 || rest[3] != '-' || rest[6] != 'T' || rest[9] != ':' || rest[12] != ':') {
    return std::nullopt;
  }
  int month = two(1), day = two(4), hour = two(7);
  const int minute = two(10), second = two(13);
  std::size_t at = 15;
  std::string fraction;
  if (at < rest.size() && rest[at] == '.') {
    const std::size_t end = std::min(rest.find_first_not_of("0123456789", at + 1), rest.size());
    if (end == at + 1) return std::nullopt;
    fraction = rest.substr(at, end - at);
    while (fraction.ends_with('0')) fraction.pop_back();
    if (fraction == ".") fraction.clear();
    at = end;
  }
  const auto zone = CanonicalZone(rest.substr(at));
  if (!zone || (needs_zone && zone->empty())) return std::nullopt;
  if (month < 1 || month > 12 || day < 1 || day > DaysOf(year, month) || minute < 0 ||
      minute > 59 || second < 0 || second > 59 || hour < 0 || hour > 24) {
    return std::nullopt;
  }
  if (hour == 24) {
    if (minute != 0 || second != 0 || !fraction.empty()) return std::nullopt;
    hour = 0;
    if (++day > DaysOf(year, month)) {
      day = 1;
      if (++month > 12) {
        month = 1;
        ++year;
      }
    }
  }
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%04lld-%02d-%02dT%02d:%02d:%02d", year, month, day,
                hour, minute, second);
  return buffer.data() + fraction + *zone;
}

std::optional<std::string> CanonicalHex(Text text) {
  if (text.size() % 2 != 0) return std::nullopt;
  std::string canonical;
  for (const char c : text) {
    if (!IsDigit(c) && !(c >= 'a' && c <= 'f') && !(c >= 'A' && c <= 'F')) return std::nullopt;
    canonical += c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return canonical;
}

std::optional<std::string> CanonicalBase64(Text text) {
  std::string canonical;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' && i > 0 && text[i - 1] != ' ' && i + 1 < text.size()) continue;
    canonical += text[i];
  }
  if (canonical.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    const char c = canonical[i];
    if (c == '=') {
      ++padding;
    } else if (padding != 0 || (!IsAlpha(c) && !IsDigit(c) && c != '+' && c != '/')) {
      return std::nullopt;
    }
  }
  if (padding > 2) return std::nullopt;
  if (padding == 0) return canonical;
  // The bits that padding cuts off must be zero.
  const Text allowed = padding == 1 ? "AEIMQUYcgkosw048" : "AQgw";
  if (allowed.find(canonical[canonical.size() - padding - 1]) == Text::npos) return std::nullopt;
  return canonical;
}

bool IsUriReference(Text text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c <= 0x20 || c == 0x7F || Text("<>\"{}|\\^`").find(text[i]) != Text::npos) return false;
    if (c == '%' &&
        (i + 2 >= text.size() || !std::isxdigit(static_cast<unsigned char>(text[i + 1])) ||
         !std::isxdigit(static_cast<unsigned char>(text[i + 2])))) {
      return false;
    }
  }
  // What stands before a first colon is a scheme (RFC 3986, section 4.2).
  const std::size_t colon = text.find_first_of(":/?#");
  if (colon == Text::npos || text[colon] != ':') return true;
  return colon > 0 && IsAlpha(text[0]) &&
         std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
           return IsAlpha(c) || IsDigit(c) || c == '+' || c == '-' || c == '.';
         });
}

// BCP 47 as XML Schema has it: 1 to 8 letters, then "-" and 1 to 8 letters or digits.
bool IsLanguageTag(Text text) {
  const std::vector<std::string> parts = Split(text, '-');
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].empty() || parts[i].size() > 8) return false;
    if (!std::all_of(parts[i].begin(), parts[i].end(),
                     [&](char c) { return IsAlpha(c) || (i > 0 && IsDigit(c)); })) {
      return false;
    }
  }
  return true;
}

bool IsToken(Text text) {
  return text.find_first_of("\t\n\r") == Text::npos && text.find("  ") == Text::npos &&
         !text.starts_with(' ') && !text.ends_with(' ');
}

// Whether text is of the type derived from xsd:string.
bool IsText(Text text, Kind kind) {
  switch (kind) {
    case Kind::kString:
      return true;
    case Kind::kNormalizedString:
      return text.find_first_of("\t\n\r") == Text::npos;
    case Kind::kToken:
      return IsToken(text);
    case Kind::kLanguage:
      return IsLanguageTag(text);
    case Kind::kName:
      return IsXmlName(text, {.allows_colon = true});
    case Kind::kNcName:
      return IsXmlName(text, {});
    case Kind::kNmToken:
      return IsXmlName(text, {.allows_colon = true, .is_token = true});
    default:
      return false;
  }
}

std::string TextValue(Text text, Text language) {
  return ToLower(language) + std::string(1, '\0') + std::string(text);
}

std::optional<std::string> PlainText(Text lexical) {
  const std::size_t at = lexical.rfind('@');
  if (at == Text::npos) return std::nullopt;
  const Text language = lexical.substr(at + 1);
  if (!language.empty() && !IsLanguageTag(language)) return std::nullopt;
  return TextValue(lexical.substr(0, at), language);
}

std::optional<DataValue> Of(Space space, std::optional<std::string> canonical) {
  if (!canonical) return std::nullopt;
  return DataValue{space, std::move(*canonical)};
}

}  // namespace

std::optional<DataValue> ValueOf(const TermView& literal) {
  const Text text = literal.value;
  if (!literal.language.empty()) return DataValue{Space::kText, TextValue(text, literal.language)};
  if (literal.datatype.empty()) return DataValue{Space::kText, TextValue(text, "")};
  const Datatype* type = FindDatatype(literal.datatype);
  if (type == nullptr) return std::nullopt;
  switch (type->kind) {
    case Kind::kPlain:
      return Of(Space::kText, PlainText(text));
    case Kind::kDecimal:
      return Of(Space::kDecimal, CanonicalDecimal(text));
    case Kind::kInteger: {
      if (!IsInteger(text)) return std::nullopt;
      auto canonical = CanonicalDecimal(text);
      if (!IsWithin(*canonical, *type)) return std::nullopt;
      return Of(Space::kDecimal, std::move(canonical));
    }
    case Kind::kFloat:
      return Of(Space::kFloat, CanonicalFloat<float>(text));
    case Kind::kDouble:
      return Of(Space::kDouble, CanonicalFloat<double>(text));
    case Kind::kBoolean:
      if (text == "true" || text == "1") return DataValue{Space::kBoolean, "true"};
      if (text == "false" || text == "0") return DataValue{Space::kBoolean, "false"};
      return std::nullopt;
    case Kind::kDateTime:
    case Kind::kDateTimeStamp:
      return Of(Space::kTime, CanonicalDateTime(text, type->kind == Kind::kDateTimeStamp));
    case Kind::kHex:
      return Of(Space::kHex, CanonicalHex(text));
    case Kind::kBase64:
      return Of(Space::kBase64, CanonicalBase64(text));
    case Kind::kUri:
      if (!IsUriReference(text)) return std::nullopt;
      return DataValue{Space::kUri, std::string(text)};
    case Kind::kXml:
      if (!IsXmlFragment(text)) return std::nullopt;
      return DataValue{Space::kXml, std::string(text)};
    case Kind::kLiteral:
      return std::nullopt;
    default:
      if (!IsText(text, type->kind)) return std::nullopt;
      return DataValue{Space::kText, TextValue(text, "")};
  }
}

std::span<const std::string_view> SupportedDatatypes() {
  static const auto iris = [] {
    std::array<Text, std::size(kDatatypes)> names;
    std::transform(std::begin(kDatatypes), std::end(kDatatypes), names.begin(),
                   [](const Datatype& type) { return type.iri; });
    return names;
  }();
  return iris;
}

bool IsSupportedDatatype(std::string_view iri) { return FindDatatype(iri) != nullptr; }

bool IsInDatatype(const DataValue& value, std::string_view datatype) {
  const Datatype* type = FindDatatype(datatype);
  if (type == nullptr) return false;
  const auto has_zone = [&] {
    const Text text = value.canonical;
    return text.ends_with('Z') || text.find_first_of("+-", text.find('T')) != Text::npos;
  };
  switch (type->kind) {
    case Kind::kLiteral:
      return true;
    case Kind::kPlain:
      return value.space == Space::kText;
    case Kind::kDecimal:
      return value.space == Space::kDecimal;
    case Kind::kInteger:
      return value.space == Space::kDecimal && IsWithin(value.canonical, *type);
    case Kind::kFloat:
      return value.space == Space::kFloat;
    case Kind::kDouble:
      return value.space == Space::kDouble;
    case Kind::kBoolean:
      return value.space == Space::kBoolean;
    case Kind::kDateTime:
      return value.space == Space::kTime;
    case Kind::kDateTimeStamp:
      return value.space == Space::kTime && has_zone();
    case Kind::kHex:
      return value.space == Space::kHex;
    case Kind::kBase64:
      return value.space == Space::kBase64;
    case Kind::kUri:
      return value.space == Space::kUri;
    case Kind::kXml:
      return value.space == Space::kXml;
    default:
      return value.space == Space::kText && value.canonical.starts_with('\0') &&
             IsText(Text(value.canonical).substr(1), type->kind);
  }
}

}  // namespace lares::rdf
