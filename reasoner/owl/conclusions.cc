#include <algorithm>
#include <string>

#include "base/error.h"
#include "reasoner/owl/engine.h"

namespace lares::owl {
namespace {

std::uint64_t HashOf(const Rule& rule, const std::vector<rdf::Triple>& premises) {
  std::uint64_t hash = rule.number;
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
  if (rule.is_contradiction()) return AddClash(rule, PremisesOf(frame));
  for (const Atom& atom : rule.heads) {
    const rdf::Triple head = Ground(atom, frame.binding);
    if (Derive(rule, head) && options_.on_derivation) Observe(rule, head, PremisesOf(frame));
  }
}

bool Engine::Knows(const rdf::Triple& triple) const {
  return facts_.Has(triple) || below_.Contains(triple);
}

bool Engine::IsTrivial(const rdf::Triple& triple) const {
  const auto [s, p, o] = triple;
  if (p == words_.type) return o == words_.thing;
  if (p == words_.sub_class_of) return s == o || o == words_.thing || s == words_.nothing;
  return s == o && (p == words_.same_as || p == words_.equivalent_class ||
                    p == words_.sub_property_of || p == words_.equivalent_property);
}

bool Engine::IsStorable(const rdf::Triple& triple) const {
  const auto is_literal = [this](rdf::TermId term) {
    return dictionary_.Kind(term) == rdf::TermKind::kLiteral;
  };
  return !is_literal(triple.subject) && !is_literal(triple.predicate) &&
         !(triple.predicate == words_.same_as && is_literal(triple.object));
}

// True when `head` is new.
bool Engine::Derive(const Rule& rule, const rdf::Triple& head) {
  CheckStop();
  if (IsTrivial(head) || Knows(head) || !IsStorable(head)) return false;
  if (facts_.size() - asserted_ >= options_.max_inferred) {
    throw Error(Code::kTooLarge,
                "more than " + std::to_string(options_.max_inferred) + " triples follow")
        .WithHint("a transitive or equality axiom may join more than it was meant to");
  }
  return facts_.Add(head, rule.number);
}

void Engine::Observe(const Rule& rule, const rdf::Triple& head,
                     std::span<const rdf::Triple> premises) const {
  options_.on_derivation({rule.name, head, premises});
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

void Engine::AddClash(const Rule& rule, std::vector<rdf::Triple> premises) {
  std::vector<rdf::Triple> sorted = premises;
  std::sort(sorted.begin(), sorted.end());
  if (!clash_keys_.Insert(HashOf(rule, sorted))) return;
  if (clashes_.size() < options_.max_clashes) clashes_.push_back({rule.name, std::move(premises)});
}

}  // namespace lares::owl
