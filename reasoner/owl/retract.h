// What a closure loses when triples are taken back.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "reasoner/owl/one_step.h"

namespace lares::owl {

// One retraction from a layer over closed layers.
struct Retraction {
  OneStep& step;                                        // over the layers and the layer as it was
  std::function<bool(const rdf::Triple&)> is_in_layer;  // and not below it
  std::function<bool(const rdf::Triple&)> stays_asserted;
  std::span<const rdf::Triple> taken_back;  // in the layer, and no longer asserted
  std::size_t max_deleted = 0;
};

struct Retracted {
  TripleSet deleted;                  // of the layer
  std::vector<rdf::Triple> restored;  // of the deleted: these, closed over what remains, come back
};

// Delete-and-rederive (Gupta, Mumick, Subrahmanian 1993): whatever may rest on what is taken back
// is deleted, then what follows in one step from the rest is restored. Pairs of transitive
// properties are deleted and restored together instead of one by one. Nothing when the step gives
// up or too much would be deleted.
//
// Why not backward/forward (Motik, Nenov, Piro, Horrocks 2015), which looks for another proof
// before it deletes: both were measured (benchmarks/README.md). They are even on LUBM(1),
// RoboEarth's ontologies and PR2. On a chain of 500 links backward/forward cost more than
// recomputation, for each of the pairs that go has hundreds of derivations to be looked at;
// here all pairs of a transitive property are treated together, at a quarter of recomputation.
std::optional<Retracted> DeleteAndRederive(const Retraction& retraction);

}  // namespace lares::owl
