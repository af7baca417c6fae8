#include "reasoner/authority/structure.h"

#include <algorithm>

namespace lares::authority {
namespace {

constexpr std::size_t kMaxNodes = 2000;  // of one structure: bounds the recursion

}  // namespace

bool StructureMatch::IsBlank(rdf::TermId term) const {
  return view_.dictionary().Kind(term) == rdf::TermKind::kBlank;
}

void StructureMatch::AddStructure(rdf::TermId node, std::vector<rdf::Triple>& open) const {
  const auto& triples = graph_.triples;
  const rdf::Triple first{node, rdf::kAnyTerm, rdf::kAnyTerm};
  for (auto at = std::lower_bound(triples.begin(), triples.end(), first);
       at != triples.end() && at->subject == node; ++at) {
    open.push_back(*at);
  }
}

bool StructureMatch::Solve(std::vector<rdf::Triple> open, Choice& choice) {
  const auto chosen = [&](rdf::TermId term) {
    if (!IsBlank(term)) return term;
    const auto found = choice.find(term);
    return found == choice.end() ? rdf::kAnyTerm : found->second;
  };
  // What leaves nothing to choose comes first; then the triple with the fewest answers.
  while (!open.empty()) {
    if (steps_ < open.size() || choice.size() > kMaxNodes) return false;
    steps_ -= open.size();
    std::size_t best = open.size();
    std::size_t fewest = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const rdf::Pattern pattern{chosen(open[i].subject), open[i].predicate,
                                 chosen(open[i].object)};
      const std::size_t count = view_.Estimate(pattern);
      if (count == 0) return false;
      if (best == open.size() || count < fewest) {
        best = i;
        fewest = count;
      }
    }
    const rdf::Triple next = open[best];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(best));
    const rdf::Pattern pattern{chosen(next.subject), next.predicate, chosen(next.object)};
    if (pattern.subject != rdf::kAnyTerm && pattern.object != rdf::kAnyTerm) {
      if (!view_.Contains({pattern.subject, pattern.predicate, pattern.object})) return false;
      continue;
    }
    for (const rdf::Triple& answer : view_.Match(pattern)) {
      if (steps_ == 0) return false;
      Choice tried = choice;
      std::vector<rdf::Triple> rest = open;
      const auto choose = [&](rdf::TermId node, rdf::TermId term) {
        const auto [at, is_new] = tried.emplace(node, term);
        if (is_new) AddStructure(node, rest);
        return at->second == term;
      };
      if (IsBlank(next.subject) && !choose(next.subject, answer.subject)) continue;
      if (IsBlank(next.object) && !choose(next.object, answer.object)) continue;
      if (Solve(std::move(rest), tried)) return true;
    }
    return false;
  }
  return true;
}

bool StructureMatch::Holds(const rdf::Triple& triple, std::size_t max_steps) {
  const std::size_t allowed = std::min(max_steps, budget_);
  steps_ = allowed;
  Choice choice;
  std::vector<rdf::Triple> open{triple};
  if (IsBlank(triple.subject)) AddStructure(triple.subject, open);
  const bool holds = Solve(std::move(open), choice);
  budget_ -= allowed - steps_;
  return holds;
}

}  // namespace lares::authority
