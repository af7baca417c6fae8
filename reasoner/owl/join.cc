#include <algorithm>
#include <utility>

#include "reasoner/owl/engine.h"

namespace lares::owl {
namespace {

// Sets `slot` to `term` where it is a variable without a value; false when it is something else.
bool UnifySlot(const Slot& slot, rdf::TermId term, std::vector<rdf::TermId>& binding) {
  if (!slot.is_variable) return rdf::TermId{slot.value} == term;
  rdf::TermId& value = binding[slot.value];
  if (value == rdf::kAnyTerm) value = term;
  return value == term;
}

void Unbind(const Slot& slot, rdf::TermId before, std::vector<rdf::TermId>& binding) {
  if (before == rdf::kAnyTerm) binding[slot.value] = rdf::kAnyTerm;
}

// How few matches to expect: a pattern with two known ends before one with one.
int Selectivity(const rdf::Pattern& pattern) {
  const int subject = pattern.subject != rdf::kAnyTerm ? 3 : 0;
  const int object = pattern.object != rdf::kAnyTerm ? 3 : 0;
  return subject + object + (pattern.predicate != rdf::kAnyTerm ? 2 : 0);
}

}  // namespace

bool Engine::Unify(const Atom& atom, const rdf::Triple& triple,
                   std::vector<rdf::TermId>& binding) const {
  return UnifySlot(atom.subject, triple.subject, binding) &&
         UnifySlot(atom.predicate, triple.predicate, binding) &&
         UnifySlot(atom.object, triple.object, binding) &&
         (atom.number < 0 || HasValue(dictionary_.Get(triple.object), atom.number));
}

std::size_t Engine::BestNext(const Frame& frame, std::size_t depth) const {
  std::size_t best = depth;
  int best_score = -1;
  for (std::size_t i = depth; i < frame.order.size(); ++i) {
    const int score = Selectivity((*frame.atoms)[frame.order[i]].In(frame.binding));
    if (score > best_score) {
      best = i;
      best_score = score;
    }
  }
  return best;
}

void Engine::Join(Frame& frame, std::size_t depth) {
  if (depth == frame.order.size()) return Reach(frame);
  CheckStop();
  if (depth + 1 < frame.order.size()) {
    std::swap(frame.order[depth], frame.order[BestNext(frame, depth)]);
  }
  const Atom& atom = (*frame.atoms)[frame.order[depth]];
  const rdf::Pattern pattern = atom.In(frame.binding);
  const auto visit = [&](const rdf::Triple& triple) {
    if (Unify(atom, triple, frame.binding)) Join(frame, depth + 1);
    Unbind(atom.subject, pattern.subject, frame.binding);
    Unbind(atom.predicate, pattern.predicate, frame.binding);
    Unbind(atom.object, pattern.object, frame.binding);
    return true;
  };
  facts_.ForEach(pattern, visit);
  below_.ForEach(pattern, visit);
}

std::vector<rdf::Triple> Engine::Match(const rdf::Pattern& pattern) {
  std::vector<rdf::Triple> triples = below_.Match(pattern);
  facts_.ForEach(pattern, [&](const rdf::Triple& triple) { triples.push_back(triple); });
  return triples;
}

std::vector<rdf::TermId> Engine::Objects(rdf::TermId subject, rdf::TermId predicate) {
  std::vector<rdf::TermId> objects = below_.Objects(subject, predicate);
  facts_.ForEach({subject, predicate, {}},
                 [&](const rdf::Triple& triple) { objects.push_back(triple.object); });
  return objects;
}

}  // namespace lares::owl
