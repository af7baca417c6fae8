#include <charconv>
#include <cmath>
#include <limits>

#include "base/number.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using syntax::Op;
using Kind = Value::Kind;

namespace {

Decimal RoundedExactly(Op op, const Decimal& number) {
  switch (op) {
    case Op::kCeil:
      return Ceil(number);
    case Op::kFloor:
      return Floor(number);
    case Op::kRound:
      return Round(number);
    default:
      return number.digits < 0 ? Decimal{-number.digits, number.scale} : number;
  }
}

double RoundedRoughly(Op op, double number) {
  switch (op) {
    case Op::kCeil:
      return std::ceil(number);
    case Op::kFloor:
      return std::floor(number);
    case Op::kRound:
      return std::floor(number + 0.5);
    default:
      return std::fabs(number);
  }
}

Value ToInteger(const Value& value) {
  if (value.kind == Kind::kBoolean) return MakeInteger(value.boolean ? 1 : 0);
  if (value.is_numeric()) {
    const auto exact =
        value.kind <= Kind::kDecimal ? std::optional(value.decimal) : DecimalOf(value.number);
    return exact ? MakeNumber(Kind::kInteger, Truncate(*exact)) : Value{};
  }
  const Value read = MakeTyped(std::string(value.text()), kXsdInteger);
  return read.kind == Kind::kInteger ? MakeNumber(Kind::kInteger, read.decimal) : Value{};
}

Value ToDecimal(const Value& value) {
  if (value.kind == Kind::kBoolean) {
    return MakeNumber(Kind::kDecimal, Decimal{value.boolean ? 1 : 0, 0});
  }
  if (value.is_numeric()) {
    return MakeNumber(Kind::kDecimal, value.kind <= Kind::kDecimal ? std::optional(value.decimal)
                                                                   : DecimalOf(value.number));
  }
  const Value read = MakeTyped(std::string(value.text()), kXsdDecimal);
  return read.kind == Kind::kDecimal ? MakeNumber(Kind::kDecimal, read.decimal) : Value{};
}

Value ToFloating(const Value& value, Kind kind) {
  if (value.kind == Kind::kBoolean) return MakeNumber(kind, value.boolean ? 1.0 : 0.0);
  if (value.is_numeric()) return MakeNumber(kind, AsDouble(value));
  const Value read =
      MakeTyped(std::string(value.text()), kind == Kind::kFloat ? kXsdFloat : kXsdDouble);
  return read.kind == kind ? MakeNumber(kind, read.number) : Value{};
}

Value ToBoolean(const Value& value) {
  if (value.kind == Kind::kBoolean) return MakeBoolean(value.boolean);
  if (value.is_numeric()) return MakeBoolean(*EffectiveBoolean(value));
  const Value read = MakeTyped(std::string(value.text()), kXsdBoolean);
  return read.kind == Kind::kBoolean ? MakeBoolean(read.boolean) : Value{};
}

// XPath writes a double between 10^-6 and 10^6 without exponent.
std::string PlainText(const Value& value) {
  if (value.kind == Kind::kBoolean) return value.boolean ? "true" : "false";
  if (value.kind == Kind::kInteger || value.kind == Kind::kDecimal) return ToText(value.decimal);
  if (value.kind == Kind::kFloat || value.kind == Kind::kDouble) {
    const double size = std::fabs(value.number);
    if (size == 0) return std::signbit(value.number) ? "-0" : "0";
    const bool is_float = value.kind == Kind::kFloat;
    if (!(size >= 1e-6 && size < 1e6)) return DoubleText(value.number, is_float);
    char text[64];
    const auto format = std::chars_format::fixed;
    char* const end = text + sizeof text;
    const auto written = is_float
                             ? std::to_chars(text, end, static_cast<float>(value.number), format)
                             : std::to_chars(text, end, value.number, format);
    return {text, written.ptr};
  }
  return std::string(value.text());
}

Value ToTime(const Value& value, Kind kind, std::string_view type) {
  if (value.kind == kind) return value;
  if (value.kind != Kind::kString) return {};
  Value read = MakeTyped(std::string(value.text()), type);
  return read.kind == kind ? read : Value{};
}

bool CanBeNumber(const Value& value) {
  return value.is_numeric() || value.kind == Kind::kBoolean || value.kind == Kind::kString;
}

}  // namespace

Value CallNumberFunction(Op op, Arguments arguments, Context& context) {
  if (op == Op::kRand) {
    const double unit = static_cast<double>(context.random() >> 11) * 0x1.0p-53;
    return MakeNumber(Kind::kDouble, unit);
  }
  const Value& value = arguments[0];
  if (!value.is_numeric()) return {};
  if (value.kind <= Kind::kDecimal) {
    return MakeNumber(value.kind, RoundedExactly(op, value.decimal));
  }
  return MakeNumber(value.kind, RoundedRoughly(op, value.number));
}

Value Cast(std::string_view function, Arguments arguments) {
  if (arguments.size() != 1 || !function.starts_with(rdf::kXsd)) return {};
  const std::string_view type = function.substr(rdf::kXsd.size());
  const Value& value = arguments[0];
  if (type == "string") {
    return value.kind == Kind::kBlank ? Value{} : MakeString(PlainText(value));
  }
  if (type == "dateTime") return ToTime(value, Kind::kDateTime, kXsdDateTime);
  if (type == "date") return ToTime(value, Kind::kDate, kXsdDate);
  if (type == "time") return ToTime(value, Kind::kTime, kXsdTime);
  if (!CanBeNumber(value)) return {};
  if (type == "integer") return ToInteger(value);
  if (type == "decimal") return ToDecimal(value);
  if (type == "double") return ToFloating(value, Kind::kDouble);
  if (type == "float") return ToFloating(value, Kind::kFloat);
  if (type == "boolean") return ToBoolean(value);
  return {};
}

}  // namespace lares::sparql
