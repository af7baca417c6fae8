// One step of the rules about a triple: what follows from it, and what it follows from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/flat_map.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {

struct TripleHash {
  std::size_t operator()(const rdf::Triple& triple) const {
    const std::uint64_t ends = PairKey(static_cast<std::uint32_t>(triple.subject),
                                       static_cast<std::uint32_t>(triple.object));
    return MixBits(MixBits(ends) + static_cast<std::uint32_t>(triple.predicate));
  }
};
using TripleSet = std::unordered_set<rdf::Triple, TripleHash>;

// The rules of RuleTable() that conclude a triple, over a closed view without equality: those about
// owl:sameAs conclude nothing there and are left out. So are contradictions, and that pairs of a
// transitive property make pairs: whoever asks does that for all pairs at once. One thread.
class OneStep {
 public:
  // A triple takes part as a premise when `Alive` says so.
  using Alive = std::function<bool(const rdf::Triple&)>;
  // What a visit returns: whether to go on.
  using VisitConclusion = std::function<bool(const rdf::Triple&)>;
  using VisitPremises = std::function<bool(std::span<const rdf::Triple>)>;

  // After `max_steps` premises tried it gives up. Throws kTimeout (stop requested).
  OneStep(const rdf::View& view, std::size_t max_steps, std::stop_token stop);

  // Conclusions of the rule instances that have `triple` among their premises; its other premises
  // are alive. One may come more than once, and trivial ones come too.
  void ForwardFrom(const rdf::Triple& triple, const Alive& alive, const VisitConclusion& visit);
  // The premises of each rule instance that concludes `triple`. None for a triple that the closure
  // leaves out as trivial.
  void BackwardTo(const rdf::Triple& triple, const Alive& alive, const VisitPremises& visit);

  // What the closure leaves out unless it is asserted.
  bool IsTrivial(const rdf::Triple& triple) const;
  // Whether pairs x p y, y p z make x p z while `alive`.
  bool IsTransitive(rdf::TermId property, const Alive& alive) const;
  // Work done by the caller that counts as steps.
  void Count(std::size_t steps) { steps_ += steps; }

  // Nothing that was said since can be relied on.
  bool gave_up() const { return steps_ > max_steps_; }

  const rdf::View& view() const { return view_; }
  const Vocabulary& words() const { return words_; }

 private:
  // A rule, or an instance of a rule for one reading of a list.
  struct Clause {
    std::vector<Atom> body, heads;
    std::uint32_t variables = 0;
    std::vector<rdf::Triple> fixed;  // premises without variables: the list and its owner
  };
  struct Use {
    std::uint32_t clause = 0;
    std::uint32_t atom = 0;
  };
  using Index = std::unordered_map<std::uint64_t, std::vector<Use>>;
  struct Search;

  void AddRule(const Rule& rule);
  void AddTransitiveRule(const Rule& rule);
  void AddListInstances(const Rule& rule);
  void AddClause(Clause clause);
  std::uint64_t KeyOf(const Atom& atom) const;
  bool MentionsEquality(const std::vector<Atom>& atoms) const;
  template <typename Visit>
  void ForUses(const Index& index, const rdf::Triple& triple, Visit&& visit) const;
  bool Join(Search& search, std::size_t depth);
  std::size_t Cheapest(const Search& search, std::size_t depth) const;
  bool Step();

  const rdf::View& view_;
  rdf::Dictionary& dictionary_;
  const Vocabulary words_;
  std::size_t max_steps_;
  std::stop_token stop_;
  std::size_t steps_ = 0;
  std::vector<Clause> clauses_;
  std::vector<Rule> transitive_rules_;
  std::vector<rdf::TermId> scratch_;
  Index by_body_, by_head_;
  std::unordered_map<rdf::Triple, std::vector<std::uint32_t>, TripleHash> by_fixed_;
};

}  // namespace lares::owl
