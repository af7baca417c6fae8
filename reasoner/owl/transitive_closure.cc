#include "reasoner/owl/transitive_closure.h"

namespace lares::owl {
namespace {

std::uint64_t KeyOf(rdf::TermId x, rdf::TermId y) {
  return PairKey(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
}

}  // namespace

std::uint32_t TransitiveClosure::NodeOf(rdf::TermId term) {
  std::uint32_t& node = node_of_[static_cast<std::uint32_t>(term)];
  if (node == 0) {
    successors_.emplace_back();
    predecessors_.emplace_back();
    node = static_cast<std::uint32_t>(successors_.size());
  }
  return node - 1;
}

bool TransitiveClosure::Reaches(rdf::TermId x, rdf::TermId y) const {
  return pairs_.Contains(KeyOf(x, y)) || (below_is_closed_ && below_.Contains({x, property_, y}));
}

void TransitiveClosure::Insert(rdf::TermId x, rdf::TermId y) {
  pairs_.Insert(KeyOf(x, y));
  successors_[NodeOf(x)].push_back(y);
  predecessors_[NodeOf(y)].push_back(x);
}

std::vector<rdf::TermId> TransitiveClosure::SourcesOf(rdf::TermId x, rdf::TermId y) {
  std::vector<rdf::TermId> sources = {x};
  const auto add = [&](rdf::TermId u) {
    if (u != x && !Reaches(u, y)) sources.push_back(u);
  };
  for (const rdf::TermId u : predecessors_[NodeOf(x)]) add(u);
  if (below_is_closed_) {
    for (const rdf::TermId u : below_.Subjects(property_, x)) add(u);
  }
  return sources;
}

std::vector<rdf::TermId> TransitiveClosure::TargetsOf(rdf::TermId y) {
  std::vector<rdf::TermId> targets = {y};
  const std::vector<rdf::TermId>& beyond = successors_[NodeOf(y)];
  targets.insert(targets.end(), beyond.begin(), beyond.end());
  if (below_is_closed_) {
    for (const rdf::TermId v : below_.Objects(y, property_)) targets.push_back(v);
  }
  return targets;
}

}  // namespace lares::owl
