// One step back: which instances of the rules conclude a triple.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/body_join.h"
#include "reasoner/owl/known_triples.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {

// One instance of a rule whose premises hold; valid during the visit.
struct Step {
  const Rule& rule;  // name and table
  rdf::Triple conclusion;
  // Schema patterns, cells of the list, data patterns, as the row of the table has them.
  std::span<const rdf::Triple> premises;
};

// The instances of the rules over one view, which need not be closed. What the rows of a rule say
// about the schema is worked out once for each predicate (for rdf:type: each class) that is asked
// for, and kept; so one object serves many questions about the same view. One thread at a time.
class Derivations {
 public:
  using Holds = std::function<bool(const rdf::Triple&)>;
  // Of RuleTable(), or of other rows.
  // `computed` says which triples are true although the view does not hold them; none when empty.
  // With it, literals may be subjects.
  explicit Derivations(rdf::View view, Holds computed = {});
  Derivations(rdf::View view, std::span<const RuleRow> rows, Holds computed);
  ~Derivations();
  Derivations(const Derivations&) = delete;
  Derivations& operator=(const Derivations&) = delete;

  using Visit = std::function<bool(const Step&)>;
  struct Options {
    // Which triples of the view a derivation may rest on; all when empty. Cheap: asked for every
    // match.
    Holds usable;
    // Which rules to try; all when empty.
    std::function<bool(const Rule&)> wanted;
    std::stop_token stop;
  };

  // Calls `visit` for each instance whose conclusion matches `goal` until it returns false; true
  // when all were visited. `goal` needs a predicate; subject and object may be open. Lazy: what is
  // not visited is not looked for. An instance may come more than once (through two rows of a
  // rule), and one that concludes a premise of its own is left out. Throws kTimeout.
  bool ForEach(const rdf::Pattern& goal, const Options& options, const Visit& visit);
  // The same for contradictions; the conclusion of these steps is empty.
  bool ForEachClash(const Options& options, const Visit& visit);

  // A rule that would conclude a goal, with its schema satisfied: what is left are its data
  // patterns under a binding.
  struct Body {
    const Rule& rule;
    const std::vector<rdf::TermId>& binding;
    std::span<const rdf::Triple> premises;  // of the schema
  };
  // Calls `visit` for each until it returns false; true when all were visited. Rules without a
  // schema come once.
  bool ForEachBody(const rdf::Pattern& goal, const std::function<bool(const Body&)>& visit);

  const KnownTriples& known() const { return known_; }
  const rdf::View& view() const { return view_; }
  const Vocabulary& words() const { return words_; }
  const std::vector<Rule>& rules() const { return rules_; }

 private:
  struct Instance;  // a rule and one head of it, with as much as is known beforehand
  using Instances = std::vector<Instance>;

  const Instances& InstancesFor(rdf::TermId predicate, rdf::TermId class_or_any);
  void AddInstances(const Rule& rule, const Atom& head, rdf::TermId predicate, rdf::TermId object,
                    Instances* instances);
  void AddListInstances(const Rule& rule, const rdf::Pattern& goal, Instances* instances);
  bool VisitOne(const Instance& instance, const rdf::Pattern& goal, const Options& options,
                const Visit& visit);
  bool Deliver(const Instance& instance, const BodyJoin& join, const Visit& visit) const;

  KnownTriples known_;
  const rdf::View& view_;  // of known_
  Vocabulary words_;
  std::vector<Rule> rules_;
  Premises all_;
  std::deque<Rule> written_;  // for lists of some length
  std::unordered_map<std::uint64_t, std::unique_ptr<Instances>> instances_;
  std::unique_ptr<Instances> clashes_;
};

}  // namespace lares::owl
