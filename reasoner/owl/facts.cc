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
  const TripleTable* known = known_.Find(triple.subject);
  if (known == nullptr || known->cells.empty()) return triples_.size();
  const std::uint64_t hash = HashOf(triple);
  const std::size_t mask = known->cells.size() - 1;
  for (std::size_t i = hash & mask; known->cells[i] != 0; i = (i + 1) & mask) {
    if (known->cells[i] >> 32 != hash >> 32) continue;
    const auto index = static_cast<std::uint32_t>(known->cells[i]) - 1;
    if (triples_[index] == triple) return index;
  }
  return triples_.size();
}

bool Facts::Has(const rdf::Triple& triple) const { return IndexOf(triple) < triples_.size(); }

void Facts::Reserve(std::size_t triples) {
  triples_.reserve(triples);
  origins_.reserve(triples);
  for (Chains* chains : {&by_predicate_, &by_predicate_subject_, &by_predicate_object_}) {
    chains->older.reserve(triples);
  }
}

bool Facts::Add(const rdf::Triple& triple, std::uint32_t origin) {
  TripleTable& known = known_.Make(triple.subject);
  if (2 * (known.count + 1) > known.cells.size()) Grow(known);
  const std::uint64_t hash = HashOf(triple);
  const std::size_t mask = known.cells.size() - 1;
  std::size_t i = hash & mask;
  for (; known.cells[i] != 0; i = (i + 1) & mask) {
    if (known.cells[i] >> 32 != hash >> 32) continue;
    if (triples_[static_cast<std::uint32_t>(known.cells[i]) - 1] == triple) return false;
  }
  triples_.push_back(triple);
  origins_.push_back(origin);
  known.cells[i] = (hash >> 32) << 32 | triples_.size();
  ++known.count;
  return true;
}

void Facts::Grow(TripleTable& known) const {
  const std::size_t size = known.cells.empty() ? 16 : 2 * known.cells.size();
  auto old = decltype(known.cells)(size, known.cells.get_allocator());
  old.swap(known.cells);
  const std::size_t mask = known.cells.size() - 1;
  for (const std::uint64_t cell : old) {
    if (cell == 0) continue;
    std::size_t i = HashOf(triples_[static_cast<std::uint32_t>(cell) - 1]) & mask;
    while (known.cells[i] != 0) i = (i + 1) & mask;
    known.cells[i] = cell;
  }
}

std::size_t Facts::Publish() {
  const rdf::Triple& triple = triples_[published_];
  by_predicate_.Append(Key(triple.predicate), triple.predicate);
  by_predicate_subject_.Append(Key(triple.predicate, triple.subject), triple.subject);
  by_predicate_object_.Append(Key(triple.predicate, triple.object), triple.object);
  return published_++;
}

}  // namespace lares::owl
