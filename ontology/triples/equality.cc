#include "ontology/triples/equality.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

bool IsReserved(std::string_view iri) {
  return iri.starts_with(kRdf) || iri.starts_with(kRdfs) || iri.starts_with(kOwl);
}

}  // namespace

TermId Equality::Representative(TermId term) const {
  if (IsMerged(term)) return representative_of_.at(term);
  if (members_of_.empty() || dictionary_->Kind(term) != TermKind::kLiteral) return term;
  const TermId value = dictionary_->SameValue(term);
  return IsMerged(value)               ? representative_of_.at(value)
         : members_of_.contains(value) ? value
                                       : term;
}

std::span<const TermId> Equality::Members(TermId representative) const {
  const auto found = members_of_.find(representative);
  return found == members_of_.end() ? std::span<const TermId>() : found->second;
}

int Equality::Rank(TermId term) const {
  const TermView view = dictionary_->Get(term);
  if (view.kind == TermKind::kBlank) return 2;
  if (view.kind == TermKind::kLiteral) return 3;
  return IsReserved(view.value) ? 0 : 1;
}

void Equality::SetRepresentative(TermId term, TermId representative) {
  representative_of_[term] = representative;
  least_merged_ = std::min(least_merged_, term);
  most_merged_ = std::max(most_merged_, term);
}

std::vector<TermId> Equality::Merge(TermId a, TermId b) {
  // A value joins by the first literal that denotes it; others of the same value follow it.
  TermId winner = Representative(dictionary_->SameValue(a));
  TermId loser = Representative(dictionary_->SameValue(b));
  if (winner == loser) return {};
  const auto size = [this](TermId term) { return std::max<std::size_t>(1, Members(term).size()); };
  const int winner_rank = Rank(winner), loser_rank = Rank(loser);
  if (winner_rank == 0 && loser_rank == 0) {
    throw Error(Code::kUnsupported, "<" + std::string(dictionary_->Get(a).value) + "> and <" +
                                        std::string(dictionary_->Get(b).value) +
                                        "> would be the same: words of OWL itself");
  }
  if (loser_rank < winner_rank || (loser_rank == winner_rank && size(loser) > size(winner))) {
    std::swap(winner, loser);
  }
  std::vector<TermId> moved = TakeClass(loser);
  std::vector<TermId> members = TakeClass(winner);
  std::vector<TermId> twins;  // of a winner that was alone
  for (const TermId term : members) {
    if (IsMerged(term) || term == winner) continue;
    SetRepresentative(term, winner);
    twins.push_back(term);
  }
  for (const TermId term : moved) {
    SetRepresentative(term, winner);
    members.push_back(term);
  }
  members_of_[winner] = std::move(members);
  moved.insert(moved.end(), twins.begin(), twins.end());
  return moved;
}

bool Equality::AddTwin(TermId literal) {
  if (members_of_.empty() || IsMerged(literal) || members_of_.contains(literal)) return false;
  const TermId representative = Representative(literal);
  if (representative == literal) return false;
  SetRepresentative(literal, representative);
  members_of_[representative].push_back(literal);
  return true;
}

// The members of a class, the representative first, before they get another place. A literal that
// was alone comes with every other of its value.
std::vector<TermId> Equality::TakeClass(TermId representative) {
  if (const auto known = members_of_.find(representative); known != members_of_.end()) {
    std::vector<TermId> members = std::move(known->second);
    members_of_.erase(known);
    return members;
  }
  std::vector<TermId> members = {representative};
  for (const TermId twin : dictionary_->ValueTwins(representative)) {
    if (twin != representative) members.push_back(twin);
  }
  return members;
}

bool Equality::ForEachClass(const std::function<bool(std::span<const TermId>)>& visit) const {
  return std::all_of(members_of_.begin(), members_of_.end(),
                     [&](const auto& entry) { return visit(entry.second); });
}

}  // namespace lares::rdf
