// From syntax to steps.
#pragma once

#include <deque>
#include <memory>

#include "reasoner/sparql/context.h"
#include "reasoner/sparql/steps.h"
#include "reasoner/sparql/variables.h"

namespace lares::sparql {

// A query ready to run in its context. It lives no longer than the context and the query.
struct Plan {
  OperatorPtr root;               // gives rows with the projected columns set
  std::deque<GraphScope> scopes;  // that steps refer to
};

// Throws kUnsupported for SERVICE. `describes`: steps get their detail for people.
std::unique_ptr<Plan> MakePlan(Context& context, bool describes);

// What comes into a step: columns that may be, and that surely are, bound.
struct Bound {
  Slots possible;
  Slots certain;
};

// The text of a pattern's triple, path or expression with names for columns.
std::string TextOf(const syntax::TriplePattern& triple, const syntax::Query& query);
std::string TextOf(const syntax::Path& path, const syntax::Query& query);
std::string TextOf(const syntax::Node& node, const syntax::Query& query);
std::string TextOf(const syntax::Expression& expression, const syntax::Query& query);

}  // namespace lares::sparql
