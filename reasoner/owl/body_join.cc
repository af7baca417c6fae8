#include "reasoner/owl/body_join.h"

#include <limits>
#include <set>
#include <utility>

#include "base/error.h"

namespace lares::owl {
namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
// A list whose head is known is read after patterns with fewer matches than this.
constexpr std::size_t kCostOfKnownList = 4;
constexpr std::size_t kMayBeComputed = std::size_t{1} << 40;
constexpr unsigned kTicksBetweenStopChecks = 256;

bool IsGround(const rdf::Pattern& pattern) {
  return pattern.subject != rdf::kAnyTerm && pattern.predicate != rdf::kAnyTerm &&
         pattern.object != rdf::kAnyTerm;
}

bool BindSlot(const Slot& slot, rdf::TermId value, std::vector<rdf::TermId>& binding) {
  if (!slot.is_variable) return static_cast<std::uint32_t>(value) == slot.value;
  rdf::TermId& bound = binding[slot.value];
  if (bound == rdf::kAnyTerm) bound = value;
  return bound == value;
}

}  // namespace

bool BodyJoin::Run(Part part, const std::function<bool()>& visit) {
  part_ = part;
  visit_ = &visit;
  open_.clear();
  const bool has_schema = part != Part::kData;
  if (has_schema) {
    for (const Atom& atom : rule_.schema) open_.push_back(&atom);
  }
  if (part != Part::kSchema) {
    for (const Atom& atom : rule_.data) open_.push_back(&atom);
  }
  list_is_open_ =
      has_schema && (rule_.list_use == ListUse::kEach || rule_.list_use == ListUse::kPairs);
  return Continue();
}

void BodyJoin::AppendPremises(std::vector<rdf::Triple>* premises) const {
  const auto append = [&](const std::vector<Atom>& atoms) {
    for (const Atom& atom : atoms) {
      const auto [s, p, o] = atom.In(binding_);
      premises->push_back({s, p, o});
    }
  };
  if (part_ != Part::kData) append(rule_.schema);
  if (cells_ != nullptr) premises->insert(premises->end(), cells_->begin(), cells_->end());
  if (part_ != Part::kSchema) append(rule_.data);
}

void BodyJoin::CheckStop() {
  if (++ticks_ % kTicksBetweenStopChecks == 0 && stop_.stop_requested()) {
    throw Error(Code::kTimeout, "stopped while looking for derivations");
  }
}

bool BodyJoin::Continue() {
  CheckStop();
  std::size_t best = open_.size();
  std::size_t best_cost = kNever;
  for (std::size_t i = 0; i < open_.size() && best_cost > 0; ++i) {
    const std::size_t cost = CostOf(*open_[i]);
    if (cost < best_cost || best == open_.size()) {
      best = i;
      best_cost = cost;
    }
  }
  if (list_is_open_ && (open_.empty() || CostOfList() < best_cost)) return TakeList();
  if (open_.empty()) return (*visit_)();
  return Take(best);
}

std::size_t BodyJoin::CostOf(const Atom& atom) const {
  const rdf::Pattern pattern = atom.In(binding_);
  if (IsGround(pattern)) return 0;  // yes or no: ask at once
  const std::size_t cost = known_.Estimate(pattern);
  if (premises_.computed) {  // only what is ground can be computed: leave it for later
    if (cost == 0) return kNever;
    if (pattern.predicate == words_.type || pattern.predicate == words_.same_as) {
      return kMayBeComputed + cost;
    }
  }
  // All triples, or all of a predicate: leave it for later.
  if (pattern.subject == rdf::kAnyTerm && pattern.object == rdf::kAnyTerm) return 2 * cost;
  return cost;
}

std::size_t BodyJoin::CostOfList() const {
  if (binding_[rule_.list] != rdf::kAnyTerm) return kCostOfKnownList;
  if (rule_.list_use == ListUse::kPairs) return kNever;
  const rdf::TermId member = binding_[rule_.first_member];
  if (member == rdf::kAnyTerm) return kNever;
  return kCostOfKnownList + view_.Estimate({{}, words_.first, member});
}

bool BodyJoin::Bind(const Atom& atom, const rdf::Triple& triple) {
  return BindSlot(atom.subject, triple.subject, binding_) &&
         BindSlot(atom.predicate, triple.predicate, binding_) &&
         BindSlot(atom.object, triple.object, binding_) &&
         (atom.number < 0 || HasValue(view_.dictionary().Get(triple.object), atom.number));
}

bool BodyJoin::Take(std::size_t position) {
  const Atom& atom = *open_[position];
  std::swap(open_[position], open_.back());
  open_.pop_back();
  const rdf::Pattern pattern = atom.In(binding_);
  bool go_on = true;
  if (IsGround(pattern)) {
    const rdf::Triple triple{pattern.subject, pattern.predicate, pattern.object};
    const bool holds = known_.Contains(triple) ? IsUsable(triple)
                                               : premises_.computed && premises_.computed(triple);
    if (holds && Bind(atom, triple)) go_on = Continue();
  } else {
    const auto variables = [&](const Slot& slot) {
      return slot.is_variable ? binding_[slot.value] : rdf::kAnyTerm;
    };
    const rdf::TermId s = variables(atom.subject), p = variables(atom.predicate),
                      o = variables(atom.object);
    const auto restore = [&] {
      if (atom.subject.is_variable) binding_[atom.subject.value] = s;
      if (atom.predicate.is_variable) binding_[atom.predicate.value] = p;
      if (atom.object.is_variable) binding_[atom.object.value] = o;
    };
    go_on = known_.ForEach(pattern, [&](const rdf::Triple& triple) {
      CheckStop();
      const bool more = !IsUsable(triple) || !Bind(atom, triple) || Continue();
      restore();
      return more;
    });
  }
  open_.push_back(&atom);
  std::swap(open_[position], open_.back());
  return go_on;
}

std::vector<rdf::TermId> BodyJoin::HeadsOfListsWith(rdf::TermId member) const {
  std::vector<rdf::TermId> cells = view_.Subjects(words_.first, member);
  std::set<rdf::TermId> seen(cells.begin(), cells.end());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const rdf::TermId before : view_.Subjects(words_.rest, cells[i])) {
      if (seen.insert(before).second) cells.push_back(before);
    }
  }
  return cells;
}

bool BodyJoin::TakeList() {
  rdf::TermId& list = binding_[rule_.list];
  const bool list_was_known = list != rdf::kAnyTerm;
  const std::vector<rdf::TermId> heads = list_was_known ? std::vector<rdf::TermId>{list}
                                         : binding_[rule_.first_member] == rdf::kAnyTerm
                                             ? std::vector<rdf::TermId>{}
                                             : HeadsOfListsWith(binding_[rule_.first_member]);
  const auto objects_of = [this](rdf::TermId s, rdf::TermId p) {
    std::vector<rdf::TermId> objects = view_.Objects(s, p);
    std::erase_if(objects, [&](rdf::TermId o) { return !IsUsable({s, p, o}); });
    return objects;
  };
  list_is_open_ = false;
  bool go_on = true;
  for (std::size_t i = 0; i < heads.size() && go_on; ++i) {
    list = heads[i];
    for (const ListReading& reading : ReadLists(heads[i], words_, objects_of)) {
      cells_ = &reading.cells;
      go_on = go_on && TakeMembers(reading.members);
    }
  }
  cells_ = nullptr;
  list_is_open_ = true;
  if (!list_was_known) list = rdf::kAnyTerm;
  return go_on;
}

bool BodyJoin::TakeMembers(const std::vector<rdf::TermId>& members) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (rule_.list_use == ListUse::kEach) {
      if (!TakeMember(members[i], rdf::kAnyTerm)) return false;
      continue;
    }
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      if (!TakeMember(members[i], members[j])) return false;
    }
  }
  return true;
}

// `second` is kAnyTerm for a rule that takes one member at a time.
bool BodyJoin::TakeMember(rdf::TermId first, rdf::TermId second) {
  const bool pairs = rule_.list_use == ListUse::kPairs;
  const rdf::TermId old_first = binding_[rule_.first_member];
  const rdf::TermId old_second = pairs ? binding_[rule_.second_member] : rdf::kAnyTerm;
  bool go_on = true;
  if (BindSlot({true, rule_.first_member}, first, binding_) &&
      (!pairs || BindSlot({true, rule_.second_member}, second, binding_))) {
    go_on = Continue();
  }
  binding_[rule_.first_member] = old_first;
  if (pairs) binding_[rule_.second_member] = old_second;
  return go_on;
}

}  // namespace lares::owl
