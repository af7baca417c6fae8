#include <algorithm>
#include <utility>

#include "reasoner/owl/engine.h"

namespace lares::owl {
namespace {

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

// Sets `slot` to `term` where it is a variable without a value; false when it is something else.
// Literals of one value are no different.
bool Engine::UnifySlot(const Slot& slot, rdf::TermId term,
                       std::vector<rdf::TermId>& binding) const {
  if (!slot.is_variable) return rdf::TermId{slot.value} == term;
  rdf::TermId& value = binding[slot.value];
  if (value == rdf::kAnyTerm) value = term;
  return value == term || (IsLiteral(term) && IsLiteral(value) &&
                           dictionary_.SameValue(term) == dictionary_.SameValue(value));
}

bool Engine::Unify(const Atom& atom, const rdf::Triple& triple,
                   std::vector<rdf::TermId>& binding) const {
  return UnifySlot(atom.subject, triple.subject, binding) &&
         UnifySlot(atom.predicate, triple.predicate, binding) &&
         UnifySlot(atom.object, triple.object, binding) &&
         (atom.number < 0 || IsNumber(triple.object, atom.number));
}

// Whether the term is, or is the same as, a literal of that number.
bool Engine::IsNumber(rdf::TermId term, int number) const {
  const auto has_value = [&](rdf::TermId each) { return HasValue(dictionary_.Get(each), number); };
  const std::span<const rdf::TermId> members = equality_.Members(term);
  return has_value(term) || std::any_of(members.begin(), members.end(), has_value);
}

std::size_t Engine::CountOf(const rdf::Pattern& pattern) const {
  return facts_.Count(pattern) + below_.Estimate(pattern);
}

std::size_t Engine::BestNext(const Frame& frame, std::size_t depth) const {
  std::size_t best = depth;
  int best_score = -1;
  std::size_t best_count = SIZE_MAX;  // of matches, when it was asked for
  for (std::size_t i = depth; i < frame.order.size(); ++i) {
    const rdf::Pattern pattern = (*frame.atoms)[frame.order[i]].In(frame.binding);
    // Which literals are of a datatype is known of each, but cannot be listed.
    const bool is_of_datatype = pattern.predicate == words_.type &&
                                pattern.subject == rdf::kAnyTerm && IsDatatype(pattern.object);
    const int score = is_of_datatype ? 0 : Selectivity(pattern);
    if (score < best_score) continue;
    // Of equals the one with fewer matches: p onProperty is known of many, C someValuesFrom of few.
    std::size_t count = SIZE_MAX;
    if (score == best_score) {
      if (best_count == SIZE_MAX)
        best_count = CountOf((*frame.atoms)[frame.order[best]].In(frame.binding));
      count = CountOf(pattern);
      if (count >= best_count) continue;
    }
    best = i;
    best_score = score;
    best_count = count;
  }
  return best;
}

void Engine::Join(Frame& frame, std::size_t depth) {
  if (depth == frame.order.size()) return Reach(frame);
  if (depth + 1 < frame.order.size()) {
    std::swap(frame.order[depth], frame.order[BestNext(frame, depth)]);
  }
  const Atom& atom = (*frame.atoms)[frame.order[depth]];
  const rdf::Pattern pattern = atom.In(frame.binding);
  Step();
  const auto visit = [&](const rdf::Triple& triple) {
    Step();
    if (Unify(atom, triple, frame.binding)) Join(frame, depth + 1);
    Unbind(atom.subject, pattern.subject, frame.binding);
    Unbind(atom.predicate, pattern.predicate, frame.binding);
    Unbind(atom.object, pattern.object, frame.binding);
  };
  ForEachKnown(pattern, visit);
  if (pattern.predicate == words_.same_as) ForEachSame(pattern, visit);
  const bool is_of_literal = pattern.subject != rdf::kAnyTerm && IsLiteral(pattern.subject);
  if (is_of_literal && pattern.predicate == words_.type && IsDatatype(pattern.object) &&
      IsInDatatype(pattern.subject, pattern.object)) {
    visit({pattern.subject, pattern.predicate, pattern.object});
  }
  // Other literals of the same values.
  if (is_of_literal) {
    for (const rdf::TermId twin : dictionary_.ValueTwins(pattern.subject)) {
      if (twin == pattern.subject) continue;
      ForEachKnown({twin, pattern.predicate, pattern.object}, visit);
    }
  }
  if (pattern.object != rdf::kAnyTerm && IsLiteral(pattern.object)) {
    for (const rdf::TermId twin : dictionary_.ValueTwins(pattern.object)) {
      if (twin == pattern.object) continue;
      ForEachKnown({pattern.subject, pattern.predicate, twin}, visit);
    }
  }
}

// By representatives, whatever is the same is itself (eq-ref): asked of one term, or of the classes
// with several.
void Engine::ForEachSame(const rdf::Pattern& pattern,
                         const std::function<void(const rdf::Triple&)>& visit) {
  const auto [s, p, o] = pattern;
  if (s != rdf::kAnyTerm && o != rdf::kAnyTerm) {
    if (s == o) visit({s, p, s});
    return;
  }
  std::vector<rdf::TermId> known = {s != rdf::kAnyTerm ? s : o};
  if (known.front() == rdf::kAnyTerm) {
    known.clear();
    equality_.ForEachClass([&](std::span<const rdf::TermId> members) {
      known.push_back(equality_.Representative(members.front()));
      return true;
    });
  }
  for (const rdf::TermId term : known) {
    if (!equality_.Members(term).empty()) visit({term, p, term});
  }
}

std::vector<rdf::Triple> Engine::Match(const rdf::Pattern& pattern) {
  std::vector<rdf::Triple> triples;
  ForEachKnown(pattern, [&](const rdf::Triple& triple) { triples.push_back(triple); });
  return triples;
}

std::vector<rdf::TermId> Engine::Objects(rdf::TermId subject, rdf::TermId predicate) {
  std::vector<rdf::TermId> objects;
  ForEachKnown({subject, predicate, {}},
               [&](const rdf::Triple& triple) { objects.push_back(triple.object); });
  return objects;
}

}  // namespace lares::owl
