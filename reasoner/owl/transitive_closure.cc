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

// Calls visit(x, y) for the pairs of `below`, each node by the first literal of its value.
template <typename Visit>
void TransitiveClosure::ForEachBelow(rdf::TermId x, rdf::TermId y, Visit&& visit) const {
  const rdf::Dictionary& dictionary = below_.dictionary();
  const auto names = [&](rdf::TermId node) {
    std::vector<rdf::TermId> twins;
    if (node != rdf::kAnyTerm) twins = dictionary.ValueTwins(node);
    if (twins.empty()) twins.push_back(node);
    return twins;
  };
  for (const rdf::TermId subject : names(x)) {
    for (const rdf::TermId object : names(y)) {
      below_.ForEachStored({subject, property_, object}, [&](const rdf::Triple& triple) {
        visit(dictionary.SameValue(triple.subject), dictionary.SameValue(triple.object));
        return true;
      });
    }
  }
}

bool TransitiveClosure::Reaches(rdf::TermId x, rdf::TermId y) const {
  if (pairs_.Contains(KeyOf(x, y))) return true;
  if (!below_is_closed_) return false;
  if (below_.ContainsStored({x, property_, y})) return true;
  bool is_below = false;
  const rdf::Dictionary& dictionary = below_.dictionary();
  if (!dictionary.ValueTwins(x).empty() || !dictionary.ValueTwins(y).empty()) {
    ForEachBelow(x, y, [&](rdf::TermId, rdf::TermId) { is_below = true; });
  }
  return is_below;
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
    ForEachBelow(rdf::kAnyTerm, x, [&](rdf::TermId u, rdf::TermId) { add(u); });
  }
  return sources;
}

std::vector<rdf::TermId> TransitiveClosure::TargetsOf(rdf::TermId y) {
  std::vector<rdf::TermId> targets = {y};
  const std::vector<rdf::TermId>& beyond = successors_[NodeOf(y)];
  targets.insert(targets.end(), beyond.begin(), beyond.end());
  if (below_is_closed_) {
    ForEachBelow(y, rdf::kAnyTerm, [&](rdf::TermId, rdf::TermId v) { targets.push_back(v); });
  }
  return targets;
}

}  // namespace lares::owl
