// Rows kept by an evaluation, under its memory account.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "reasoner/sparql/context.h"

namespace lares::sparql {

// Distinct rows of one width, numbered from 0.
class RowSet {
 public:
  RowSet(std::size_t width, Context& context);

  // The number of the row, and whether it is new.
  std::pair<std::size_t, bool> Insert(std::span<const TermId> row);
  std::size_t size() const { return size_; }
  std::span<const TermId> At(std::size_t number) const {
    return {cells_.data() + number * width_, width_};
  }

 private:
  std::size_t HashOf(std::span<const TermId> row) const;
  void Grow();

  std::size_t width_;
  std::size_t size_ = 0;
  std::vector<TermId> cells_;
  std::vector<std::uint32_t> slots_;  // number + 1; 0 is free
  Context& context_;
  Charge charge_;
};

// All solutions of an operator, to be joined with rows on columns that both have.
class Table {
 public:
  // `keys` are among `columns` and bound in every solution.
  Table(std::vector<syntax::Slot> columns, std::vector<syntax::Slot> keys, Context& context);

  void Load(Operator& child, Row& start);
  // Calls `visit` with each kept row (in the order of columns()) that may be compatible with `row`:
  // its keys are the same. False when `visit` said so.
  bool Probe(const Row& row, FunctionRef<bool(std::span<const TermId>)> visit);
  const std::vector<syntax::Slot>& columns() const { return columns_; }

 private:
  std::uint64_t KeyOf(FunctionRef<TermId(std::size_t)> term_at) const;
  std::span<const TermId> At(std::size_t number) const {
    return {cells_.data() + number * columns_.size(), columns_.size()};
  }

  std::vector<syntax::Slot> columns_;
  std::vector<syntax::Slot> keys_;
  std::vector<std::size_t> key_places_;  // in columns_
  std::size_t size_ = 0;
  std::vector<TermId> cells_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> index_;  // sorted: key, row
  Context& context_;
  Charge charge_;
};

}  // namespace lares::sparql
