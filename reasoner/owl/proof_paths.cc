#include "reasoner/owl/proof_paths.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace lares::owl {

ProofPaths::ProofPaths(rdf::TermId target, unsigned step, Edges edges)
    : target_(target), step_(step), edges_(std::move(edges)) {
  AddEdgesAt(target, 0);
}

unsigned ProofPaths::Frontier() const {
  unsigned frontier = candidates_.empty() ? kUnprovable : candidates_.top().cost;
  for (const unsigned cost : in_work_) frontier = std::min(frontier, cost);
  return frontier;
}

// Link::cost is what comes after the edge: of the way from `next`, with the step that joins both.
void ProofPaths::Push(rdf::TermId source, const Link& link, const ProofCost& edge) {
  if (edge.lower >= kUnprovable) return;
  candidates_.push({link.cost + edge.lower, ++count_, source, link, edge.is_exact});
}

void ProofPaths::AddEdgesAt(rdf::TermId node, unsigned cost) {
  edges_.at(node, [&](const Edge& edge) {
    const rdf::TermId source = edge.is_backwards ? edge.triple.object : edge.triple.subject;
    if (settled_.contains(source)) return;
    const unsigned after = node != target_ ? cost + step_ : edge.is_backwards ? 1 : 0;
    Push(source, {edge, node, after}, edges_.cost(edge.triple));
  });
}

// Looking at a candidate may be given up (too much work): then it waits again, as if nothing had
// been looked at. Edges that were added by then come twice, which is of no harm.
template <typename Look>
auto ProofPaths::WhileInWork(const Candidate& candidate, const Look& look) {
  struct Guard {
    ProofPaths& paths;
    const Candidate& candidate;
    bool is_done = false;
    ~Guard() {
      paths.in_work_.pop_back();
      if (!is_done) paths.candidates_.push(candidate);
    }
  };
  in_work_.push_back(candidate.cost);
  Guard guard{*this, candidate};
  if constexpr (std::is_void_v<decltype(look())>) {
    look();
    guard.is_done = true;
  } else {
    auto result = look();
    guard.is_done = true;
    return result;
  }
}

ProofCost ProofPaths::CostFrom(rdf::TermId source, unsigned bound) {
  // A question asked while an edge is looked at is about less than that edge costs, so what has to
  // be known for it is settled already.
  while (!settled_.contains(source) && !candidates_.empty() && Frontier() <= bound &&
         candidates_.top().cost == Frontier()) {
    const Candidate best = candidates_.top();
    candidates_.pop();
    if (settled_.contains(best.source)) continue;
    if (!best.is_exact) {
      const ProofCost known = edges_.cost(best.link.edge.triple);
      if (known.is_exact || best.link.cost + known.lower > best.cost) {
        Push(best.source, best.link, known);  // more is known than when it was put here
        continue;
      }
      const ProofCost edge =
          WhileInWork(best, [&] { return edges_.better_cost(best.link.edge.triple); });
      Push(best.source, best.link, edge);
      continue;
    }
    Link link = best.link;
    link.cost = best.cost;
    // Of a circle no way leads on.
    if (best.source != target_) {
      WhileInWork(best, [&] { AddEdgesAt(best.source, best.cost); });
    }
    settled_.emplace(best.source, link);
  }
  const auto found = settled_.find(source);
  if (found != settled_.end()) return {found->second.cost, true};
  return {std::max(Frontier(), 1U), false};
}

}  // namespace lares::owl
