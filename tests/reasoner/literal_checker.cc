#include "tests/reasoner/literal_checker.h"

#include <map>
#include <regex>
#include <string_view>

#include "ontology/rdf/vocabulary.h"

namespace lares::testing {
namespace {

using Bound = std::optional<std::string>;

// The integers of a datatype, both ends included.
struct Range {
  Bound least, most;
};

const std::map<std::string, Range, std::less<>>& Integers() {
  static const std::map<std::string, Range, std::less<>> ranges = {
      {"integer", {}},
      {"nonNegativeInteger", {"0", {}}},
      {"positiveInteger", {"1", {}}},
      {"nonPositiveInteger", {{}, "0"}},
      {"negativeInteger", {{}, "-1"}},
      {"byte", {"-128", "127"}},
      {"short", {"-32768", "32767"}},
      {"int", {"-2147483648", "2147483647"}},
      {"long", {"-9223372036854775808", "9223372036854775807"}},
      {"unsignedByte", {"0", "255"}},
      {"unsignedShort", {"0", "65535"}},
      {"unsignedInt", {"0", "4294967295"}},
      {"unsignedLong", {"0", "18446744073709551615"}},
  };
  return ranges;
}

// The strings of a datatype.
const std::map<std::string, std::regex, std::less<>>& Strings() {
  static const std::map<std::string, std::regex, std::less<>> patterns = {
      {"string", std::regex("[^]*")},
      {"normalizedString", std::regex("[^\\t\\n\\r]*")},
      {"token", std::regex("([^\\s]+( [^\\s]+)*)?")},
      {"language", std::regex("[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*")},
      {"NMTOKEN", std::regex("[-._:a-zA-Z0-9]+")},
      {"Name", std::regex("[_:a-zA-Z][-._:a-zA-Z0-9]*")},
      {"NCName", std::regex("[_a-zA-Z][-._a-zA-Z0-9]*")},
  };
  return patterns;
}

// Of two canonical integers.
bool IsAtMost(std::string_view a, std::string_view b) {
  const bool a_is_negative = a.front() == '-', b_is_negative = b.front() == '-';
  if (a_is_negative != b_is_negative) return a_is_negative;
  const bool is_at_most = a.size() != b.size() ? a.size() < b.size() : a <= b;
  return a_is_negative ? a == b || !is_at_most : is_at_most;
}

std::string Canonical(const std::string& number) {
  std::string digits = number.front() == '-' || number.front() == '+' ? number.substr(1) : number;
  if (digits.find('.') != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
  }
  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.empty() || digits.front() == '.') digits.insert(0, "0");
  return number.front() == '-' && digits != "0" ? "-" + digits : digits;
}

std::string_view XsdName(std::string_view iri) {
  return iri.starts_with(rdf::kXsd) ? iri.substr(rdf::kXsd.size()) : std::string_view();
}

}  // namespace

std::optional<LiteralValue> MeaningOf(const rdf::TermView& literal) {
  if (literal.kind != rdf::TermKind::kLiteral || !literal.language.empty()) return std::nullopt;
  const std::string_view name = XsdName(literal.datatype);
  const std::string text(literal.value);
  LiteralValue value;
  if (literal.datatype.empty() || Strings().contains(name)) {
    value.canonical = text;
  } else if (name == "decimal" || Integers().contains(name)) {
    const std::regex pattern(name == "decimal" ? "[-+]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)"
                                               : "[-+]?[0-9]+");
    if (!std::regex_match(text, pattern)) return std::nullopt;
    value = {true, Canonical(text)};
  } else {
    return std::nullopt;
  }
  if (!literal.datatype.empty() && !IsOneOf(value, literal.datatype)) return std::nullopt;
  return value;
}

bool IsOneOf(const LiteralValue& value, std::string_view datatype) {
  if (datatype == std::string(rdf::kRdfs) + "Literal") return true;
  if (datatype == std::string(rdf::kRdf) + "PlainLiteral") return !value.is_number;
  const std::string_view name = XsdName(datatype);
  if (!value.is_number) {
    const auto pattern = Strings().find(name);
    return pattern != Strings().end() && std::regex_match(value.canonical, pattern->second);
  }
  if (name == "decimal") return true;
  const auto range = Integers().find(name);
  if (range == Integers().end() || value.canonical.find('.') != std::string::npos) return false;
  const auto& [least, most] = range->second;
  return (!least || IsAtMost(*least, value.canonical)) &&
         (!most || IsAtMost(value.canonical, *most));
}

bool IsKnownDatatype(std::string_view datatype) {
  const std::string_view name = XsdName(datatype);
  return name == "decimal" || Integers().contains(name) || Strings().contains(name) ||
         datatype == std::string(rdf::kRdfs) + "Literal" ||
         datatype == std::string(rdf::kRdf) + "PlainLiteral";
}

}  // namespace lares::testing
