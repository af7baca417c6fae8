#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using syntax::Op;
using Kind = Value::Kind;

Value CallTimeFunction(Op op, Arguments arguments, Context& context) {
  if (op == Op::kNow) return MakeTyped(context.now, kXsdDateTime);
  const Value& value = arguments[0];
  const bool has_date = value.kind == Kind::kDateTime || value.kind == Kind::kDate;
  const bool has_time = value.kind == Kind::kDateTime || value.kind == Kind::kTime;
  if (!has_date && !has_time) return {};
  const DateTime& time = value.time;
  switch (op) {
    case Op::kYear:
      return has_date ? MakeInteger(time.year) : Value{};
    case Op::kMonth:
      return has_date ? MakeInteger(time.month) : Value{};
    case Op::kDay:
      return has_date ? MakeInteger(time.day) : Value{};
    case Op::kHours:
      return has_time ? MakeInteger(time.hour) : Value{};
    case Op::kMinutes:
      return has_time ? MakeInteger(time.minute) : Value{};
    case Op::kSeconds:
      return has_time ? MakeNumber(Kind::kDecimal, time.second) : Value{};
    case Op::kTimezone:
      return time.zone_minutes ? MakeTyped(ZoneDuration(*time.zone_minutes), kXsdDuration)
                               : Value{};
    case Op::kTz:
      return MakeString(ZoneText(time));
    default:
      return {};
  }
}

}  // namespace lares::sparql
