// In which order the parts of a join are asked.
#pragma once

#include <vector>

#include "reasoner/sparql/plan.h"

namespace lares::sparql {

// A part that may stand anywhere among its neighbours.
struct JoinPart {
  const syntax::TriplePattern* triple = nullptr;  // or
  const syntax::Pattern* pattern = nullptr;       // anything else
  Slots columns;                                  // that it may bind
  double estimate = 0;                            // rows for each row before it, once ordered
};

// By estimated rows: triple patterns by the index and, for variables that are bound by then, by the
// matches of a few samples. Up to eight parts every beginning is tried; afterwards always the part
// with the fewest rows among those that share a variable with what stands before.
void OrderJoin(std::vector<JoinPart>& parts, const Slots& bound, Source& source, Context& context);

}  // namespace lares::sparql
