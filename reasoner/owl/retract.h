// What a closure loses when triples are taken back.
#pragma once

#include <functional>
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
};

struct Retracted {
  TripleSet deleted;                  // of the layer
  std::vector<rdf::Triple> restored;  // of the deleted: these, closed over what remains, come back
};

// Delete-and-rederive (Gupta, Mumick, Subrahmanian 1993). Means nothing when the step gave up.
Retracted DeleteAndRederive(const Retraction& retraction);

// Backward/forward (Motik, Nenov, Piro, Horrocks 2015).
Retracted BackwardForward(const Retraction& retraction);

}  // namespace lares::owl
