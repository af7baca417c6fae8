#include <algorithm>
#include <numeric>

#include "reasoner/owl/engine.h"
#include "reasoner/owl/frame_scope.h"
#include "reasoner/owl/lists.h"

namespace lares::owl {
namespace {

constexpr std::size_t kFewMembers = 4;

}  // namespace

void Engine::Reach(Frame& frame) {
  switch (frame.goal) {
    case Goal::kConclude:
      return Conclude(frame);
    case Goal::kMakeInstance:
      return MakeInstances(frame, true);
    case Goal::kMakeOldInstance:
      return MakeInstances(frame, false);
    case Goal::kWait:
      break;
  }
  const Rule& rule = *frame.rule;
  if (!rule.is_transitive) {
    const Key key = KeyOf(rule, rule.data[frame.atom], frame.binding);
    return Wait({&rule, frame.atom, false, 0, 0}, key, frame.binding);
  }
  const auto [s, p, o] = rule.schema[0].In(frame.binding);
  StartClosure(rule, rule.data[0].predicate.In(frame.binding), below_.Contains({s, p, o}));
}

// All schema patterns of `frame` are satisfied. Without `evaluate`, what follows from it for the
// data known so far is known already.
void Engine::MakeInstances(const Frame& frame, bool evaluate) {
  const Rule& rule = *frame.rule;
  is_live_[rule.number] = true;
  for (const Atom& atom : rule.data) {
    kind_is_live_[static_cast<std::size_t>(KindOf(rule, atom))] = true;
  }
  if (rule.is_transitive) {
    StartClosure(rule, rule.data[0].predicate.In(frame.binding), false);
  } else if (rule.list_use != ListUse::kNone) {
    MakeListInstances(frame, evaluate);
  } else {
    MakeInstance(rule, frame.binding, 0, false, evaluate);
  }
}

void Engine::MakeListInstances(const Frame& frame, bool evaluate) {
  const Rule& rule = *frame.rule;
  std::vector<rdf::TermId> binding = frame.binding;
  const auto objects_of = [this](rdf::TermId s, rdf::TermId p) { return Objects(s, p); };
  for (ListReading& reading : ReadLists(binding[rule.list], words_, objects_of)) {
    const std::vector<rdf::TermId>& members = reading.members;
    const auto cells = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(std::move(reading.cells));
    if (rule.list_use == ListUse::kWhole) {
      const auto [s, p, o] = rule.schema[0].In(binding);
      cells_.back().push_back({s, p, o});
      Rule written = WriteRule(rule, s, members, words_);
      if (written.data.empty()) continue;
      written_rules_.push_back(std::move(written));
      const std::vector<rdf::TermId> nothing(written_rules_.back().variables);
      MakeInstance(written_rules_.back(), nothing, cells, true, evaluate);
      continue;
    }
    if (rule.list_use == ListUse::kPairs) {
      MakePairInstances(rule, binding, members, cells, evaluate);
      continue;
    }
    for (const rdf::TermId member : members) {
      binding[rule.first_member] = member;
      MakeInstance(rule, binding, cells, true, evaluate);
    }
  }
}

// Where members are many an instance is made for each, not for each pair: what it finds is looked
// up in the list afterwards.
void Engine::MakePairInstances(const Rule& rule, std::vector<rdf::TermId> binding,
                               const std::vector<rdf::TermId>& members, std::uint32_t cells,
                               bool evaluate) {
  const auto make_pair = [&](rdf::TermId first, rdf::TermId second, std::uint32_t its_cells) {
    binding[rule.first_member] = first;
    binding[rule.second_member] = second;
    MakeInstance(rule, binding, its_cells, true, evaluate);
  };
  const bool has_datatype = std::any_of(members.begin(), members.end(),
                                        [this](rdf::TermId member) { return IsDatatype(member); });
  if (members.size() <= kFewMembers || has_datatype) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = i + 1; j < members.size(); ++j) make_pair(members[i], members[j], cells);
    }
    return;
  }
  FlatSet distinct;
  std::uint32_t cells_of_doubles = 0;
  for (const rdf::TermId member : members) {
    const rdf::TermId normal = equality_.Representative(member);
    if (distinct.Insert(Number(normal))) continue;
    if (cells_of_doubles == 0) {
      cells_of_doubles = static_cast<std::uint32_t>(cells_.size());
      cells_.push_back(std::vector<rdf::Triple>(cells_[cells]));
    }
    make_pair(normal, normal, cells_of_doubles);
  }
  // Two members that become the same make the list one with doubles, and it is read again.
  const bool asks_for_sameness = rdf::TermId{rule.data[0].predicate.value} == words_.same_as &&
                                 !rule.data[0].predicate.is_variable;
  if (asks_for_sameness) return;
  pair_members_.emplace(cells, std::move(distinct));
  binding[rule.second_member] = rdf::kAnyTerm;
  for (const rdf::TermId member : members) {
    binding[rule.first_member] = equality_.Representative(member);
    Wait({&rule, 0, false, 0, cells}, KeyOf(rule, rule.data[0], binding), binding);
    if (evaluate) Evaluate(rule, binding, cells);
  }
}

// Data patterns wait under keys that are active; under others they are found when the key first
// arrives, unless the instance `always_waits`.
void Engine::MakeInstance(const Rule& rule, const std::vector<rdf::TermId>& binding,
                          std::uint32_t cells, bool always_waits, bool evaluate) {
  for (std::uint32_t i = 0; i < rule.data.size(); ++i) {
    const Key key = KeyOf(rule, rule.data[i], binding);
    const bool is_of_datatype = key.kind == KeyKind::kClass && IsDatatype(key.term);
    if (always_waits || is_of_datatype || StateOf(key).is_active)
      Wait({&rule, i, false, 0, cells}, key, binding);
  }
  if (evaluate) Evaluate(rule, binding, cells);
}

void Engine::Evaluate(const Rule& rule, const std::vector<rdf::TermId>& binding,
                      std::uint32_t cells) {
  const FrameScope scope(*this);
  Frame& frame = scope.frame();
  frame.rule = &rule;
  frame.atoms = &rule.data;
  frame.goal = Goal::kConclude;
  frame.cells = cells;
  frame.binding = binding;
  frame.order.resize(rule.data.size());
  std::iota(frame.order.begin(), frame.order.end(), 0U);
  last_rule_ = &rule;
  Join(frame, 0);
}

// The list that `cell` belongs to has grown: whatever refers to it is looked at again.
void Engine::ReadListAgain(const rdf::Triple& cell) {
  std::vector<rdf::TermId> heads = {cell.subject};
  for (std::size_t i = 0; i < heads.size(); ++i) {
    for (const rdf::Triple& before : Match({{}, words_.rest, heads[i]})) {
      if (std::find(heads.begin(), heads.end(), before.subject) == heads.end()) {
        heads.push_back(before.subject);
      }
    }
  }
  for (const Rule& rule : rules_) {
    if (rule.list_use == ListUse::kNone) continue;
    for (std::uint32_t i = 0; i < rule.schema.size(); ++i) {
      const Atom& atom = rule.schema[i];
      if (!atom.object.is_variable || atom.object.value != rule.list) continue;
      for (const rdf::TermId head : heads) {
        const std::vector<rdf::Triple> owners =
            Match({{}, rdf::TermId{atom.predicate.value}, head});
        for (const rdf::Triple& owner : owners) Fire({&rule, i, true, 0, 0}, owner);
      }
    }
  }
}

// The most selective of the places that an instance knows.
Engine::KeyKind Engine::KindOf(const Rule& rule, const Atom& atom) const {
  const auto is_known = [&](const Slot& slot) {
    return !slot.is_variable || rule.is_bound_by_schema[slot.value];
  };
  if (is_known(atom.subject)) return KeyKind::kSubject;
  const bool is_type =
      !atom.predicate.is_variable && rdf::TermId{atom.predicate.value} == words_.type;
  if (is_type && is_known(atom.object)) return KeyKind::kClass;
  return is_known(atom.predicate) ? KeyKind::kPredicate : KeyKind::kObject;
}

Engine::Key Engine::KeyOf(const Rule& rule, const Atom& atom,
                          const std::vector<rdf::TermId>& binding) const {
  const KeyKind kind = KindOf(rule, atom);
  if (kind == KeyKind::kSubject) return {kind, atom.subject.In(binding)};
  if (kind == KeyKind::kPredicate) return {kind, atom.predicate.In(binding)};
  return {kind, atom.object.In(binding)};
}

void Engine::Wait(const Trigger& trigger, const Key& key, const std::vector<rdf::TermId>& binding) {
  Trigger waiting = trigger;
  waiting.binding = static_cast<std::uint32_t>(bindings_.size());
  bindings_.insert(bindings_.end(), binding.begin(), binding.end());
  kind_is_live_[static_cast<std::size_t>(key.kind)] = true;
  StateOf(key).triggers.push_back(waiting);
  if (key.kind == KeyKind::kClass && !trigger.is_schema && IsDatatype(key.term) &&
      IsTypedByDatatypes(*trigger.rule, binding)) {
    WatchDatatype(key.term);
  }
}

void Engine::StartClosure(const Rule& rule, rdf::TermId property, bool below_is_closed) {
  KeyState& state = StateOf({KeyKind::kPredicate, property});
  if (state.closure != nullptr) return;
  state.closure = &closures_.emplace_back(property, below_, below_is_closed);
  state.closure_rule = &rule;
  if (below_is_closed) return;
  for (const rdf::Triple& triple : Match({{}, property, {}})) AddEdge(state, triple);
}

void Engine::AddEdge(const KeyState& state, const rdf::Triple& triple) {
  const rdf::TermId p = triple.predicate;
  const Rule& rule = *state.closure_rule;
  // Literals of one value are one node.
  const rdf::TermId x = dictionary_.SameValue(triple.subject);
  const rdf::TermId y = dictionary_.SameValue(triple.object);
  state.closure->AddEdge(x, y, [&](rdf::TermId u, rdf::TermId v) {
    Derive({u, p, v}, rule.number);
  });
}

}  // namespace lares::owl
