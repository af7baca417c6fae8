#include "reasoner/owl/derivations.h"

#include <algorithm>
#include <utility>

#include "reasoner/owl/flat_map.h"
#include "reasoner/owl/lists.h"

namespace lares::owl {
namespace {

// A schema with more solutions than this is joined anew for each question, from what that binds.
constexpr std::size_t kMostKept = 32;

bool Unify(const Slot& slot, rdf::TermId value, std::vector<rdf::TermId>& binding) {
  if (value == rdf::kAnyTerm) return true;
  if (!slot.is_variable) return slot.value == static_cast<std::uint32_t>(value);
  rdf::TermId& bound = binding[slot.value];
  if (bound == rdf::kAnyTerm) bound = value;
  return bound == value;
}

bool Unify(const Atom& head, const rdf::Pattern& goal, std::vector<rdf::TermId>& binding) {
  return Unify(head.subject, goal.subject, binding) &&
         Unify(head.predicate, goal.predicate, binding) && Unify(head.object, goal.object, binding);
}

// What the conclusion of a rule that is written for a list looks like, as far as it tells which
// list: the term that the list belongs to, or kAnyTerm. False: no conclusion of it matches.
bool OwnerOfList(const Rule& rule, const rdf::Pattern& goal, const Vocabulary& words,
                 rdf::TermId* owner) {
  *owner = rdf::kAnyTerm;
  if (rule.list_procedure == "intersection") {
    *owner = goal.object;
    return goal.predicate == words.type;
  }
  if (rule.list_procedure == "chain") *owner = goal.predicate;
  if (rule.list_procedure == "key") return goal.predicate == words.same_as;
  return true;
}

}  // namespace

struct Derivations::Instance {
  const Rule* rule;
  const Atom* head;  // null for a contradiction
  std::vector<rdf::TermId> binding;
  std::vector<rdf::Triple> premises;  // of the schema, when it is solved
  bool schema_is_solved;
};

Derivations::Derivations(rdf::View view, Holds computed)
    : Derivations(std::move(view), RuleTable(), std::move(computed)) {}

Derivations::Derivations(rdf::View view, std::span<const RuleRow> rows, Holds computed)
    : known_(std::move(view), computed ? Literals::kAsSubjects : Literals::kAsObjects),
      view_(known_.view()),
      words_(view_.dictionary()),
      rules_(CompileRules(rows, view_.dictionary())),
      all_{{}, std::move(computed)} {}

Derivations::~Derivations() = default;

void Derivations::AddInstances(const Rule& rule, const Atom& head, rdf::TermId predicate,
                               rdf::TermId object, Instances* instances) {
  std::vector<rdf::TermId> binding(rule.variables);
  if (!Unify(head, {{}, predicate, object}, binding)) return;
  const std::size_t before = instances->size();
  // Not every pair of equal literals is there to be kept.
  bool kept = !rule.schema.empty() && !(rule.is_equality && known_.is_general());
  if (kept) {
    BodyJoin join(known_, words_, all_, rule, binding, {});
    kept = join.Run(BodyJoin::Part::kSchema, [&] {
      instances->push_back({&rule, &head, join.binding(), {}, true});
      join.AppendPremises(&instances->back().premises);
      return instances->size() - before <= kMostKept;
    });
  }
  if (kept) return;
  instances->erase(instances->begin() + static_cast<std::ptrdiff_t>(before), instances->end());
  instances->push_back({&rule, &head, std::move(binding), {}, false});
}

void Derivations::AddListInstances(const Rule& rule, const rdf::Pattern& goal,
                                   Instances* instances) {
  rdf::TermId owner{};
  if (!OwnerOfList(rule, goal, words_, &owner)) return;
  std::vector<rdf::TermId> binding(rule.variables);
  if (!Unify(rule.schema[0].subject, owner, binding)) return;
  const auto objects_of = [this](rdf::TermId s, rdf::TermId p) { return view_.Objects(s, p); };
  BodyJoin join(known_, words_, all_, rule, std::move(binding), {});
  join.Run(BodyJoin::Part::kSchema, [&] {
    const rdf::TermId subject = rule.schema[0].In(join.binding()).subject;
    for (ListReading& reading : ReadLists(join.binding()[rule.list], words_, objects_of)) {
      Rule written = WriteRule(rule, subject, reading.members, words_);
      if (written.data.empty()) continue;
      written_.push_back(std::move(written));
      const Rule& kept = written_.back();
      std::vector<rdf::Triple> premises;
      join.AppendPremises(&premises);
      premises.insert(premises.end(), reading.cells.begin(), reading.cells.end());
      const auto add = [&](const Atom* head) {
        std::vector<rdf::TermId> start(kept.variables);
        if (head != nullptr && !Unify(*head, goal, start)) return;
        instances->push_back({&kept, head, std::move(start), premises, true});
      };
      for (const Atom& head : kept.heads) add(&head);
      if (kept.heads.empty() && goal.predicate == rdf::kAnyTerm) add(nullptr);
    }
    return true;
  });
}

const Derivations::Instances& Derivations::InstancesFor(rdf::TermId predicate,
                                                        rdf::TermId class_or_any) {
  auto& kept = instances_[PairKey(static_cast<std::uint32_t>(predicate),
                                  static_cast<std::uint32_t>(class_or_any))];
  if (kept) return *kept;
  auto instances = std::make_unique<Instances>();
  for (const Rule& rule : rules_) {
    if (rule.list_use == ListUse::kWhole) {
      AddListInstances(rule, {{}, predicate, class_or_any}, instances.get());
    }
    for (const Atom& head : rule.heads) {
      AddInstances(rule, head, predicate, class_or_any, instances.get());
    }
  }
  kept = std::move(instances);
  return *kept;
}

bool Derivations::ForEach(const rdf::Pattern& goal, const Options& options, const Visit& visit) {
  const bool is_type = goal.predicate == words_.type;
  for (const Instance& instance :
       InstancesFor(goal.predicate, is_type ? goal.object : rdf::kAnyTerm)) {
    if (options.wanted && !options.wanted(*instance.rule)) continue;
    if (!VisitOne(instance, goal, options, visit)) return false;
  }
  return true;
}

bool Derivations::ForEachBody(const rdf::Pattern& goal,
                              const std::function<bool(const Body&)>& visit) {
  const bool is_type = goal.predicate == words_.type;
  for (const Instance& instance :
       InstancesFor(goal.predicate, is_type ? goal.object : rdf::kAnyTerm)) {
    std::vector<rdf::TermId> binding = instance.binding;
    if (!Unify(*instance.head, goal, binding)) continue;
    bool go_on = true;
    if (instance.schema_is_solved || instance.rule->schema.empty()) {
      go_on = visit({*instance.rule, binding, instance.premises});
    } else {
      BodyJoin join(known_, words_, all_, *instance.rule, std::move(binding), {});
      go_on = join.Run(BodyJoin::Part::kSchema, [&] {
        std::vector<rdf::Triple> premises;
        join.AppendPremises(&premises);
        return visit({*instance.rule, join.binding(), premises});
      });
    }
    if (!go_on) return false;
  }
  return true;
}

bool Derivations::ForEachClash(const Options& options, const Visit& visit) {
  if (!clashes_) {
    clashes_ = std::make_unique<Instances>();
    for (const Rule& rule : rules_) {
      if (!rule.is_contradiction()) continue;
      clashes_->push_back({&rule, nullptr, std::vector<rdf::TermId>(rule.variables), {}, false});
    }
  }
  for (const Instance& instance : *clashes_) {
    if (options.wanted && !options.wanted(*instance.rule)) continue;
    if (!VisitOne(instance, {}, options, visit)) return false;
  }
  return true;
}

bool Derivations::VisitOne(const Instance& instance, const rdf::Pattern& goal,
                           const Options& options, const Visit& visit) {
  std::vector<rdf::TermId> binding = instance.binding;
  if (instance.head != nullptr && !Unify(*instance.head, goal, binding)) return true;
  const Premises premises{options.usable, all_.computed};
  const auto& usable = options.usable;
  const auto is_usable = [&](const rdf::Triple& triple) {
    return usable(triple) || (all_.computed && !known_.Contains(triple));
  };
  if (usable && !std::all_of(instance.premises.begin(), instance.premises.end(), is_usable)) {
    return true;
  }
  BodyJoin join(known_, words_, premises, *instance.rule, std::move(binding), options.stop);
  const auto part = instance.schema_is_solved ? BodyJoin::Part::kData : BodyJoin::Part::kBoth;
  return join.Run(part, [&] { return Deliver(instance, join, visit); });
}

bool Derivations::Deliver(const Instance& instance, const BodyJoin& join,
                          const Visit& visit) const {
  std::vector<rdf::Triple> premises = instance.premises;
  join.AppendPremises(&premises);
  rdf::Triple conclusion;
  if (instance.head != nullptr) {
    const auto [s, p, o] = instance.head->In(join.binding());
    conclusion = {s, p, o};
    if (std::find(premises.begin(), premises.end(), conclusion) != premises.end()) return true;
  }
  return visit({*instance.rule, conclusion, premises});
}

}  // namespace lares::owl
