#include "reasoner/sparql/modifiers.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using rdf::kAnyTerm;

namespace {

// Terms by their place in ORDER BY's order; terms with equal values share one.
class Ranks {
 public:
  explicit Ranks(Context& context) : context_(context), charge_(context.account) {}

  void Add(TermId id) {
    if (!ranks_.emplace(id, 0).second) return;
    if (ranks_.size() % 64 == 1) charge_.Add(64 * kBytesEach);
  }
  void Sort() {
    std::vector<std::pair<Value, std::uint32_t*>> values;
    charge_.Add(ranks_.size() * sizeof(values[0]));
    values.reserve(ranks_.size());
    for (auto& [id, rank] : ranks_) values.emplace_back(context_.ValueAt(id), &rank);
    std::sort(values.begin(), values.end(), [this](const auto& a, const auto& b) {
      context_.guard.Tick();
      return OrderValues(a.first, b.first) < 0;
    });
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0 && OrderValues(values[i - 1].first, values[i].first) != 0) ++rank;
      *values[i].second = rank;
    }
  }
  std::uint32_t Of(TermId id) const { return ranks_.at(id); }

 private:
  static constexpr std::size_t kBytesEach = 48;
  Context& context_;
  std::unordered_map<TermId, std::uint32_t> ranks_;
  Charge charge_;
};

// What ORDER BY keeps: for each row its columns, then its keys.
struct Kept {
  explicit Kept(Context& context) : charge(context.account) {}
  std::vector<TermId> cells;
  std::size_t count = 0;
  Charge charge;
};

}  // namespace

bool OrderStep::Step(Context& context, Row& row, Next next) {
  const std::size_t width = columns_.size() + keys_.size();
  Kept kept(context);
  Ranks ranks(context);
  children[0]->Run(context, row, [&](Row& solution) {
    context.guard.Tick();
    if (kept.cells.size() + width > kept.cells.capacity()) {
      const std::size_t grown = std::max<std::size_t>(2 * kept.cells.capacity(), 64 * width);
      kept.charge.Add((grown - kept.cells.capacity()) * sizeof(TermId));
      kept.cells.reserve(grown);
    }
    for (const Slot slot : columns_) kept.cells.push_back(solution[slot]);
    for (const syntax::OrderKey& key : keys_) {
      const Value value = EvaluateExpression(key.expression, solution, context);
      const TermId id = value.is_error() ? kAnyTerm : Intern(value, context.terms);
      kept.cells.push_back(id);
      ranks.Add(id);
    }
    context.terms.Keep();
    ++kept.count;
    return true;
  });
  ranks.Sort();
  for (std::size_t i = 0; i < kept.count; ++i) {
    for (std::size_t k = columns_.size(); k < width; ++k) {
      TermId& cell = kept.cells[i * width + k];
      cell = TermId{ranks.Of(cell)};
    }
  }
  std::vector<std::uint32_t> order(kept.count);
  kept.charge.Add(kept.count * sizeof(std::uint32_t));
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    context.guard.Tick();
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      const TermId x = kept.cells[a * width + columns_.size() + k];
      const TermId y = kept.cells[b * width + columns_.size() + k];
      if (x != y) return keys_[k].is_descending ? y < x : x < y;
    }
    return a < b;
  };
  const std::size_t wanted =
      most_ ? static_cast<std::size_t>(std::min<std::uint64_t>(*most_, kept.count)) : kept.count;
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(wanted), order.end(),
                    before);
  Row out = row;
  for (std::size_t i = 0; i < wanted; ++i) {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      out[columns_[c]] = kept.cells[order[i] * width + c];
    }
    if (!next(out)) return false;
  }
  return true;
}

bool DistinctStep::Step(Context& context, Row& row, Next next) {
  RowSet seen(columns_.size(), context);
  std::vector<TermId> cells(columns_.size());
  return children[0]->Run(context, row, [&](Row& solution) {
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = solution[columns_[i]];
    return !seen.Insert(cells).second || next(solution);
  });
}

bool SliceStep::Step(Context& context, Row& row, Next next) {
  if (limit_ && *limit_ == 0) return true;
  std::uint64_t skipped = 0;
  std::uint64_t given = 0;
  bool goes_on = true;
  children[0]->Run(context, row, [&](Row& solution) {
    if (skipped < offset_) {
      ++skipped;
      return true;
    }
    goes_on = next(solution);
    return goes_on && !(limit_ && ++given >= *limit_);
  });
  return goes_on;
}

}  // namespace lares::sparql
