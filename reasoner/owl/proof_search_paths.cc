#include <algorithm>

#include "reasoner/owl/flat_map.h"
#include "reasoner/owl/proof_search.h"

namespace lares::owl {

// Before the first question: what a step along a property costs has to be known by the time that
// there are paths of it. Until then its steps are like those of any other rule.
void ProofSearch::FindPathProperties() {
  const Vocabulary& words = derivations_.words();
  path_properties_ = {words.same_as, words.sub_class_of, words.sub_property_of};
  std::vector<rdf::TermId> inferred;
  for (const rdf::TermId p : view_.Subjects(words.type, transitive_property_)) {
    if (view_.IsAsserted({p, words.type, transitive_property_})) {
      path_properties_.insert(p);
    } else {
      inferred.push_back(p);
    }
  }
  std::sort(inferred.begin(), inferred.end());
  for (const rdf::TermId p : inferred) {
    try {
      work_ = depth_ = 0;
      if (Solve({{p, words.type, transitive_property_}, 0}, kMaxDepth)) path_properties_.insert(p);
    } catch (const Error& error) {
      if (error.code() != Code::kTooLarge) throw;  // it can do without paths
    }
  }
}

// That P is transitive, when this has to be said.
std::optional<ProofSearch::Goal> ProofSearch::TransitivityOf(rdf::TermId p) const {
  const Vocabulary& words = derivations_.words();
  if (p == words.same_as || p == words.sub_class_of || p == words.sub_property_of) return {};
  return Goal{{p, words.type, transitive_property_}, 0};
}

ProofPaths& ProofSearch::PathsTo(rdf::TermId p, rdf::TermId target) {
  auto& paths = paths_[PairKey(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(target))];
  if (paths) return *paths;
  unsigned step = 1;
  if (const auto transitivity = TransitivityOf(p)) step += Lower(*transitivity);
  ProofPaths::Edges edges;
  edges.at = [this, p](rdf::TermId node, const auto& add) { EdgesAt(p, node, add); };
  edges.cost = [this](const rdf::Triple& edge) { return Recall({edge, kPath}).cost; };
  edges.better_cost = [this](const rdf::Triple& edge) {
    const Goal goal{edge, kPath};
    Solve(goal, Recall(goal).cost.lower);
    return Recall(goal).cost;
  };
  paths = std::make_unique<ProofPaths>(target, step, std::move(edges));
  return *paths;
}

void ProofSearch::EdgesAt(rdf::TermId p, rdf::TermId node,
                          const std::function<void(const ProofPaths::Edge&)>& add) {
  AddEdges(p, node, false, add);
  if (p != derivations_.words().same_as) return;
  AddEdges(p, node, true, add);
  if (!with_computed_) return;
  for (const rdf::TermId twin : view_.dictionary().ValueTwins(node)) {
    if (twin != node) add({{twin, p, node}, false});  // dt-eq
  }
}

void ProofSearch::AddEdges(rdf::TermId p, rdf::TermId node, bool backwards,
                           const std::function<void(const ProofPaths::Edge&)>& add) {
  const auto& asserted = backwards ? AssertedOf(p).from : AssertedOf(p).to;
  const auto found = asserted.find(node);
  if (found != asserted.end()) {
    for (const rdf::TermId other : found->second) {
      add({backwards ? rdf::Triple{node, p, other} : rdf::Triple{other, p, node}, backwards});
    }
  }
  std::vector<rdf::Triple> derived;
  const rdf::Pattern goal = backwards ? rdf::Pattern{node, p, {}} : rdf::Pattern{{}, p, node};
  derivations_.ForEach(goal, OptionsFor(p, kPath, {}), [&](const Step& step) {
    Work();
    derived.push_back(step.conclusion);
    return true;
  });
  std::sort(derived.begin(), derived.end());
  derived.erase(std::unique(derived.begin(), derived.end()), derived.end());
  for (const rdf::Triple& triple : derived) {
    if (IsTrue(triple)) add({triple, backwards});
  }
}

const ProofSearch::Neighbours& ProofSearch::AssertedOf(rdf::TermId p) {
  auto& kept = asserted_[p];
  if (kept) return *kept;
  kept = std::make_unique<Neighbours>();
  for (const auto& layer : view_.layers()) {
    for (const rdf::Graph& graph : layer->graphs()) {
      for (const rdf::Triple& triple : graph.triples) {
        if (triple.predicate != p) continue;
        kept->to[triple.object].push_back(triple.subject);
        kept->from[triple.subject].push_back(triple.object);
      }
    }
  }
  return *kept;
}

}  // namespace lares::owl
