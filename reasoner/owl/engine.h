// The semi-naive join engine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <stop_token>
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
class Engine {
 public:
  Engine(const rdf::View& below, const Options& options, std::stop_token stop);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  // Adds what is not known yet, and runs the rules until nothing new follows. To be called with the
  // cells of lists, then SettleLists(), then with all else; cheapest when schema comes before data.
  // Throws kTooLarge, kTimeout.
  void Run(std::span<const rdf::Triple> asserted);
  // Lists are whole now: those of the layers below that have grown are read again, and from here on
  // every list to which a cell is added.
  void SettleLists();

  bool IsListCell(const rdf::Triple& triple) const {
    return triple.predicate == words_.first || triple.predicate == words_.rest;
  }
  // Whether `triple` is schema to some rule.
  bool IsSchema(const rdf::Triple& triple) const;

  // Triples in order of arrival; origin 0 marks asserted ones.
  const Facts& facts() const { return facts_; }
  std::vector<rdf::Clash> TakeClashes() { return std::move(clashes_); }
  std::size_t clash_count() const { return clash_keys_.size(); }

 private:
  enum class KeyKind : std::uint8_t { kPredicate, kClass, kSubject, kObject };
  static constexpr std::size_t kKeyKinds = 4;
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
  void Process(std::size_t index);
  void FireKey(const Key& key, const rdf::Triple& triple, std::uint32_t origin);
  void Fire(const Trigger& trigger, const rdf::Triple& triple);
  KeyState& StateOf(const Key& key);
  KeyState& Activate(const Key& key);
  void CheckStop();

  // join.cc
  bool Unify(const Atom& atom, const rdf::Triple& triple, std::vector<rdf::TermId>& binding) const;
  void Join(Frame& frame, std::size_t depth);
  std::size_t BestNext(const Frame& frame, std::size_t depth) const;
  std::vector<rdf::Triple> Match(const rdf::Pattern& pattern);
  std::vector<rdf::TermId> Objects(rdf::TermId subject, rdf::TermId predicate);

  // instances.cc
  void Reach(Frame& frame);
  void MakeInstances(const Frame& frame, bool evaluate);
  void MakeListInstances(const Frame& frame, bool evaluate);
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
  bool Knows(const rdf::Triple& triple) const;
  bool IsTrivial(const rdf::Triple& triple) const;
  bool IsStorable(const rdf::Triple& triple) const;
  bool Derive(const Rule& rule, const rdf::Triple& head);
  void Observe(const Rule& rule, const rdf::Triple& head,
               std::span<const rdf::Triple> premises) const;
  std::vector<rdf::Triple> PremisesOf(const Frame& frame) const;
  void AddClash(const Rule& rule, std::vector<rdf::Triple> premises);

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

  Facts facts_;
  FlatSet schema_keys_;
  FlatMap state_of_;  // key → index into states_, from 1
  std::deque<KeyState> states_;
  std::vector<rdf::TermId> bindings_;
  std::vector<std::vector<rdf::Triple>> cells_{{}};  // premises from lists; [0] is empty
  std::deque<TransitiveClosure> closures_;
  std::deque<Frame> frames_;
  std::size_t frames_in_use_ = 0;
  bool lists_are_settled_ = false;

  std::vector<rdf::Clash> clashes_;
  FlatSet clash_keys_;
  std::size_t asserted_ = 0;
  std::uint32_t ticks_ = 0;
};

}  // namespace lares::owl
