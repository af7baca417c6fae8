// A closure that keeps up with its documents.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/materialise.h"

namespace lares::owl {

// What Materialise(below, graphs_after, options, stop) gives, made from `before`: an earlier result
// for the same `below`. The triples, who asserts them and the set of contradictions are the same;
// the order of contradictions may differ, and which are kept where there are more than
// `options.max_clashes`. What the difference touches decides the cost; where recomputation is
// cheaper, or needed because equality, the values of literals or unkept contradictions are
// concerned, it is done instead. Throws as Materialise does; `before` stays as it is.
std::shared_ptr<const rdf::Layer> Update(const rdf::View& below, const rdf::Layer& before,
                                         std::vector<rdf::Graph> graphs_after,
                                         const Options& options = {}, std::stop_token stop = {});

}  // namespace lares::owl
