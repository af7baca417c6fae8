#include "reasoner/owl/known_triples.h"

#include <algorithm>

#include "reasoner/owl/rule.h"

namespace lares::owl {

using rdf::kAnyTerm;
using rdf::Pattern;
using rdf::TermId;
using rdf::Triple;

namespace {

bool Fits(TermId wanted, TermId term) { return wanted == kAnyTerm || wanted == term; }

}  // namespace

KnownTriples::KnownTriples(rdf::View view, Literals literals)
    : view_(std::move(view)), literals_(literals) {
  if (is_general()) same_as_ = view_.dictionary().InternIri(Expand("owl:sameAs"));
}

TermId KnownTriples::Representative(TermId term) const {
  if (term == kAnyTerm || view_.equality() == nullptr) return term;
  return view_.equality()->Representative(term);
}

bool KnownTriples::IsLiteral(TermId term) const {
  return view_.dictionary().Kind(term) == rdf::TermKind::kLiteral;
}

// Says only that a class of equal terms is one.
bool KnownTriples::IsOfClass(const Triple& stored) const {
  return stored.predicate == Representative(same_as_) && stored.subject == stored.object;
}

std::vector<TermId> KnownTriples::Members(TermId representative) const {
  if (view_.equality() != nullptr) {
    const auto members = view_.equality()->Members(representative);
    if (!members.empty()) return {members.begin(), members.end()};
  }
  return {representative};
}

std::vector<TermId> KnownTriples::Twins(TermId term) const {
  if (term == kAnyTerm || !IsLiteral(term)) return {term};
  std::vector<TermId> twins = view_.dictionary().ValueTwins(term);
  if (twins.empty()) twins.push_back(term);
  return twins;
}

bool KnownTriples::HoldsOfLiteral(const Triple& triple) const {
  if (!IsLiteral(triple.subject)) return view_.Contains(triple);
  if (IsLiteral(triple.predicate)) return false;
  const Triple stored{Representative(triple.subject), Representative(triple.predicate),
                      Representative(triple.object)};
  if (!IsOfClass(stored)) return view_.ContainsStored(stored);
  return triple.subject != triple.object;
}

bool KnownTriples::ContainsGeneral(const Triple& triple) const {
  const auto [s, p, o] = triple;
  const std::vector<TermId> subjects = Twins(s), objects = Twins(o);
  if (p == same_as_ && s != o && std::find(subjects.begin(), subjects.end(), o) != subjects.end()) {
    return true;
  }
  return std::any_of(subjects.begin(), subjects.end(), [&, p = p](TermId subject) {
    return std::any_of(objects.begin(), objects.end(), [&](TermId object) {
      return HoldsOfLiteral({subject, p, object});
    });
  });
}

std::size_t KnownTriples::CountOfTwins(const Pattern& pattern) const {
  std::size_t count = 0;
  for (const TermId subject : Twins(pattern.subject)) {
    for (const TermId object : Twins(pattern.object)) {
      if (subject == pattern.subject && object == pattern.object) continue;
      count += 1 + view_.Estimate({subject, pattern.predicate, object});
    }
  }
  return count;
}

bool KnownTriples::ForEachGeneral(const Pattern& pattern, const Visitor& visit) const {
  return ForEachAboutLiterals(pattern, visit) && ForEachOfTwins(pattern, visit);
}

// Those whose subject is a literal, which the view keeps to itself.
bool KnownTriples::ForEachAboutLiterals(const Pattern& pattern, const Visitor& visit) const {
  if (pattern.subject != kAnyTerm && !IsLiteral(pattern.subject)) return true;
  if (view_.equality() == nullptr) {
    if (!view_.has_literal_subjects()) return true;
    return view_.ForEachStored(
        pattern, [&](const Triple& triple) { return !IsLiteral(triple.subject) || visit(triple); });
  }
  if (!ForEachSame(pattern, visit)) return false;
  const auto fitting = [&](TermId wanted, TermId stored) {
    return wanted == kAnyTerm ? Members(stored) : std::vector<TermId>{wanted};
  };
  const Pattern normal{Representative(pattern.subject), Representative(pattern.predicate),
                       Representative(pattern.object)};
  return view_.ForEachStored(normal, [&](const Triple& stored) {
    if (IsOfClass(stored)) return true;
    for (const TermId s : fitting(pattern.subject, stored.subject)) {
      if (!IsLiteral(s)) continue;
      for (const TermId p : fitting(pattern.predicate, stored.predicate)) {
        if (IsLiteral(p)) continue;
        for (const TermId o : fitting(pattern.object, stored.object)) {
          if (!visit(Triple{s, p, o})) return false;
        }
      }
    }
    return true;
  });
}

// What literals are the same as.
bool KnownTriples::ForEachSame(const Pattern& pattern, const Visitor& visit) const {
  const TermId known = pattern.subject != kAnyTerm ? pattern.subject : pattern.object;
  if (!Fits(Representative(pattern.predicate), Representative(same_as_))) return true;
  const auto pairs_of = [&](std::span<const TermId> members) {
    for (const TermId s : members) {
      if (!Fits(pattern.subject, s) || !IsLiteral(s)) continue;
      for (const TermId o : members) {
        if (s == o || !Fits(pattern.object, o)) continue;
        if (!visit(Triple{s, same_as_, o})) return false;
      }
    }
    return true;
  };
  if (known == kAnyTerm) return view_.equality()->ForEachClass(pairs_of);
  return pairs_of(view_.equality()->Members(Representative(known)));
}

// What is said of other literals of the same value as those that the pattern names.
bool KnownTriples::ForEachOfTwins(const Pattern& pattern, const Visitor& visit) const {
  const auto [s, p, o] = pattern;
  const std::vector<TermId> subjects = Twins(s), objects = Twins(o);
  if (subjects.size() == 1 && objects.size() == 1) return true;
  if (Fits(p, same_as_)) {
    for (const TermId twin : subjects) {
      if (o == kAnyTerm && twin != s && !visit(Triple{s, same_as_, twin})) return false;
    }
    for (const TermId twin : objects) {
      if (s == kAnyTerm && twin != o && !visit(Triple{twin, same_as_, o})) return false;
    }
  }
  for (const TermId subject : subjects) {
    for (const TermId object : objects) {
      if (subject == s && object == o) continue;
      const auto as_named = [&, s = s, o = o](const Triple& triple) {
        const Triple named{s == kAnyTerm ? triple.subject : s, triple.predicate,
                           o == kAnyTerm ? triple.object : o};
        return HoldsOfLiteral(named) || visit(named);
      };
      if (!view_.ForEach({subject, p, object}, as_named)) return false;
      if (!ForEachAboutLiterals({subject, p, object}, as_named)) return false;
    }
  }
  return true;
}

}  // namespace lares::owl
