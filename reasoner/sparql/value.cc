#include "reasoner/sparql/value.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/number.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::sparql {

using Kind = Value::Kind;

namespace {

constexpr std::array<std::string_view, 12> kDerivedIntegers = {"nonPositiveInteger",
                                                               "negativeInteger",
                                                               "long",
                                                               "int",
                                                               "short",
                                                               "byte",
                                                               "unsignedLong",
                                                               "unsignedInt",
                                                               "unsignedShort",
                                                               "unsignedByte",
                                                               "positiveInteger",
                                                               "nonNegativeInteger"};

bool IsInteger(std::string_view name) {
  if (name == "integer") return true;
  for (const std::string_view derived : kDerivedIntegers) {
    if (name == derived) return true;
  }
  return false;
}

std::string_view TrimBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

// xsd:double's lexical space: no "infinity", no "inf" in lower case, no hexadecimal.
std::optional<double> ParseDouble(std::string_view text) {
  if (text == "INF" || text == "+INF") return std::numeric_limits<double>::infinity();
  if (text == "-INF") return -std::numeric_limits<double>::infinity();
  if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) return std::nullopt;
  return ToNumber(text);
}

void SetNumber(Value& value, Kind kind, std::optional<Decimal> decimal) {
  if (!decimal) return;
  value.kind = kind;
  value.decimal = *decimal;
}

void SetTime(Value& value, Kind kind, std::optional<DateTime> time) {
  if (!time) return;
  value.kind = kind;
  value.time = *time;
}

void SetTyped(Value& value, std::string_view name, std::string_view text) {
  if (IsInteger(name)) {
    if (text.find('.') == std::string_view::npos) {
      SetNumber(value, Kind::kInteger, ParseDecimal(text));
    }
  } else if (name == "decimal") {
    SetNumber(value, Kind::kDecimal, ParseDecimal(text));
  } else if (name == "double" || name == "float") {
    if (const auto number = ParseDouble(text)) {
      value.kind = name == "float" ? Kind::kFloat : Kind::kDouble;
      value.number = name == "float" ? static_cast<double>(static_cast<float>(*number)) : *number;
    }
  } else if (name == "boolean") {
    if (text == "true" || text == "1" || text == "false" || text == "0") {
      value.kind = Kind::kBoolean;
      value.boolean = text == "true" || text == "1";
    }
  } else if (name == "dateTime") {
    SetTime(value, Kind::kDateTime, ParseDateTime(text));
  } else if (name == "date") {
    SetTime(value, Kind::kDate, ParseDate(text));
  } else if (name == "time") {
    SetTime(value, Kind::kTime, ParseTime(text));
  } else if (name == "string") {
    value.kind = Kind::kString;
  }
}

int Sign(double a, double b) { return a < b ? -1 : a > b ? 1 : 0; }

std::optional<int> CompareNumbers(const Value& a, const Value& b) {
  if (a.kind <= Kind::kDecimal && b.kind <= Kind::kDecimal) return Compare(a.decimal, b.decimal);
  double x = AsDouble(a);
  double y = AsDouble(b);
  if (std::isnan(x) || std::isnan(y)) return kUnordered;
  if (a.kind != Kind::kDouble && b.kind != Kind::kDouble) {
    x = static_cast<double>(static_cast<float>(x));
    y = static_cast<double>(static_cast<float>(y));
  }
  return Sign(x, y);
}

bool IsSameTerm(const Value& a, const Value& b) {
  if (a.id != rdf::kAnyTerm && a.id == b.id) return true;
  return a.text() == b.text() && a.datatype() == b.datatype() && a.term.language == b.term.language;
}

bool IsTime(Kind kind) { return kind >= Kind::kDateTime && kind <= Kind::kTime; }

// Where a kind stands in the order; what can be compared by value shares a place.
int Rank(const Value& value) {
  if (value.is_numeric()) return static_cast<int>(Kind::kInteger);
  return static_cast<int>(value.kind);
}

int OrderNumbers(const Value& a, const Value& b) {
  const int order = *CompareNumbers(a, b);
  if (order != kUnordered) return order;
  const bool a_is_nan = std::isnan(AsDouble(a));
  return a_is_nan == std::isnan(AsDouble(b)) ? 0 : a_is_nan ? -1 : 1;
}

}  // namespace

std::string_view Value::datatype() const {
  switch (kind) {
    case Kind::kLanguageString:
      return kRdfLangString;
    case Kind::kString:
      return kXsdString;
    default:
      return term.datatype.empty() ? kXsdString : term.datatype;
  }
}

Value ValueOf(const rdf::TermView& term, TermId id) {
  Value value;
  value.id = id;
  value.term = term;
  if (term.kind == rdf::TermKind::kIri) {
    value.kind = Kind::kIri;
  } else if (term.kind == rdf::TermKind::kBlank) {
    value.kind = Kind::kBlank;
  } else if (!term.language.empty()) {
    value.kind = Kind::kLanguageString;
  } else if (term.datatype.empty()) {
    value.kind = Kind::kString;
  } else {
    value.kind = Kind::kOther;
    if (term.datatype.starts_with(rdf::kXsd)) {
      SetTyped(value, term.datatype.substr(rdf::kXsd.size()), TrimBlanks(term.value));
    }
  }
  return value;
}

namespace {

Value Made(Kind kind, std::string text, std::string_view datatype) {
  Value value;
  value.kind = kind;
  value.term.kind = rdf::TermKind::kLiteral;
  value.term.datatype = datatype;
  value.made = std::move(text);
  value.is_made = true;
  return value;
}

}  // namespace

Value MakeBoolean(bool boolean) {
  Value value = Made(Kind::kBoolean, boolean ? "true" : "false", kXsdBoolean);
  value.boolean = boolean;
  return value;
}

Value MakeInteger(std::int64_t integer) { return MakeNumber(Kind::kInteger, Decimal{integer, 0}); }

Value MakeNumber(Kind kind, const std::optional<Decimal>& decimal) {
  if (!decimal) return {};
  Value value = Made(kind, ToText(*decimal), kind == Kind::kInteger ? kXsdInteger : kXsdDecimal);
  value.decimal = *decimal;
  return value;
}

Value MakeNumber(Kind kind, double number) {
  const bool is_float = kind == Kind::kFloat;
  if (is_float) number = static_cast<double>(static_cast<float>(number));
  Value value = Made(kind, DoubleText(number, is_float), is_float ? kXsdFloat : kXsdDouble);
  value.number = number;
  return value;
}

Value MakeString(std::string text) { return Made(Kind::kString, std::move(text), {}); }

Value MakeStringLike(const Value& like, std::string text) {
  Value value = MakeString(std::move(text));
  if (like.kind == Kind::kLanguageString) {
    value.kind = Kind::kLanguageString;
    value.term.language = like.term.language;
  }
  return value;
}

Value MakeTyped(std::string text, std::string_view datatype) {
  Value value = Made(Kind::kOther, std::move(text), datatype);
  if (datatype.starts_with(rdf::kXsd)) {
    SetTyped(value, datatype.substr(rdf::kXsd.size()), TrimBlanks(value.made));
  }
  return value;
}

Value MakeIri(std::string iri) {
  Value value = Made(Kind::kIri, std::move(iri), {});
  value.term.kind = rdf::TermKind::kIri;
  return value;
}

Value MakeBlank(std::string label) {
  Value value = Made(Kind::kBlank, std::move(label), {});
  value.term.kind = rdf::TermKind::kBlank;
  return value;
}

TermId Intern(const Value& value, Terms& terms) {
  if (value.id != rdf::kAnyTerm) return value.id;
  rdf::TermView term = value.term;
  term.value = value.text();
  return terms.Intern(term);
}

double AsDouble(const Value& numeric) {
  return numeric.kind <= Kind::kDecimal ? ToDouble(numeric.decimal) : numeric.number;
}

std::string DoubleText(double number, bool is_float) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number < 0 ? "-INF" : "INF";
  char text[64];
  const auto format = std::chars_format::scientific;
  const auto end =
      is_float ? std::to_chars(text, text + sizeof text, static_cast<float>(number), format).ptr
               : std::to_chars(text, text + sizeof text, number, format).ptr;
  // "1.5e+02" → "1.5E2", "1e-07" → "1.0E-7"
  std::string_view written(text, static_cast<std::size_t>(end - text));
  const std::size_t e = written.find('e');
  std::string result(written.substr(0, e));
  if (result.find('.') == std::string::npos) result += ".0";
  int exponent = 0;
  std::string_view digits = written.substr(e + 1);
  if (digits[0] == '+') digits.remove_prefix(1);
  std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  return result + "E" + std::to_string(exponent);
}

std::optional<bool> EffectiveBoolean(const Value& value) {
  switch (value.kind) {
    case Kind::kBoolean:
      return value.boolean;
    case Kind::kString:
      return !value.text().empty();
    case Kind::kInteger:
    case Kind::kDecimal:
      return value.decimal.digits != 0;
    case Kind::kFloat:
    case Kind::kDouble:
      return value.number != 0 && !std::isnan(value.number);
    case Kind::kOther: {
      // A malformed number or boolean is false.
      const std::string_view type = value.datatype();
      if (!type.starts_with(rdf::kXsd)) return std::nullopt;
      const std::string_view name = type.substr(rdf::kXsd.size());
      if (name == "boolean" || name == "decimal" || name == "float" || name == "double" ||
          IsInteger(name)) {
        return false;
      }
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

std::optional<bool> EqualValues(const Value& a, const Value& b) {
  if (a.is_error() || b.is_error()) return std::nullopt;
  if (!a.is_literal() || !b.is_literal()) return a.kind == b.kind && a.text() == b.text();
  if (a.is_numeric() && b.is_numeric()) return *CompareNumbers(a, b) == 0;
  if (a.kind == b.kind && IsTime(a.kind)) {
    if (IsSameTerm(a, b)) return true;
    const auto order = Compare(a.time, b.time);
    return order ? std::optional(*order == 0) : std::nullopt;
  }
  if (a.kind == b.kind && a.kind == Kind::kBoolean) return a.boolean == b.boolean;
  if (IsSameTerm(a, b)) return true;
  // A literal with a language is never equal to one without, whatever that means.
  const bool may_be_equal = a.kind != Kind::kLanguageString && b.kind != Kind::kLanguageString &&
                            (a.kind == Kind::kOther || b.kind == Kind::kOther);
  return may_be_equal ? std::nullopt : std::optional(false);
}

std::optional<int> CompareValues(const Value& a, const Value& b) {
  if (a.is_numeric() && b.is_numeric()) return CompareNumbers(a, b);
  if (a.kind != b.kind) return std::nullopt;
  switch (a.kind) {
    case Kind::kString:
      return a.text().compare(b.text()) < 0 ? -1 : a.text() == b.text() ? 0 : 1;
    case Kind::kBoolean:
      return static_cast<int>(a.boolean) - static_cast<int>(b.boolean);
    case Kind::kDateTime:
    case Kind::kDate:
    case Kind::kTime:
      return Compare(a.time, b.time);
    default:
      return std::nullopt;
  }
}

int OrderValues(const Value& a, const Value& b) {
  if (const int ranks = Rank(a) - Rank(b)) return ranks;
  int order = 0;
  if (a.is_numeric()) order = OrderNumbers(a, b);
  if (IsTime(a.kind)) order = CompareTotal(a.time, b.time);
  if (a.kind == Kind::kBoolean) order = static_cast<int>(a.boolean) - static_cast<int>(b.boolean);
  if (order != 0 || a.is_error()) return order;
  if (a.is_numeric() || IsTime(a.kind) || a.kind == Kind::kBoolean) return 0;
  order = a.text().compare(b.text());
  if (order != 0 || !a.is_literal()) return order;
  order = a.term.language.compare(b.term.language);
  return order != 0 ? order : a.datatype().compare(b.datatype());
}

}  // namespace lares::sparql
