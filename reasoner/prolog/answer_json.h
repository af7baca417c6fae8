// Prolog terms of an answer as JSON. Inside this folder only; needs an attached engine.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/terms.h"

namespace lares::prolog {

// What one answer may hold; whatever is beyond it is replaced by {"type":"cut","why":…}.
struct AnswerLimits {
  int max_depth = 64;
  std::size_t max_nodes = 50'000;
  std::size_t max_text_bytes = 1u << 20;  // of all texts of an answer together
  std::size_t max_one_text_bytes = 1u << 16;
};

using Binding = std::pair<std::string, TermRef>;  // a variable of the goal and what it stands for

// {"X": value, …} on one line, in the order of the bindings. Lists are arrays; numbers (integers up
// to 2^53) and strings are themselves; all else is an object with a "type": uri, bnode and literal
// as in SPARQL 1.1 Query Results JSON Format (W3C 2013), atom, integer, rational, float, compound,
// dict, variable, opaque, cyclic, cut. Never fails for a term, whatever it holds.
std::string AnswerJson(const rdf::View& view, const std::vector<Binding>& bindings,
                       const AnswerLimits& limits = {});

}  // namespace lares::prolog
