// The steps of a plan. Rows are pushed: a step extends the row that it is given by each of its
// solutions in turn and hands it on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reasoner/sparql/context.h"
#include "reasoner/sparql/function_ref.h"

namespace lares::sparql {

// Returns false to have no more rows.
using Next = FunctionRef<bool(Row&)>;

class Operator {
 public:
  virtual ~Operator() = default;

  // Calls `next` for every solution that is compatible with `row`, with the row extended by it, and
  // leaves the row as it was. False when `next` said so, true when all were given.
  bool Run(Context& context, Row& row, Next next) {
    if (!context.counts_rows) return Step(context, row, next);
    return Step(context, row, [&](Row& extended) {
      ++rows_given;
      return next(extended);
    });
  }

  // For people: "triple", "?x rdf:type ub:Student".
  std::string name;
  std::string detail;
  double estimate = 1;  // rows that it gives for each row that it gets
  std::size_t rows_given = 0;
  std::vector<std::unique_ptr<Operator>> children;

 protected:
  virtual bool Step(Context& context, Row& row, Next next) = 0;
};

using OperatorPtr = std::unique_ptr<Operator>;

}  // namespace lares::sparql
