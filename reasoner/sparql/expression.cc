#include "reasoner/sparql/expression.h"

#include <cmath>

#include "reasoner/sparql/operator.h"

namespace lares::sparql {

using syntax::Expression;
using syntax::Op;
using Kind = Value::Kind;

namespace {

std::optional<bool> Truth(const Expression& expression, Row& row, Context& context) {
  return EffectiveBoolean(EvaluateExpression(expression, row, context));
}

Value Logical(std::optional<bool> truth) { return truth ? MakeBoolean(*truth) : Value{}; }

// 17.2: an error beside a decisive operand does not matter.
Value Connect(const Expression& e, Row& row, Context& context) {
  const bool decisive = e.op == Op::kOr;
  const auto left = Truth(e.arguments[0], row, context);
  if (left && *left == decisive) return MakeBoolean(decisive);
  const auto right = Truth(e.arguments[1], row, context);
  if (right && *right == decisive) return MakeBoolean(decisive);
  return left && right ? MakeBoolean(!decisive) : Value{};
}

std::optional<bool> Holds(Op op, const Value& a, const Value& b) {
  if (op == Op::kEqual) return EqualValues(a, b);
  if (op == Op::kNotEqual) {
    const auto equal = EqualValues(a, b);
    return equal ? std::optional(!*equal) : std::nullopt;
  }
  const auto order = CompareValues(a, b);
  if (!order) return std::nullopt;
  if (*order == kUnordered) return false;
  switch (op) {
    case Op::kLess:
      return *order < 0;
    case Op::kGreater:
      return *order > 0;
    case Op::kLessEqual:
      return *order <= 0;
    default:
      return *order >= 0;
  }
}

Value In(const Expression& e, Row& row, Context& context) {
  const Value wanted = EvaluateExpression(e.arguments[0], row, context);
  bool has_error = false;
  for (std::size_t i = 1; i < e.arguments.size(); ++i) {
    context.guard.Tick();
    const auto equal = EqualValues(wanted, EvaluateExpression(e.arguments[i], row, context));
    if (equal && *equal) return MakeBoolean(e.op == Op::kIn);
    has_error = has_error || !equal;
  }
  return has_error ? Value{} : MakeBoolean(e.op == Op::kNotIn);
}

Value If(const Expression& e, Row& row, Context& context) {
  const auto truth = Truth(e.arguments[0], row, context);
  if (!truth) return {};
  return EvaluateExpression(e.arguments[*truth ? 1 : 2], row, context);
}

Value Coalesce(const Expression& e, Row& row, Context& context) {
  for (const Expression& argument : e.arguments) {
    Value value = EvaluateExpression(argument, row, context);
    if (!value.is_error()) return value;
  }
  return {};
}

// 18.6: the pattern with the row's terms for its variables.
Value Exists(const Expression& e, Row& row, Context& context) {
  Operator& pattern = *context.exists.at(e.pattern.get());
  Row start = row;
  Row outer = row;
  context.base_row.swap(outer);
  bool exists = false;
  try {
    pattern.Run(context, start, [&](Row&) {
      exists = true;
      return false;
    });
  } catch (...) {
    context.base_row.swap(outer);
    throw;
  }
  context.base_row.swap(outer);
  return MakeBoolean(exists == (e.op == Op::kExists));
}

Value Negate(const Value& value) {
  switch (value.kind) {
    case Kind::kInteger:
    case Kind::kDecimal:
      return MakeNumber(value.kind, Decimal{-value.decimal.digits, value.decimal.scale});
    case Kind::kFloat:
    case Kind::kDouble:
      return MakeNumber(value.kind, -value.number);
    default:
      return {};
  }
}

std::optional<Decimal> CalculateExactly(Op op, const Decimal& a, const Decimal& b) {
  switch (op) {
    case Op::kAdd:
      return Add(a, b);
    case Op::kSubtract:
      return Subtract(a, b);
    case Op::kMultiply:
      return Multiply(a, b);
    default:
      return Divide(a, b);
  }
}

double CalculateRoughly(Op op, double a, double b) {
  switch (op) {
    case Op::kAdd:
      return a + b;
    case Op::kSubtract:
      return a - b;
    case Op::kMultiply:
      return a * b;
    default:
      return a / b;
  }
}

Value Call(const Expression& e, Arguments arguments, Context& context) {
  const Op op = e.op;
  if (op == Op::kCast) return Cast(context.query.terms[e.node.index].value, arguments);
  if (op >= Op::kMd5 && op <= Op::kSha512) return CallHashFunction(op, arguments);
  if (op >= Op::kYear && op <= Op::kNow) return CallTimeFunction(op, arguments, context);
  if (op >= Op::kRand && op <= Op::kRound) return CallNumberFunction(op, arguments, context);
  if ((op >= Op::kConcat && op <= Op::kStrafter) || op >= Op::kRegex) {
    return CallStringFunction(op, arguments, context);
  }
  return CallTermFunction(op, arguments, context);
}

Value EvaluateCall(const Expression& e, Row& row, Context& context) {
  if (e.op == Op::kBound) {
    return MakeBoolean(row[e.arguments[0].node.index] != rdf::kAnyTerm);
  }
  std::vector<Value> arguments;
  arguments.reserve(e.arguments.size());
  for (const Expression& argument : e.arguments) {
    arguments.push_back(EvaluateExpression(argument, row, context));
    if (arguments.back().is_error()) return {};
  }
  context.guard.Tick();
  return Call(e, arguments, context);
}

Value EvaluateOperator(const Expression& e, Row& row, Context& context) {
  switch (e.op) {
    case Op::kNot: {
      const auto truth = Truth(e.arguments[0], row, context);
      return Logical(truth ? std::optional(!*truth) : std::nullopt);
    }
    case Op::kNegate:
      return Negate(EvaluateExpression(e.arguments[0], row, context));
    case Op::kPlus: {
      Value value = EvaluateExpression(e.arguments[0], row, context);
      return value.is_numeric() ? value : Value{};
    }
    default:
      break;
  }
  const Value left = EvaluateExpression(e.arguments[0], row, context);
  const Value right = EvaluateExpression(e.arguments[1], row, context);
  if (e.op >= Op::kAdd && e.op <= Op::kDivide) return Calculate(e.op, left, right);
  return Logical(Holds(e.op, left, right));
}

}  // namespace

Value Calculate(Op op, const Value& a, const Value& b) {
  if (!a.is_numeric() || !b.is_numeric()) return {};
  const Kind kind = std::max(a.kind, b.kind);
  if (kind <= Kind::kDecimal) {
    return MakeNumber(op == Op::kDivide ? Kind::kDecimal : kind,
                      CalculateExactly(op, a.decimal, b.decimal));
  }
  return MakeNumber(kind, CalculateRoughly(op, AsDouble(a), AsDouble(b)));
}

Value EvaluateExpression(const Expression& e, Row& row, Context& context) {
  switch (e.op) {
    case Op::kVariable:
      return context.ValueAt(row[e.node.index]);
    case Op::kTerm:
      return context.Constant(e.node);
    case Op::kOr:
    case Op::kAnd:
      return Connect(e, row, context);
    case Op::kIn:
    case Op::kNotIn:
      return In(e, row, context);
    case Op::kIf:
      return If(e, row, context);
    case Op::kCoalesce:
      return Coalesce(e, row, context);
    case Op::kExists:
    case Op::kNotExists:
      return Exists(e, row, context);
    default:
      if (e.op < Op::kExists) return EvaluateOperator(e, row, context);
      return EvaluateCall(e, row, context);
  }
}

bool IsTrue(const Expression& expression, Row& row, Context& context) {
  return Truth(expression, row, context).value_or(false);
}

}  // namespace lares::sparql
