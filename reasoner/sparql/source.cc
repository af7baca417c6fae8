#include "reasoner/sparql/source.h"

#include <algorithm>
#include <tuple>

#include "ontology/triples/sorting.h"
#include "reasoner/sparql/terms.h"

namespace lares::sparql {

using rdf::kAnyTerm;
using rdf::Pattern;
using rdf::Triple;

namespace {

// No stored triple has a term that a query made.
bool HasLocal(const Pattern& pattern) {
  return IsLocal(pattern.subject) || IsLocal(pattern.predicate) || IsLocal(pattern.object);
}

// The run of `sorted` whose first components by `get` are those of `key` that are not kAnyTerm;
// the bound ones come first.
template <typename Get>
std::span<const Triple> Equal(std::span<const Triple> sorted, const Pattern& key, Get get) {
  const std::array<TermId, 3> wanted = get(Triple{key.subject, key.predicate, key.object});
  std::size_t bound = 0;
  while (bound < 3 && wanted[bound] != kAnyTerm) ++bound;
  const auto compare = [&](const Triple& triple) {
    const std::array<TermId, 3> have = get(triple);
    for (std::size_t i = 0; i < bound; ++i) {
      if (have[i] != wanted[i]) return have[i] < wanted[i] ? -1 : 1;
    }
    return 0;
  };
  const auto begin = std::partition_point(sorted.begin(), sorted.end(),
                                          [&](const Triple& t) { return compare(t) < 0; });
  const auto end =
      std::partition_point(begin, sorted.end(), [&](const Triple& t) { return compare(t) <= 0; });
  return {begin, end};
}

std::array<TermId, 3> Spo(const Triple& t) { return {t.subject, t.predicate, t.object}; }
std::array<TermId, 3> Pos(const Triple& t) { return {t.predicate, t.object, t.subject}; }
std::array<TermId, 3> Osp(const Triple& t) { return {t.object, t.subject, t.predicate}; }

}  // namespace

bool ViewSource::ForEach(const Pattern& pattern, Visit visit) {
  if (HasLocal(pattern)) return true;
  return view_.ForEach(pattern, visit);
}

std::size_t ViewSource::Estimate(const Pattern& pattern) {
  return HasLocal(pattern) ? 0 : view_.Estimate(pattern);
}

ListSource::ListSource(const std::vector<std::span<const Triple>>& lists, Account& account)
    : charge_(account) {
  std::size_t count = 0;
  for (const auto& list : lists) count += list.size();
  charge_.Add(count * sizeof(Triple));
  own_.reserve(count);
  for (const auto& list : lists) own_.insert(own_.end(), list.begin(), list.end());
  rdf::SortAndDeduplicate(own_);
  spo_ = own_;
}

const std::vector<Triple>& ListSource::Order(bool by_predicate) {
  auto& order = by_predicate ? pos_ : osp_;
  if (!order) {
    charge_.Add(spo_.size_bytes());
    order.emplace(spo_.begin(), spo_.end());
    rdf::StableSortBy(rdf::Component::kObject, *order);
    if (by_predicate) rdf::StableSortBy(rdf::Component::kPredicate, *order);
  }
  return *order;
}

std::span<const Triple> ListSource::Run(const Pattern& pattern) {
  if (HasLocal(pattern)) return {};
  const auto [s, p, o] = pattern;
  if (s != kAnyTerm && (o == kAnyTerm || p != kAnyTerm)) return Equal(spo_, pattern, Spo);
  if (o != kAnyTerm && p == kAnyTerm) return Equal(Order(false), pattern, Osp);
  if (p != kAnyTerm) return Equal(Order(true), pattern, Pos);
  return spo_;
}

bool ListSource::ForEach(const Pattern& pattern, Visit visit) {
  for (const Triple& triple : Run(pattern)) {
    if (!visit(triple)) return false;
  }
  return true;
}

std::size_t ListSource::Estimate(const Pattern& pattern) { return Run(pattern).size(); }

}  // namespace lares::sparql
