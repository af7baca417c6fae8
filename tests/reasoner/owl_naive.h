// A second, simple implementation of the OWL 2 RL rules, to compare the engine with.
#pragma once

#include <set>
#include <string>

#include "ontology/triples/view.h"

namespace lares::testing {

struct NaiveClosure {
  std::set<rdf::Triple> triples;  // asserted and inferred
  std::set<std::string> clashes;  // names of the rules that found a contradiction
};

// Tries every rule on everything until nothing changes; the same triples are left out as trivial as
// in owl::Materialise. For small inputs.
NaiveClosure CloseNaively(std::set<rdf::Triple> triples, rdf::Dictionary& dictionary);

}  // namespace lares::testing
