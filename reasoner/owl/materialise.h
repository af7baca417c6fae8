// OWL 2 RL by materialisation: what follows from a layer and everything below it.
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

struct Options {
  std::size_t max_inferred = 10'000'000;  // triples of one layer; beyond it kTooLarge
  // Matches of patterns tried, beyond 1 000 for each asserted triple; then kTooLarge. Ends what
  // takes ages to conclude little, such as chains over cliques; some seconds.
  std::size_t max_steps = 200'000'000;
  std::size_t max_clashes = 100;  // contradictions kept; later ones are only counted
};

// The closure of `below` ∪ `graphs` under the OWL 2 RL/RDF rules (W3C OWL 2 Profiles, tables 4–9),
// less what `below` holds already: semi-naive, so each new triple rests on at least one of `graphs`
// (or, when `below` is empty, on the rules' axioms). `below` must be closed itself. Contradictions
// do not stop it: they are listed in the layer.
//
// Terms that are the same are stored once, by a representative (Layer::equality); the view answers
// for all. Literals count by their data values: "1"^^xsd:int is what "01"^^xsd:integer is to every
// rule, though a view answers with literals as they were written. What is trivial is not stored
// unless asserted and holds on demand (on_demand.h): c ⊑ c, c ⊑ owl:Thing, owl:Nothing ⊑ c, x a
// owl:Thing, x owl:sameAs x and the like, and what the rules say of datatypes and of OWL's own
// words. Blank predicates may be inferred. Throws kTooLarge, kTimeout (stop requested),
// kUnsupported (two words of OWL itself would be the same).
std::shared_ptr<const rdf::Layer> Materialise(const rdf::View& below,
                                              std::vector<rdf::Graph> graphs,
                                              const Options& options = {},
                                              std::stop_token stop = {});

}  // namespace lares::owl
