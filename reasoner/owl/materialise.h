// OWL 2 RL by materialisation: what follows from a layer and everything below it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

// How an inferred triple was found first. `premises` are asserted, held below or were reported
// earlier as conclusions; valid during the call.
struct Derivation {
  std::string_view rule;  // "cax-sco"
  rdf::Triple conclusion;
  std::span<const rdf::Triple> premises;
};

struct Options {
  std::size_t max_inferred = 10'000'000;  // triples of one layer; beyond it kTooLarge
  std::size_t max_clashes = 100;          // contradictions kept; later ones are only counted
  // Called once for each inferred triple, in an order in which each follows from earlier ones. A
  // triple that the graphs assert may be among them.
  std::function<void(const Derivation&)> on_derivation;
};

// The closure of `below` ∪ `graphs` under the OWL 2 RL/RDF rules (W3C OWL 2 Profiles, tables 4–9),
// less what `below` holds already: semi-naive, so each new triple rests on at least one of `graphs`
// (or, when `below` is empty, on the rules' axioms). `below` must be closed itself. Contradictions
// do not stop it: they are listed in the layer. What is trivial is not stored unless asserted: c ⊑
// c, c ⊑ owl:Thing, owl:Nothing ⊑ c, x a owl:Thing, x owl:sameAs x and the like; nor is what has a
// literal as subject, or is owl:sameAs with a literal. Blank predicates may be inferred. Throws
// kTooLarge, kTimeout (stop requested).
std::shared_ptr<const rdf::Layer> Materialise(const rdf::View& below,
                                              std::vector<rdf::Graph> graphs,
                                              const Options& options = {},
                                              std::stop_token stop = {});

}  // namespace lares::owl
