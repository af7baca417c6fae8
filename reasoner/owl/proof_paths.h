// Cheapest proofs along a transitive property: paths, not pairs of pairs.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

inline constexpr unsigned kUnprovable = std::numeric_limits<unsigned>::max() / 4;

// What is known of the least cost of a proof.
struct ProofCost {
  unsigned lower = 1;
  bool is_exact = false;
};

// Proving u P target by transitivity is choosing a path of edges, each proved in some other way: k
// edges take k − 1 steps (and each step may itself rest on a proof that P is transitive). Edges of
// owl:sameAs may be walked backwards: v = u, v = b → u = b is one step of eq-rep-s, so only the
// last edge needs a step of eq-sym.
//
// Dijkstra's algorithm from the target, whose edges' costs become known little by little; it can be
// continued to a higher bound at any time.
class ProofPaths {
 public:
  struct Edge {
    rdf::Triple triple;
    bool is_backwards = false;
  };
  struct Link {  // the first edge on the way from a node, and what comes after it
    Edge edge;
    rdf::TermId next{};
    unsigned cost = 0;
  };
  struct Edges {
    // Calls the function for each edge that ends at a term (with is_backwards: begins there).
    std::function<void(rdf::TermId, const std::function<void(const Edge&)>&)> at;
    // What is known of the cost of an edge without transitivity; asked again, it knows more.
    std::function<ProofCost(const rdf::Triple&)> cost;
    std::function<ProofCost(const rdf::Triple&)> better_cost;
  };

  // `step` is the cost of one step of transitivity.
  ProofPaths(rdf::TermId target, unsigned step, Edges edges);

  // The least cost from `source`, if it is at most `bound`, else a lower bound beyond that.
  ProofCost CostFrom(rdf::TermId source, unsigned bound);
  // Null for a source whose cost is not exact.
  const Link* LinkFrom(rdf::TermId source) const {
    const auto found = settled_.find(source);
    return found == settled_.end() ? nullptr : &found->second;
  }

 private:
  struct Candidate {
    unsigned cost;  // of the way from `source`
    std::size_t number;
    rdf::TermId source;
    Link link;
    bool is_exact;

    friend bool operator<(const Candidate& a, const Candidate& b) {
      return std::pair(a.cost, a.number) > std::pair(b.cost, b.number);
    }
  };

  void AddEdgesAt(rdf::TermId node, unsigned cost);
  void Push(rdf::TermId source, const Link& link, const ProofCost& edge);
  unsigned Frontier() const;
  template <typename Look>
  auto WhileInWork(const Candidate& candidate, const Look& look);

  rdf::TermId target_;
  unsigned step_;
  Edges edges_;
  std::unordered_map<rdf::TermId, Link> settled_;
  std::priority_queue<Candidate> candidates_;
  std::vector<unsigned> in_work_;  // costs of candidates being looked at, outermost first
  std::size_t count_ = 0;
};

}  // namespace lares::owl
