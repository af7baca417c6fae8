#include "reasoner/owl/one_step.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "reasoner/owl/lists.h"

namespace lares::owl {
namespace {

constexpr std::size_t kStepsBetweenStopChecks = 4096;

bool UnifySlot(const Slot& slot, rdf::TermId term, std::vector<rdf::TermId>& binding) {
  if (!slot.is_variable) return rdf::TermId{slot.value} == term;
  rdf::TermId& value = binding[slot.value];
  if (value == rdf::kAnyTerm) value = term;
  return value == term;
}

bool UnifyAtom(const Atom& atom, const rdf::Triple& triple, std::vector<rdf::TermId>& binding) {
  return UnifySlot(atom.subject, triple.subject, binding) &&
         UnifySlot(atom.predicate, triple.predicate, binding) &&
         UnifySlot(atom.object, triple.object, binding);
}

void Unbind(const Slot& slot, rdf::TermId before, std::vector<rdf::TermId>& binding) {
  if (slot.is_variable && before == rdf::kAnyTerm) binding[slot.value] = rdf::kAnyTerm;
}

rdf::Triple Ground(const Atom& atom, const std::vector<rdf::TermId>& binding) {
  const auto [s, p, o] = atom.In(binding);
  return {s, p, o};
}

Slot Bound(const Slot& slot, const std::vector<rdf::TermId>& binding) {
  const rdf::TermId value = slot.In(binding);
  return value == rdf::kAnyTerm ? slot : Slot{false, static_cast<std::uint32_t>(value)};
}

Atom Bound(const Atom& atom, const std::vector<rdf::TermId>& binding) {
  return {Bound(atom.subject, binding), Bound(atom.predicate, binding), Bound(atom.object, binding),
          atom.number};
}

}  // namespace

// One join under way.
struct OneStep::Search {
  const Clause& clause;
  const Alive& alive;
  const std::function<bool(const Search&)>& reach;
  std::vector<rdf::TermId> binding;
  std::vector<std::uint32_t> order;  // pattern numbers; those before the depth are satisfied
};

OneStep::OneStep(const rdf::View& view, std::size_t max_steps, std::stop_token stop)
    : view_(view),
      dictionary_(view.dictionary()),
      words_(dictionary_),
      max_steps_(max_steps),
      stop_(std::move(stop)) {
  for (const Rule& rule : CompileRules(RuleTable(), dictionary_)) {
    if (rule.is_contradiction()) continue;
    if (MentionsEquality(rule.schema) || MentionsEquality(rule.data) ||
        MentionsEquality(rule.heads)) {
      continue;
    }
    if (rule.is_transitive) {
      AddTransitiveRule(rule);
    } else {
      rule.list_use == ListUse::kNone ? AddRule(rule) : AddListInstances(rule);
    }
  }
}

void OneStep::AddRule(const Rule& rule) {
  Clause clause;
  clause.body = rule.schema;
  clause.body.insert(clause.body.end(), rule.data.begin(), rule.data.end());
  clause.heads = rule.heads;
  clause.variables = rule.variables;
  const std::vector<rdf::TermId> nothing(rule.variables);
  for (const Atom& atom : clause.body) {
    if (view_.Estimate(atom.In(nothing)) == 0) return;  // it can never be satisfied
  }
  AddClause(std::move(clause));
}

// Only what follows from its schema is asked of the clause.
void OneStep::AddTransitiveRule(const Rule& rule) {
  transitive_rules_.push_back(rule);
  if (rule.schema.empty()) return;
  Clause clause{rule.schema, rule.heads, rule.variables, {}};
  clause.body.insert(clause.body.end(), rule.data.begin(), rule.data.end());
  const auto number = static_cast<std::uint32_t>(clauses_.size());
  for (std::uint32_t i = 0; i < rule.schema.size(); ++i) {
    by_body_[KeyOf(clause.body[i])].push_back({number, i});
  }
  clauses_.push_back(std::move(clause));
}

bool OneStep::IsTransitive(rdf::TermId property, const Alive& alive) const {
  return std::any_of(transitive_rules_.begin(), transitive_rules_.end(), [&](const Rule& rule) {
    std::vector<rdf::TermId> binding(rule.variables);
    if (!UnifySlot(rule.data[0].predicate, property, binding)) return false;
    return std::all_of(rule.schema.begin(), rule.schema.end(), [&](const Atom& atom) {
      const rdf::Triple premise = Ground(atom, binding);
      return view_.Contains(premise) && (!alive || alive(premise));
    });
  });
}

// Each way to satisfy the schema patterns, with each reading of the list, is a clause.
void OneStep::AddListInstances(const Rule& rule) {
  const Clause schema{rule.schema, {}, rule.variables, {}};
  const Alive all;
  const auto objects_of = [this](rdf::TermId s, rdf::TermId p) { return view_.Objects(s, p); };
  const std::function<bool(const Search&)> add = [&](const Search& found) {
    std::vector<rdf::Triple> premises;
    for (const Atom& atom : rule.schema) premises.push_back(Ground(atom, found.binding));
    for (const ListReading& reading : ReadLists(found.binding[rule.list], words_, objects_of)) {
      Clause clause;
      clause.fixed = premises;
      clause.fixed.insert(clause.fixed.end(), reading.cells.begin(), reading.cells.end());
      if (rule.list_use == ListUse::kWhole) {
        Rule written = WriteRule(rule, premises.front().subject, reading.members, words_);
        if (written.data.empty() || MentionsEquality(written.heads)) continue;
        clause.body = std::move(written.data);
        clause.heads = std::move(written.heads);
        clause.variables = written.variables;
        AddClause(std::move(clause));
        continue;
      }
      std::vector<rdf::TermId> binding = found.binding;
      for (const rdf::TermId member : reading.members) {
        binding[rule.first_member] = member;
        Clause each{{}, {}, rule.variables, clause.fixed};
        for (const Atom& atom : rule.data) each.body.push_back(Bound(atom, binding));
        for (const Atom& atom : rule.heads) each.heads.push_back(Bound(atom, binding));
        AddClause(std::move(each));
      }
    }
    return true;
  };
  Search search{schema, all, add, std::vector<rdf::TermId>(rule.variables), {}};
  search.order.resize(rule.schema.size());
  std::iota(search.order.begin(), search.order.end(), 0U);
  Join(search, 0);
}

void OneStep::AddClause(Clause clause) {
  const auto number = static_cast<std::uint32_t>(clauses_.size());
  for (std::uint32_t i = 0; i < clause.body.size(); ++i) {
    by_body_[KeyOf(clause.body[i])].push_back({number, i});
  }
  for (std::uint32_t i = 0; i < clause.heads.size(); ++i) {
    by_head_[KeyOf(clause.heads[i])].push_back({number, i});
  }
  for (const rdf::Triple& triple : clause.fixed) by_fixed_[triple].push_back(number);
  clauses_.push_back(std::move(clause));
}

// What a pattern is found by: its predicate, with its object where it says both.
std::uint64_t OneStep::KeyOf(const Atom& atom) const {
  if (atom.predicate.is_variable) return 0;
  return PairKey(atom.predicate.value, atom.object.is_variable ? 0 : atom.object.value);
}

template <typename Visit>
void OneStep::ForUses(const Index& index, const rdf::Triple& triple, Visit&& visit) const {
  const auto p = static_cast<std::uint32_t>(triple.predicate);
  for (const std::uint64_t key :
       {std::uint64_t{0}, PairKey(p, 0), PairKey(p, static_cast<std::uint32_t>(triple.object))}) {
    const auto uses = index.find(key);
    if (uses == index.end()) continue;
    for (const Use& use : uses->second) {
      if (!visit(use)) return;
    }
  }
}

bool OneStep::MentionsEquality(const std::vector<Atom>& atoms) const {
  return std::any_of(atoms.begin(), atoms.end(), [&](const Atom& atom) {
    return !atom.predicate.is_variable && rdf::TermId{atom.predicate.value} == words_.same_as;
  });
}

bool OneStep::IsTrivial(const rdf::Triple& triple) const {
  const auto [s, p, o] = triple;
  if (p == words_.type) return o == words_.thing;
  if (p == words_.sub_class_of) return s == o || o == words_.thing || s == words_.nothing;
  return s == o && (p == words_.same_as || p == words_.equivalent_class ||
                    p == words_.sub_property_of || p == words_.equivalent_property);
}

void OneStep::ForwardFrom(const rdf::Triple& triple, const Alive& alive,
                          const VisitConclusion& visit) {
  const std::function<bool(const Search&)> reach = [&](const Search& search) {
    for (const Atom& head : search.clause.heads) {
      if (!visit(Ground(head, search.binding))) return false;
    }
    return true;
  };
  const auto run = [&](const Clause& clause, std::size_t satisfied) {
    scratch_.assign(clause.variables, rdf::kAnyTerm);
    const bool is_fixed = satisfied == clause.body.size();
    if (!is_fixed && !UnifyAtom(clause.body[satisfied], triple, scratch_)) return true;
    Search search{clause, alive, reach, scratch_, {}};
    search.order.resize(clause.body.size());
    std::iota(search.order.begin(), search.order.end(), 0U);
    if (is_fixed) return Join(search, 0);
    std::swap(search.order[0], search.order[satisfied]);
    return Join(search, 1);
  };
  ForUses(by_body_, triple, [&](const Use& use) { return run(clauses_[use.clause], use.atom); });
  const auto fixed = by_fixed_.find(triple);
  if (fixed == by_fixed_.end()) return;
  for (const std::uint32_t number : fixed->second) {
    if (!run(clauses_[number], clauses_[number].body.size())) return;
  }
}

void OneStep::BackwardTo(const rdf::Triple& triple, const Alive& alive,
                         const VisitPremises& visit) {
  if (IsTrivial(triple)) return;
  std::vector<rdf::Triple> premises;
  const std::function<bool(const Search&)> reach = [&](const Search& search) {
    premises = search.clause.fixed;
    for (const Atom& atom : search.clause.body) premises.push_back(Ground(atom, search.binding));
    return visit(premises);
  };
  ForUses(by_head_, triple, [&](const Use& use) {
    const Clause& clause = clauses_[use.clause];
    const auto is_alive = [&](const rdf::Triple& premise) { return !alive || alive(premise); };
    if (!std::all_of(clause.fixed.begin(), clause.fixed.end(), is_alive)) return true;
    scratch_.assign(clause.variables, rdf::kAnyTerm);
    if (!UnifyAtom(clause.heads[use.atom], triple, scratch_)) return true;
    Search search{clause, alive, reach, scratch_, {}};
    search.order.resize(clause.body.size());
    std::iota(search.order.begin(), search.order.end(), 0U);
    return Join(search, 0);
  });
}

std::size_t OneStep::Cheapest(const Search& search, std::size_t depth) const {
  std::size_t best = depth;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = depth; i < search.order.size() && fewest > 1; ++i) {
    const std::size_t count =
        view_.Estimate(search.clause.body[search.order[i]].In(search.binding));
    if (count >= fewest) continue;
    best = i;
    fewest = count;
  }
  return best;
}

bool OneStep::Join(Search& search, std::size_t depth) {
  if (!Step()) return false;
  if (depth == search.order.size()) return search.reach(search);
  if (depth + 1 < search.order.size()) {
    std::swap(search.order[depth], search.order[Cheapest(search, depth)]);
  }
  const Atom& atom = search.clause.body[search.order[depth]];
  const rdf::Pattern pattern = atom.In(search.binding);
  return view_.ForEach(pattern, [&](const rdf::Triple& triple) {
    if (!Step()) return false;
    bool goes_on = true;
    if ((!search.alive || search.alive(triple)) && UnifyAtom(atom, triple, search.binding) &&
        (atom.number < 0 || HasValue(dictionary_.Get(triple.object), atom.number))) {
      goes_on = Join(search, depth + 1);
    }
    Unbind(atom.subject, pattern.subject, search.binding);
    Unbind(atom.predicate, pattern.predicate, search.binding);
    Unbind(atom.object, pattern.object, search.binding);
    return goes_on;
  });
}

bool OneStep::Step() {
  if (++steps_ % kStepsBetweenStopChecks == 0 && stop_.stop_requested()) {
    throw Error(Code::kTimeout, "stopped while taking knowledge back");
  }
  return !gave_up();
}

}  // namespace lares::owl
