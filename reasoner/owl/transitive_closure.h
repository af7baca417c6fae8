// One transitive property, kept closed edge by edge.
#pragma once

#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/flat_map.h"

namespace lares::owl {

// Kinematic chains run both ways and in circles: closing them one pair of triples at a time tries
// each of n² conclusions n times. Here an edge that follows already costs one look-up, and any
// other edge x → y joins what reaches x to what y reaches (Ibaraki & Katoh 1983), so that nearly
// every conclusion tried is new.
class TransitiveClosure {
 public:
  // With `below_is_closed`, the pairs of `below` count as closed edges; otherwise `below` is not
  // looked at. `below` must outlive this.
  TransitiveClosure(rdf::TermId property, const rdf::View& below, bool below_is_closed)
      : property_(property), below_(below), below_is_closed_(below_is_closed) {}

  // Makes x → y an edge and calls emit(u, v) for each other pair u → v that follows and did not
  // before.
  template <typename Emit>
  void AddEdge(rdf::TermId x, rdf::TermId y, Emit&& emit) {
    if (Reaches(x, y)) return;
    const std::vector<rdf::TermId> sources = SourcesOf(x, y);
    const std::vector<rdf::TermId> targets = TargetsOf(y);
    for (const rdf::TermId u : sources) {
      for (const rdf::TermId v : targets) {
        if (Reaches(u, v)) continue;
        Insert(u, v);
        if (v != y || u != x) emit(u, v);
      }
    }
  }

 private:
  // x, and what reaches x but not y.
  std::vector<rdf::TermId> SourcesOf(rdf::TermId x, rdf::TermId y);
  // y, and what y reaches.
  std::vector<rdf::TermId> TargetsOf(rdf::TermId y);
  template <typename Visit>
  void ForEachBelow(rdf::TermId x, rdf::TermId y, Visit&& visit) const;
  bool Reaches(rdf::TermId x, rdf::TermId y) const;
  void Insert(rdf::TermId x, rdf::TermId y);
  std::uint32_t NodeOf(rdf::TermId term);

  rdf::TermId property_;
  const rdf::View& below_;
  bool below_is_closed_;
  FlatSet pairs_;
  FlatMap node_of_;  // 1-based
  std::vector<std::vector<rdf::TermId>> successors_, predecessors_;
};

}  // namespace lares::owl
