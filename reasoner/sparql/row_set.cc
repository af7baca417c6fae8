#include "reasoner/sparql/row_set.h"

#include <algorithm>

#include "reasoner/sparql/operator.h"

namespace lares::sparql {
namespace {

std::uint64_t Mix(std::uint64_t hash, TermId id) {
  hash = (hash ^ static_cast<std::uint32_t>(id)) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 29);
}

// Makes room for `more` cells; what the vector grows by is charged before it grows.
void Reserve(std::vector<TermId>& cells, std::size_t more, Charge& charge) {
  if (cells.size() + more <= cells.capacity()) return;
  const std::size_t capacity = std::max<std::size_t>({2 * cells.capacity(), more, 64});
  charge.Add((capacity - cells.capacity()) * sizeof(TermId));
  cells.reserve(capacity);
}

}  // namespace

RowSet::RowSet(std::size_t width, Context& context)
    : width_(width), context_(context), charge_(context.account) {}

std::size_t RowSet::HashOf(std::span<const TermId> row) const {
  std::uint64_t hash = 0x51ED270B;
  for (const TermId id : row) hash = Mix(hash, id);
  return static_cast<std::size_t>(hash);
}

void RowSet::Grow() {
  const std::size_t size = std::max<std::size_t>(64, 2 * slots_.size());
  charge_.Add((size - slots_.size()) * sizeof(std::uint32_t));
  std::vector<std::uint32_t> grown(size);
  for (std::size_t number = 0; number < size_; ++number) {
    std::size_t i = HashOf(At(number)) & (size - 1);
    while (grown[i] != 0) i = (i + 1) & (size - 1);
    grown[i] = static_cast<std::uint32_t>(number + 1);
  }
  slots_ = std::move(grown);
}

std::pair<std::size_t, bool> RowSet::Insert(std::span<const TermId> row) {
  if (2 * (size_ + 1) > slots_.size()) Grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = HashOf(row) & mask;
  for (; slots_[i] != 0; i = (i + 1) & mask) {
    const std::size_t number = slots_[i] - 1;
    if (std::ranges::equal(At(number), row)) return {number, false};
  }
  Reserve(cells_, width_, charge_);
  cells_.insert(cells_.end(), row.begin(), row.end());
  slots_[i] = static_cast<std::uint32_t>(++size_);
  context_.terms.Keep();
  return {size_ - 1, true};
}

Table::Table(std::vector<syntax::Slot> columns, std::vector<syntax::Slot> keys, Context& context)
    : columns_(std::move(columns)),
      keys_(std::move(keys)),
      context_(context),
      charge_(context.account) {
  for (const syntax::Slot key : keys_) {
    key_places_.push_back(static_cast<std::size_t>(
        std::find(columns_.begin(), columns_.end(), key) - columns_.begin()));
  }
}

std::uint64_t Table::KeyOf(FunctionRef<TermId(std::size_t)> term_at) const {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < keys_.size(); ++i) hash = Mix(hash, term_at(i));
  return hash;
}

void Table::Load(Operator& child, Row& start) {
  cells_ = {};
  index_ = {};
  size_ = 0;
  charge_.Clear();
  child.Run(context_, start, [&](Row& row) {
    context_.guard.Tick();
    Reserve(cells_, columns_.size(), charge_);
    for (const syntax::Slot slot : columns_) cells_.push_back(row[slot]);
    context_.terms.Keep();
    ++size_;
    if (size_ % 1024 == 1) charge_.Add(1024);  // also for rows without columns
    return true;
  });
  if (keys_.empty()) return;
  charge_.Add(size_ * sizeof(index_[0]));
  index_.reserve(size_);
  for (std::size_t number = 0; number < size_; ++number) {
    const auto row = At(number);
    index_.emplace_back(KeyOf([&](std::size_t i) { return row[key_places_[i]]; }),
                        static_cast<std::uint32_t>(number));
  }
  std::sort(index_.begin(), index_.end());
}

bool Table::Probe(const Row& row, FunctionRef<bool(std::span<const TermId>)> visit) {
  const bool has_keys = !keys_.empty() && std::ranges::all_of(keys_, [&](syntax::Slot slot) {
    return row[slot] != rdf::kAnyTerm;
  });
  if (!has_keys) {
    for (std::size_t number = 0; number < size_; ++number) {
      context_.guard.Tick();
      if (!visit(At(number))) return false;
    }
    return true;
  }
  const std::uint64_t key = KeyOf([&](std::size_t i) { return row[keys_[i]]; });
  auto at = std::lower_bound(index_.begin(), index_.end(), std::pair{key, std::uint32_t{0}});
  for (; at != index_.end() && at->first == key; ++at) {
    context_.guard.Tick();
    if (!visit(At(at->second))) return false;
  }
  return true;
}

}  // namespace lares::sparql
