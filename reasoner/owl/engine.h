// The semi-naive join engine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/facts.h"
#include "reasoner/owl/flat_map.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/rule.h"
#include "reasoner/owl/transitive_closure.h"

namespace lares::owl {

// Triples are published one by one. Publishing a triple fires whatever waits for it under one of
// its keys (its predicate, its class, its subject, its object):
//   – a schema pattern: every way to satisfy the schema patterns with it makes an instance of the
//     rule, which is run over the data known so far and then waits for more;
//   – a data pattern of an instance: the remaining data patterns are joined.
// Instances whose schema lies in the layers below are made when a triple with their key first
// arrives, so that a small layer over a large catalogue costs little.
//
// Every triple is by representatives. When two classes of equal terms join, the triples that name
// the one that represents no longer are written anew, and the old ones count no more: whatever an
// instance or a join under way still takes from them is rewritten in its conclusion.
class Engine {
 public:
  Engine(const rdf::View& below, const Options& options, std::stop_token stop);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  // Adds what is not known yet, and runs the rules until nothing new follows. To be called with the
  // cells of lists, then SettleLists(), then with all else; cheapest when schema comes before data.
  // Throws kTooLarge, kTimeout.
  void Run(std::span<const rdf::Triple> asserted);
  // Room for about that many triples.
  void Reserve(std::size_t triples) { facts_.Reserve(triples); }
  // To be told of each literal of the graphs: it may be of a value that is the same as a term
  // below.
  void NoteLiteral(rdf::TermId literal) {
    if (equality_.AddTwin(literal)) has_new_equality_ = true;
  }
  // Lists are whole now: those of the layers below that have grown are read again, and from here on
  // every list to which a cell is added.
  void SettleLists();

  bool IsListCell(const rdf::Triple& triple) const {
    return triple.predicate == words_.first || triple.predicate == words_.rest;
  }
  // Whether `triple` is schema to some rule.
  bool IsSchema(const rdf::Triple& triple) const;

  // Triples in order of arrival; origin 0 marks asserted ones. Those that count no more are among
  // them.
  const Facts& facts() const { return facts_; }
  // Whether `fact` is for a layer to store.
  bool IsForLayer(std::size_t index) const {
    return facts_.OriginOf(index) != kHidden && equality_.IsNormal(facts_.At(index));
  }
  // Of the layers below and what was found since.
  const rdf::Equality& equality() const { return equality_; }
  bool has_new_equality() const { return has_new_equality_; }
  bool has_literal_subjects() const { return has_literal_subjects_; }
  std::vector<rdf::Clash> TakeClashes();
  std::size_t clash_count() const { return clash_keys_.size(); }

 private:
  // Origins of facts that no single rule number says: true without premises and not stored; written
  // anew by representatives; dt-type2.
  static constexpr std::uint32_t kHidden = UINT32_MAX;
  static constexpr std::uint32_t kRewritten = UINT32_MAX - 1;
  static constexpr std::uint32_t kOfDatatype = UINT32_MAX - 2;

  enum class KeyKind : std::uint8_t { kPredicate, kClass, kSubject, kObject };
  static constexpr std::size_t kKeyKinds = 4;
  static constexpr std::size_t kStepsBetweenChecks = 4096;
  // What to do when all patterns of a join are satisfied.
  enum class Goal : std::uint8_t { kConclude, kMakeInstance, kMakeOldInstance, kWait };
  struct Key {
    KeyKind kind{};
    rdf::TermId term{};
  };

  // A pattern of `rule` that waits under some key.
  struct Trigger {
    const Rule* rule = nullptr;
    std::uint32_t atom = 0;
    bool is_schema = false;
    std::uint32_t binding = 0;  // where its rule's variables begin in bindings_
    std::uint32_t cells = 0;    // index into cells_
  };

  struct KeyState {
    bool is_active = false;  // instances with schema below wait here already
    std::vector<Trigger> triggers;
    TransitiveClosure* closure = nullptr;
    const Rule* closure_rule = nullptr;
  };

  // A data pattern by whose key instances are found when the key first arrives.
  struct Waiting {
    const Rule* rule = nullptr;
    std::uint32_t atom = 0;
  };

  // One join under way.
  struct Frame {
    const Rule* rule = nullptr;
    const std::vector<Atom>* atoms = nullptr;
    Goal goal{};
    std::uint32_t atom = 0;   // for kWait
    std::uint32_t cells = 0;  // index into cells_
    std::vector<rdf::TermId> binding;
    std::vector<std::uint32_t> order;  // pattern numbers; those before the depth are satisfied
  };
  class FrameScope;

  // engine.cc
  void PrepareRule(const Rule& rule);
  void PrepareLists();
  void PrepareAxioms();
  void RunToEnd();
  void Process(std::size_t index);
  void FireKey(const Key& key, const rdf::Triple& triple, std::uint32_t origin);
  void Fire(const Trigger& trigger, const rdf::Triple& triple);
  KeyState& StateOf(const Key& key);
  KeyState& Activate(const Key& key);
  // Counts a step. Throws kTimeout, kTooLarge.
  void Step() {
    if (++steps_ % kStepsBetweenChecks == 0) CheckLimits();
  }
  void CheckLimits() const;

  // join.cc
  bool Unify(const Atom& atom, const rdf::Triple& triple, std::vector<rdf::TermId>& binding) const;
  bool IsNumber(rdf::TermId term, int number) const;
  bool UnifySlot(const Slot& slot, rdf::TermId term, std::vector<rdf::TermId>& binding) const;
  void Join(Frame& frame, std::size_t depth);
  std::size_t CountOf(const rdf::Pattern& pattern) const;
  std::size_t BestNext(const Frame& frame, std::size_t depth) const;
  // Calls visit(triple) for each known match that counts. `visit` may add facts.
  template <typename Visit>
  void ForEachKnown(const rdf::Pattern& pattern, Visit&& visit) {
    const auto visit_live = [&](const rdf::Triple& triple) {
      if (!has_new_equality_ || equality_.IsNormal(triple)) visit(triple);
      return true;
    };
    facts_.ForEach(pattern, visit_live);
    below_.ForEachStored(pattern, visit_live);
  }
  void ForEachSame(const rdf::Pattern& pattern,
                   const std::function<void(const rdf::Triple&)>& visit);
  std::vector<rdf::Triple> Match(const rdf::Pattern& pattern);
  std::vector<rdf::TermId> Objects(rdf::TermId subject, rdf::TermId predicate);

  // instances.cc
  void Reach(Frame& frame);
  void MakeInstances(const Frame& frame, bool evaluate);
  void MakeListInstances(const Frame& frame, bool evaluate);
  void MakePairInstances(const Rule& rule, std::vector<rdf::TermId> binding,
                         const std::vector<rdf::TermId>& members, std::uint32_t cells,
                         bool evaluate);
  void Evaluate(const Rule& rule, const std::vector<rdf::TermId>& binding, std::uint32_t cells);
  void MakeInstance(const Rule& rule, const std::vector<rdf::TermId>& binding, std::uint32_t cells,
                    bool always_waits, bool evaluate);
  void ReadListAgain(const rdf::Triple& cell);
  KeyKind KindOf(const Rule& rule, const Atom& atom) const;
  Key KeyOf(const Rule& rule, const Atom& atom, const std::vector<rdf::TermId>& binding) const;
  void Wait(const Trigger& trigger, const Key& key, const std::vector<rdf::TermId>& binding);
  void StartClosure(const Rule& rule, rdf::TermId property, bool below_is_closed);
  void AddEdge(const KeyState& state, const rdf::Triple& triple);

  // conclusions.cc
  void Conclude(const Frame& frame);
  bool IsPairOfList(const Frame& frame) const;
  void ConcludeTriple(const Frame& frame, const rdf::Triple& head);
  bool Knows(const rdf::Triple& triple) const;
  bool IsTrivial(const rdf::Triple& triple) const;
  bool IsLiteral(rdf::TermId term) const {
    return dictionary_.Kind(term) == rdf::TermKind::kLiteral;
  }
  void ConcludeSame(const rdf::Triple& same);
  void Derive(const rdf::Triple& head, std::uint32_t origin);
  std::vector<rdf::Triple> PremisesOf(const Frame& frame) const;
  void AddClash(const std::string& rule, std::vector<rdf::Triple> premises);

  // merging.cc
  void JoinPendingClasses();
  void JoinClasses(rdf::TermId a, rdf::TermId b);
  void RewriteTriplesOf(rdf::TermId term);
  void ConcludeReflexive(rdf::TermId term);

  // datatypes.cc
  bool IsDatatype(rdf::TermId term) const {
    return term != rdf::kAnyTerm && datatypes_.Contains(Number(term));
  }
  bool IsInDatatype(rdf::TermId literal, rdf::TermId datatype) const;
  bool IsOutsideDatatype(rdf::TermId literal, rdf::TermId datatype) const;
  bool IsTypedByDatatypes(const Rule& rule, const std::vector<rdf::TermId>& binding) const;
  void WatchDatatype(rdf::TermId datatype);
  void TypeWatched(rdf::TermId literal);
  void CheckType(const rdf::Triple& triple);
  void CheckValuesOf(rdf::TermId representative);
  static std::uint64_t Number(rdf::TermId term) { return static_cast<std::uint32_t>(term); }

  const rdf::View& below_;
  const Options& options_;
  std::stop_token stop_;
  rdf::Dictionary& dictionary_;
  Vocabulary words_;
  std::vector<Rule> rules_;
  std::deque<Rule> written_rules_;  // for lists
  std::vector<bool> is_live_;       // by rule number: its schema may be satisfied at all
  std::array<std::vector<Waiting>, kKeyKinds> waiting_;
  std::array<bool, kKeyKinds> kind_is_live_{true, true, false, false};

  rdf::Equality equality_;
  bool has_new_equality_ = false;  // over that of the layers below
  std::vector<std::pair<rdf::TermId, rdf::TermId>> pending_classes_;  // to be joined
  FlatSet datatypes_;                                                 // that the rules know
  std::vector<rdf::TermId> watched_datatypes_;  // a rule asks for all their literals
  FlatSet scanned_datatypes_;                   // the layers below were searched for them
  FlatSet typed_literals_;                      // by watched datatypes
  bool is_prepared_ = false;
  bool has_literal_subjects_ = false;

  Facts facts_;
  FlatSet schema_keys_;
  FlatMap state_of_;  // key → index into states_, from 1
  std::deque<KeyState> states_;
  std::vector<rdf::TermId> bindings_;
  std::vector<std::vector<rdf::Triple>> cells_{{}};  // premises from lists; [0] is empty
  // By index into cells_: the members of a list of which any two matter, where pairs are too many.
  std::unordered_map<std::uint32_t, FlatSet> pair_members_;
  std::deque<TransitiveClosure> closures_;
  std::deque<Frame> frames_;
  std::size_t frames_in_use_ = 0;
  bool lists_are_settled_ = false;

  std::vector<rdf::Clash> clashes_;
  FlatSet clash_keys_;
  std::size_t asserted_ = 0;
  std::size_t steps_ = 0;
  const Rule* last_rule_ = nullptr;  // that was joined
};

}  // namespace lares::owl
