// The search behind proofs. Its parts: proof_search.cc (what a goal costs), proof_search_paths.cc
// (transitive properties), proof_search_clashes.cc (contradictions), proof_search_writing.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/derivations.h"
#include "reasoner/owl/on_demand.h"
#include "reasoner/owl/proof_paths.h"
#include "reasoner/owl/prover.h"

namespace lares::owl {

// Goals, what they cost at least, and the cheapest proofs found so far; kept from one question to
// the next.
class ProofSearch {
 public:
  // Premises that hold without being stored are looked at only when asked for: few proofs need
  // them, and they make every search slower.
  ProofSearch(rdf::View view, bool with_computed);

  // As Prover's. Throws kInternal where only the search that computes may find more.
  std::optional<Proof> Why(const rdf::Triple& triple, const ProofOptions& options);
  std::optional<Proof> WhyContradiction(const ProofOptions& options);

 private:
  // Two steps of the same kind in a row can be made one without another cost (x a b, b ⊑ c, c ⊑ d:
  // first join the axioms, or first the individual). So what the second rests on need not be looked
  // for among the conclusions of the first: a goal says which rules it is not to end in.
  enum Avoid : unsigned {
    kPath = 1,
    kReplaceSubject = 2,
    kReplaceObject = 4,
    kReplacePredicate = 8,
    kSubClass = 16,
    kSubProperty = 32,
  };

  struct Tactic {
    unsigned kind = 0;         // goals that avoid any of this do not try the rule
    unsigned last_avoids = 0;  // what the goal of its last premise avoids
  };

  struct Goal {
    rdf::Triple triple;
    unsigned avoids = 0;

    friend bool operator==(const Goal&, const Goal&) = default;
  };

  struct GoalHash {
    std::size_t operator()(const Goal& goal) const;
  };

  struct Known {
    ProofCost cost;
    const Rule* rule = nullptr;  // of the cheapest proof, when it is known and has one
    std::vector<Goal> premises;
    std::string_view computed;  // the rule by which it holds without being stored
  };

  struct Neighbours {
    std::unordered_map<rdf::TermId, std::vector<rdf::TermId>> to, from;
  };
  struct Writer {
    Proof* proof;
    std::unordered_map<Goal, std::size_t, GoalHash> index;  // by triple alone
  };
  static constexpr unsigned kMaxDepth = 400;  // of proofs within proofs; paths do not count

  // proof_search.cc
  static Tactic TacticOf(std::string_view rule);
  static Error NoRule();
  void Start(const ProofOptions& options);
  void Work();
  bool IsTrue(const rdf::Triple& triple) const;
  bool IsRefused(const rdf::Triple& triple) const;
  Goal GoalFor(const rdf::Triple& triple, unsigned avoids) const;
  Known& Recall(const Goal& goal);
  unsigned Lower(const Goal& goal) { return Recall(goal).cost.lower; }
  Derivations::Options OptionsFor(rdf::TermId p, unsigned avoids, Derivations::Holds usable);
  bool Solve(const Goal& goal, unsigned budget);
  void Try(const Goal& goal, Known& known);
  std::vector<Goal> PremisesOf(const Rule& rule, std::span<const rdf::Triple> premises) const;
  bool SolveAll(const std::vector<Goal>& goals, unsigned budget, unsigned* cost);

  // proof_search_paths.cc
  bool IsPath(rdf::TermId p) const { return path_properties_.contains(p); }
  void FindPathProperties();
  std::optional<Goal> TransitivityOf(rdf::TermId p) const;
  ProofPaths& PathsTo(rdf::TermId p, rdf::TermId target);
  void EdgesAt(rdf::TermId p, rdf::TermId node,
               const std::function<void(const ProofPaths::Edge&)>& add);
  void AddEdges(rdf::TermId p, rdf::TermId node, bool backwards,
                const std::function<void(const ProofPaths::Edge&)>& add);
  const Neighbours& AssertedOf(rdf::TermId p);

  // proof_search_clashes.cc
  std::vector<rdf::Clash> Clashes();
  void AddClashesOfValues(const rdf::Clash& clash, std::vector<rdf::Clash>* found);
  std::vector<rdf::TermId> NamesOf(rdf::TermId term) const;

  // proof_search_writing.cc
  Proof OneStep(const rdf::Triple& triple, const Reason& reason) const;
  Proof Write(const Goal& goal);
  Proof WriteClash(const rdf::Clash& clash, unsigned cost);
  static Proof WithoutSpare(Proof proof);
  static std::size_t Add(ProofNode node, Writer& writer);
  std::size_t WriteGoal(const Goal& goal, Writer& writer);
  std::size_t WritePath(const Goal& goal, Writer& writer);
  std::string RuleOfStep(rdf::TermId p, bool is_backwards, bool is_final) const;
  int TableOf(std::string_view rule) const;

  Derivations derivations_;
  const rdf::View& view_;
  bool with_computed_;
  rdf::TermId transitive_property_{}, different_from_{};
  std::set<std::pair<rdf::TermId, rdf::TermId>> refused_;  // by value
  std::set<rdf::TermId> path_properties_;                  // empty before the first question
  std::vector<Tactic> tactics_;                            // by number of the rule
  std::map<std::string, int, std::less<>> table_of_;
  std::unordered_map<Goal, Known, GoalHash> known_;
  std::unordered_map<std::uint64_t, std::unique_ptr<ProofPaths>> paths_;
  std::unordered_map<rdf::TermId, std::unique_ptr<Neighbours>> asserted_;
  ProofOptions options_;
  std::size_t work_ = 0;
  unsigned depth_ = 0;
};

}  // namespace lares::owl
