#include "reasoner/owl/engine.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "base/error.h"
#include "ontology/rdf/literal_value.h"
#include "reasoner/owl/frame_scope.h"

namespace lares::owl {
namespace {

constexpr std::size_t kStepsForATriple = 1000;

std::uint64_t Packed(std::size_t kind, rdf::TermId term) {
  return std::uint64_t{kind + 1} << 32 | static_cast<std::uint32_t>(term);
}

}  // namespace

Engine::Engine(const rdf::View& below, const Options& options, std::stop_token stop)
    : below_(below),
      options_(options),
      stop_(std::move(stop)),
      dictionary_(below.dictionary()),
      words_(dictionary_),
      rules_(CompileRules(RuleTable(), dictionary_)),
      is_live_(rules_.size() + 1, false),
      equality_(below.equality() != nullptr ? *below.equality()
                                            : rdf::Equality(dictionary_, words_.same_as)) {
  for (const std::string_view datatype : rdf::SupportedDatatypes()) {
    datatypes_.Insert(Number(dictionary_.InternIri(datatype)));
  }
  for (const Rule& rule : rules_) {
    if (!rule.is_equality) PrepareRule(rule);
  }
  PrepareLists();
  PrepareAxioms();
  is_prepared_ = true;
}

void Engine::PrepareRule(const Rule& rule) {
  const std::vector<rdf::TermId> nothing(rule.variables);
  const auto note_key = [&](const Key& key) {
    schema_keys_.Insert(Packed(static_cast<std::size_t>(key.kind), key.term));
  };
  if (rule.schema.empty()) {
    for (const Atom& atom : rule.data) note_key(KeyOf(rule, atom, nothing));
    if (!rule.is_transitive) return MakeInstance(rule, nothing, 0, true, false);
    return StartClosure(rule, rdf::TermId{rule.data[0].predicate.value}, true);
  }
  bool is_live = true;
  for (std::uint32_t i = 0; i < rule.schema.size(); ++i) {
    const Atom& atom = rule.schema[i];
    const bool is_class = rdf::TermId{atom.predicate.value} == words_.type;
    const Slot& slot = is_class ? atom.object : atom.predicate;
    const Key key{is_class ? KeyKind::kClass : KeyKind::kPredicate, rdf::TermId{slot.value}};
    note_key(key);
    Wait({&rule, i, true, 0, 0}, key, nothing);
    is_live = is_live && below_.Estimate(atom.In(nothing)) > 0;
  }
  is_live_[rule.number] = is_live;
  if (rule.list_use != ListUse::kNone) return;
  for (std::uint32_t i = 0; i < rule.data.size(); ++i) {
    const auto kind = static_cast<std::size_t>(KindOf(rule, rule.data[i]));
    kind_is_live_[kind] = kind_is_live_[kind] || is_live;
    if (i == 0 || !rule.is_transitive) waiting_[kind].push_back({&rule, i});
  }
}

// Lists below are few: their instances wait from the start.
void Engine::PrepareLists() {
  for (const Rule& rule : rules_) {
    if (rule.list_use == ListUse::kNone || !is_live_[rule.number]) continue;
    const FrameScope scope(*this);
    Frame& frame = scope.frame();
    frame.rule = &rule;
    frame.atoms = &rule.schema;
    frame.goal = Goal::kMakeOldInstance;
    frame.cells = 0;
    frame.binding.assign(rule.variables, rdf::kAnyTerm);
    frame.order.resize(rule.schema.size());
    std::iota(frame.order.begin(), frame.order.end(), 0U);
    Join(frame, 0);
  }
}

// What is true without premises, where rules may look for it.
void Engine::PrepareAxioms() {
  for (const AxiomRow& row : AxiomTable()) {
    const auto intern = [&](const char* name) { return dictionary_.InternIri(Expand(name)); };
    const rdf::Triple axiom{intern(row.subject), words_.type, intern(row.object)};
    if (!below_.ContainsStored(axiom)) facts_.Add(axiom, kHidden);
  }
  // Rules below that ask for literals by their datatype alone.
  for (const std::string_view datatype : rdf::SupportedDatatypes()) {
    const rdf::TermId term = dictionary_.InternIri(datatype);
    if (below_.Estimate({term, {}, {}}) > 0) Activate({KeyKind::kClass, term});
  }
}

void Engine::Run(std::span<const rdf::Triple> asserted) {
  for (const rdf::Triple& triple : asserted) {
    const rdf::Triple normal = equality_.Normal(triple);
    if (normal.predicate == words_.same_as && normal.subject != normal.object) {
      pending_classes_.emplace_back(normal.subject, normal.object);
    } else if (!below_.ContainsStored(normal) && facts_.Add(normal, 0)) {
      ++asserted_;
    }
  }
  RunToEnd();
}

void Engine::RunToEnd() {
  while (true) {
    if (!pending_classes_.empty()) {
      JoinPendingClasses();
    } else if (facts_.published() < facts_.size()) {
      Process(facts_.Publish());
    } else {
      return;
    }
  }
}

void Engine::SettleLists() {
  lists_are_settled_ = true;
  const std::size_t cells = facts_.size();
  for (std::size_t i = 0; i < cells; ++i) {
    const rdf::Triple cell = facts_.At(i);
    if (!IsListCell(cell)) continue;
    const bool is_known_below =
        below_.Estimate({cell.subject, {}, {}}) > 0 || below_.Estimate({{}, {}, cell.subject}) > 0;
    if (is_known_below) ReadListAgain(cell);
  }
}

bool Engine::IsSchema(const rdf::Triple& triple) const {
  const bool is_type = triple.predicate == words_.type;
  const KeyKind kind = is_type ? KeyKind::kClass : KeyKind::kPredicate;
  return schema_keys_.Contains(
      Packed(static_cast<std::size_t>(kind), is_type ? triple.object : triple.predicate));
}

void Engine::Process(std::size_t index) {
  Step();
  const rdf::Triple triple = facts_.At(index);
  const std::uint32_t origin = facts_.OriginOf(index);
  if (has_new_equality_ && !equality_.IsNormal(triple)) return Derive(triple, kRewritten);
  FireKey({KeyKind::kPredicate, triple.predicate}, triple, origin);
  if (triple.predicate == words_.type) FireKey({KeyKind::kClass, triple.object}, triple, origin);
  const auto is_live = [this](KeyKind kind) {
    return kind_is_live_[static_cast<std::size_t>(kind)];
  };
  if (is_live(KeyKind::kSubject)) FireKey({KeyKind::kSubject, triple.subject}, triple, origin);
  if (is_live(KeyKind::kObject)) FireKey({KeyKind::kObject, triple.object}, triple, origin);
  const KeyState& state = StateOf({KeyKind::kPredicate, triple.predicate});
  if (state.closure != nullptr) AddEdge(state, triple);
  if (triple.predicate == words_.type) CheckType(triple);
  if (!watched_datatypes_.empty() && IsLiteral(triple.object)) TypeWatched(triple.object);
  if (lists_are_settled_ && IsListCell(triple)) ReadListAgain(triple);
}

void Engine::FireKey(const Key& key, const rdf::Triple& triple, std::uint32_t origin) {
  const KeyState& state = Activate(key);
  const std::size_t count = state.triggers.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Trigger trigger = state.triggers[i];
    if (trigger.rule->is_self_closed && !trigger.is_schema && trigger.rule->number == origin) {
      continue;
    }
    Fire(trigger, triple);
  }
}

void Engine::Fire(const Trigger& trigger, const rdf::Triple& triple) {
  const Rule& rule = *trigger.rule;
  last_rule_ = &rule;
  const FrameScope scope(*this);
  Frame& frame = scope.frame();
  frame.rule = &rule;
  frame.atoms = trigger.is_schema ? &rule.schema : &rule.data;
  frame.goal = trigger.is_schema ? Goal::kMakeInstance : Goal::kConclude;
  frame.cells = trigger.cells;
  const auto begin = bindings_.begin() + static_cast<std::ptrdiff_t>(trigger.binding);
  frame.binding.assign(begin, begin + static_cast<std::ptrdiff_t>(rule.variables));
  if (!Unify((*frame.atoms)[trigger.atom], triple, frame.binding)) return;
  if (frame.atoms->size() > 1 && frame.goal == Goal::kConclude && rule.heads.size() == 1) {
    const auto [s, p, o] = rule.heads[0].In(frame.binding);
    const bool is_whole = s != rdf::kAnyTerm && p != rdf::kAnyTerm && o != rdf::kAnyTerm;
    if (is_whole && Knows({s, p, o})) return;
  }
  frame.order.resize(frame.atoms->size());
  std::iota(frame.order.begin(), frame.order.end(), 0U);
  std::swap(frame.order[0], frame.order[trigger.atom]);
  Join(frame, 1);
}

Engine::KeyState& Engine::StateOf(const Key& key) {
  std::uint32_t& number = state_of_[Packed(static_cast<std::size_t>(key.kind), key.term)];
  if (number == 0) {
    states_.emplace_back();
    number = static_cast<std::uint32_t>(states_.size());
  }
  return states_[number - 1];
}

// The state of `key`, with every instance in it whose schema is known.
Engine::KeyState& Engine::Activate(const Key& key) {
  KeyState& state = StateOf(key);
  if (state.is_active) return state;
  state.is_active = true;
  for (const Waiting& waiting : waiting_[static_cast<std::size_t>(key.kind)]) {
    const Rule& rule = *waiting.rule;
    if (!is_live_[rule.number]) continue;
    const FrameScope scope(*this);
    Frame& frame = scope.frame();
    frame.rule = &rule;
    frame.atoms = &rule.schema;
    frame.goal = Goal::kWait;
    frame.atom = waiting.atom;
    frame.cells = 0;
    frame.binding.assign(rule.variables, rdf::kAnyTerm);
    const Atom& atom = rule.data[waiting.atom];
    const Slot& slot = key.kind == KeyKind::kSubject     ? atom.subject
                       : key.kind == KeyKind::kPredicate ? atom.predicate
                                                         : atom.object;
    if (slot.is_variable) frame.binding[slot.value] = key.term;
    frame.order.resize(rule.schema.size());
    std::iota(frame.order.begin(), frame.order.end(), 0U);
    Join(frame, 0);
  }
  return state;
}

void Engine::CheckLimits() const {
  if (stop_.stop_requested()) throw Error(Code::kTimeout, "stopped while closing the knowledge");
  if (steps_ <= options_.max_steps + kStepsForATriple * asserted_) return;
  std::string last;
  if (last_rule_ != nullptr) last = ", the last of them by " + last_rule_->name;
  throw Error(Code::kTooLarge,
              "what follows cannot be found in " + std::to_string(steps_) + " steps" + last)
      .WithHint(
          "property chains and keys over things that are all linked with each other, or deep "
          "definitions, have too many ways to follow");
}

}  // namespace lares::owl
