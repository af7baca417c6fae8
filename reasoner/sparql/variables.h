// Which columns a pattern may bind, and which it binds in every solution.
#pragma once

#include <set>

#include "reasoner/sparql/syntax.h"

namespace lares::sparql {

using Slots = std::set<syntax::Slot>;

// In-scope variables (SPARQL 1.1, 18.2.1), hidden columns included.
void CollectVisible(const syntax::Pattern& pattern, Slots& visible);
// Those that are bound in every solution.
void CollectCertain(const syntax::Pattern& pattern, Slots& certain);
// Variables that the value depends on, those of patterns in EXISTS included.
void CollectUsed(const syntax::Expression& expression, Slots& used);
// In-scope variables, and those that the pattern's own filters and assignments use.
void CollectMentioned(const syntax::Pattern& pattern, Slots& mentioned);

}  // namespace lares::sparql
