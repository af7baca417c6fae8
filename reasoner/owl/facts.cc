#include "reasoner/owl/facts.h"

namespace lares::owl {
namespace {

std::uint64_t HashOf(const rdf::Triple& triple) {
  const std::uint64_t ends = PairKey(static_cast<std::uint32_t>(triple.subject),
                                     static_cast<std::uint32_t>(triple.object));
  return MixBits(MixBits(ends) + static_cast<std::uint32_t>(triple.predicate));
}

}  // namespace

std::size_t Facts::IndexOf(const rdf::Triple& triple) const {
  if (cells_.empty()) return triples_.size();
  const std::uint64_t hash = HashOf(triple);
  const std::size_t mask = cells_.size() - 1;
  for (std::size_t i = hash & mask; cells_[i] != 0; i = (i + 1) & mask) {
    if (cells_[i] >> 32 != hash >> 32) continue;
    const auto index = static_cast<std::uint32_t>(cells_[i]) - 1;
    if (triples_[index] == triple) return index;
  }
  return triples_.size();
}

bool Facts::Has(const rdf::Triple& triple) const { return IndexOf(triple) < triples_.size(); }

bool Facts::Add(const rdf::Triple& triple, std::uint32_t origin) {
  if (2 * (triples_.size() + 1) > cells_.size()) Grow();
  const std::uint64_t hash = HashOf(triple);
  const std::size_t mask = cells_.size() - 1;
  std::size_t i = hash & mask;
  for (; cells_[i] != 0; i = (i + 1) & mask) {
    if (cells_[i] >> 32 != hash >> 32) continue;
    if (triples_[static_cast<std::uint32_t>(cells_[i]) - 1] == triple) return false;
  }
  triples_.push_back(triple);
  origins_.push_back(origin);
  cells_[i] = (hash >> 32) << 32 | triples_.size();
  return true;
}

void Facts::Grow() {
  cells_.assign(cells_.empty() ? 64 : 2 * cells_.size(), 0);
  const std::size_t mask = cells_.size() - 1;
  for (std::size_t index = 0; index < triples_.size(); ++index) {
    const std::uint64_t hash = HashOf(triples_[index]);
    std::size_t i = hash & mask;
    while (cells_[i] != 0) i = (i + 1) & mask;
    cells_[i] = (hash >> 32) << 32 | (index + 1);
  }
}

std::size_t Facts::Publish() {
  const rdf::Triple& triple = triples_[published_];
  by_predicate_.Append(Key(triple.predicate));
  by_predicate_subject_.Append(Key(triple.predicate, triple.subject));
  by_predicate_object_.Append(Key(triple.predicate, triple.object));
  return published_++;
}

}  // namespace lares::owl
