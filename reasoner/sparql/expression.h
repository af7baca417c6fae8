// Values of expressions (SPARQL 1.1, section 17).
#pragma once

#include <span>

#include "reasoner/sparql/context.h"

namespace lares::sparql {

// The value for this row; kError for a type error or an unbound variable. Faults (limits) throw.
Value EvaluateExpression(const syntax::Expression& expression, Row& row, Context& context);
// What FILTER asks: an error is no.
bool IsTrue(const syntax::Expression& expression, Row& row, Context& context);

// Arithmetic with the promotions of XPath 2.0: kAdd, kSubtract, kMultiply, kDivide.
Value Calculate(syntax::Op op, const Value& a, const Value& b);

// The built-in functions by kind; `op` is one of theirs, the arguments as many as it takes.
using Arguments = std::span<const Value>;
Value CallTermFunction(syntax::Op op, Arguments arguments, Context& context);
Value CallStringFunction(syntax::Op op, Arguments arguments, Context& context);
Value CallNumberFunction(syntax::Op op, Arguments arguments, Context& context);
Value CallTimeFunction(syntax::Op op, Arguments arguments, Context& context);
Value CallHashFunction(syntax::Op op, Arguments arguments);
// xsd:integer(…) and the other constructor functions; an unknown function is an error value.
Value Cast(std::string_view function, Arguments arguments);

}  // namespace lares::sparql
