// Ways to satisfy the patterns of one rule over a view, cheapest pattern first.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/known_triples.h"
#include "reasoner/owl/lists.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {

// Which triples a derivation may rest on.
struct Premises {
  // Of the triples that are known; all when empty. Cheap: asked for every match.
  std::function<bool(const rdf::Triple&)> usable;
  // Of the triples that are not, which are true nevertheless (computed, not stored): asked
  // once all three terms are known. None when empty.
  std::function<bool(const rdf::Triple&)> computed;
};

// Backtracking over the open patterns; at each step the one with the fewest matches
// (KnownTriples::Estimate) is taken. One use of it visits all solutions for one rule and one start.
class BodyJoin {
 public:
  // All must outlive it. `binding` holds what is known already, kAnyTerm for the rest.
  BodyJoin(const KnownTriples& known, const Vocabulary& words, const Premises& premises,
           const Rule& rule, std::vector<rdf::TermId> binding, std::stop_token stop)
      : known_(known),
        view_(known.view()),
        words_(words),
        premises_(premises),
        rule_(rule),
        binding_(std::move(binding)),
        stop_(std::move(stop)) {}

  enum class Part { kSchema = 1, kData = 2, kBoth = 3 };
  // Calls visit() for each solution until it returns false; true when all were visited. The list of
  // a rule with members (kEach, kPairs) belongs to its schema. Throws kTimeout (stop requested).
  bool Run(Part part, const std::function<bool()>& visit);

  // Of the solution that is being visited.
  const std::vector<rdf::TermId>& binding() const { return binding_; }
  // Schema patterns, cells of the list, data patterns.
  void AppendPremises(std::vector<rdf::Triple>* premises) const;

 private:
  bool Continue();
  bool Take(std::size_t position);
  bool TakeComputed(const Atom& atom);
  bool Bind(const Atom& atom, const rdf::Triple& triple);
  bool TakeList();
  bool TakeMembers(const std::vector<rdf::TermId>& members);
  bool TakeMember(rdf::TermId first, rdf::TermId second);
  std::vector<rdf::TermId> HeadsOfListsWith(rdf::TermId member) const;
  std::size_t CostOf(const Atom& atom) const;
  std::size_t CostOfList() const;
  bool IsUsable(const rdf::Triple& triple) const {
    return !premises_.usable || premises_.usable(triple);
  }
  void CheckStop();

  const KnownTriples& known_;
  const rdf::View& view_;
  const Vocabulary& words_;
  const Premises& premises_;
  const Rule& rule_;
  std::vector<rdf::TermId> binding_;
  std::stop_token stop_;
  Part part_ = Part::kBoth;
  const std::function<bool()>* visit_ = nullptr;
  std::vector<const Atom*> open_;
  bool list_is_open_ = false;
  const std::vector<rdf::Triple>* cells_ = nullptr;
  unsigned ticks_ = 0;
};

}  // namespace lares::owl
