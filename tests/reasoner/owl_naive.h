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

// Tries every rule on everything until nothing changes, literals as subjects included; of the
// result what ComparableTriples() leaves. For small inputs.
NaiveClosure CloseNaively(std::set<rdf::Triple> triples, rdf::Dictionary& dictionary);

// What two closures are compared by: each literal by the first of its value; without triples that
// are trivial (reflexive ones, for instance) or have a literal as subject, and without the
// datatypes of what is the same as a literal.
std::set<rdf::Triple> ComparableTriples(const std::set<rdf::Triple>& triples,
                                        rdf::Dictionary& dictionary);
std::set<rdf::Triple> ComparableTriples(const rdf::View& view);

}  // namespace lares::testing
