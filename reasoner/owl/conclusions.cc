#include <algorithm>
#include <string>

#include "base/error.h"
#include "ontology/rdf/literal_value.h"
#include "reasoner/owl/engine.h"

namespace lares::owl {
namespace {

std::uint64_t HashOf(const std::string& rule, const std::vector<rdf::Triple>& premises) {
  std::uint64_t hash = std::hash<std::string>()(rule);
  for (const rdf::Triple& triple : premises) {
    for (const rdf::TermId term : {triple.subject, triple.predicate, triple.object}) {
      hash = MixBits(hash * 31 + static_cast<std::uint32_t>(term));
    }
  }
  return hash == 0 ? 1 : hash;
}

rdf::Triple Ground(const Atom& atom, const std::vector<rdf::TermId>& binding) {
  const auto [s, p, o] = atom.In(binding);
  return {s, p, o};
}

}  // namespace

void Engine::Conclude(const Frame& frame) {
  const Rule& rule = *frame.rule;
  if (rule.is_contradiction()) {
    if (IsPairOfList(frame)) AddClash(rule.name, PremisesOf(frame));
    return;
  }
  for (const Atom& atom : rule.heads) ConcludeTriple(frame, Ground(atom, frame.binding));
}

// Where an instance stands for all pairs with one member, the other was not looked up in the list.
bool Engine::IsPairOfList(const Frame& frame) const {
  const auto found = pair_members_.find(frame.cells);
  if (found == pair_members_.end()) return true;
  const rdf::TermId first = frame.binding[frame.rule->first_member];
  const rdf::TermId second = frame.binding[frame.rule->second_member];
  return first != second && found->second.Contains(Number(second));
}

// A literal is of the datatypes that hold its value, and of no other (dt-type2, dt-not-type).
void Engine::ConcludeTriple(const Frame& frame, const rdf::Triple& head) {
  if (head.predicate == words_.type && IsLiteral(head.subject) && IsDatatype(head.object)) {
    if (IsInDatatype(head.subject, head.object)) return;
    if (IsOutsideDatatype(head.subject, head.object)) {
      std::vector<rdf::Triple> premises = PremisesOf(frame);
      premises.push_back(head);
      AddClash("dt-not-type", std::move(premises));
    }
  }
  Derive(head, frame.rule->number);
}

bool Engine::Knows(const rdf::Triple& triple) const {
  return facts_.Has(triple) || below_.ContainsStored(triple);
}

bool Engine::IsTrivial(const rdf::Triple& triple) const {
  const auto [s, p, o] = triple;
  if (p == words_.type) return o == words_.thing;
  if (p == words_.same_as) return s == o;
  if (p == words_.sub_class_of && (o == words_.thing || s == words_.nothing)) return true;
  // Of several names of one thing it says that they are the same class or property.
  const bool is_alone = s == o && equality_.Members(s).empty();
  return is_alone && (p == words_.sub_class_of || p == words_.equivalent_class ||
                      p == words_.sub_property_of || p == words_.equivalent_property);
}

// Literals of different values are never made one: that they would be is the contradiction. Nor is
// one of known value made one with a literal whose value is not known (of another datatype, or
// ill-typed): it would stand between two values, and which of them it joins would be a matter of
// order. So all literals of one class without other terms are of one value, or of none known.
void Engine::ConcludeSame(const rdf::Triple& same) {
  if (IsLiteral(same.subject) && IsLiteral(same.object)) {
    const auto first = rdf::ValueOf(dictionary_.Get(same.subject));
    const auto second = rdf::ValueOf(dictionary_.Get(same.object));
    if (first && second && *first != *second) AddClash("eq-diff1", {same});
    if (first || second) return;
  }
  pending_classes_.emplace_back(same.subject, same.object);
}

// `head` becomes known, by representatives.
void Engine::Derive(const rdf::Triple& head, std::uint32_t origin) {
  Step();
  const rdf::Triple normal = equality_.empty() ? head : equality_.Normal(head);
  if (normal.predicate == words_.same_as && normal.subject != normal.object) {
    return ConcludeSame(normal);
  }
  // What is stored though it is trivial was asserted.
  const bool is_trivial = origin != kRewritten && IsTrivial(normal);
  if (is_trivial || Knows(normal) || IsLiteral(normal.predicate)) return;
  if (facts_.size() - asserted_ >= options_.max_inferred) {
    throw Error(Code::kTooLarge,
                "more than " + std::to_string(options_.max_inferred) + " triples follow")
        .WithHint("a transitive or equality axiom may join more than it was meant to");
  }
  has_literal_subjects_ = has_literal_subjects_ || IsLiteral(normal.subject);
  facts_.Add(normal, origin);
}

std::vector<rdf::Triple> Engine::PremisesOf(const Frame& frame) const {
  std::vector<rdf::Triple> premises;
  const Rule& rule = *frame.rule;
  for (const Atom& atom : rule.schema) premises.push_back(Ground(atom, frame.binding));
  const std::vector<rdf::Triple>& cells = cells_[frame.cells];
  premises.insert(premises.end(), cells.begin(), cells.end());
  for (const Atom& atom : rule.data) premises.push_back(Ground(atom, frame.binding));
  return premises;
}

void Engine::AddClash(const std::string& rule, std::vector<rdf::Triple> premises) {
  std::vector<rdf::Triple> sorted = premises;
  std::sort(sorted.begin(), sorted.end());
  if (!clash_keys_.Insert(HashOf(rule, sorted))) return;
  if (clashes_.size() < options_.max_clashes) clashes_.push_back({rule, std::move(premises)});
}

// By representatives, each once: one may have been found before its terms were known to be the
// same.
std::vector<rdf::Clash> Engine::TakeClashes() {
  FlatSet seen;
  std::erase_if(clashes_, [&](rdf::Clash& clash) {
    for (rdf::Triple& premise : clash.premises) {
      if (premise.predicate != words_.same_as) premise = equality_.Normal(premise);
    }
    std::vector<rdf::Triple> sorted = clash.premises;
    std::sort(sorted.begin(), sorted.end());
    return has_new_equality_ && !seen.Insert(HashOf(clash.rule, sorted));
  });
  return std::move(clashes_);
}

}  // namespace lares::owl
