// The operators behind a pattern: grouping, order, distinct rows, slices.
#pragma once

#include <vector>

#include "reasoner/sparql/operator.h"
#include "reasoner/sparql/row_set.h"

namespace lares::sparql {

using syntax::Slot;

// One row for each group, with the keys and the values of the aggregates only. In aggregates.cc.
class GroupStep : public Operator {
 public:
  GroupStep(const syntax::Selection& select, std::vector<Slot> visible)
      : select_(select), visible_(std::move(visible)) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Selection& select_;
  std::vector<Slot> visible_;  // of the pattern: what COUNT(DISTINCT *) compares
};

// Rows by their keys; rows that compare equal keep their order. `most`: how many are wanted at all.
class OrderStep : public Operator {
 public:
  OrderStep(const std::vector<syntax::OrderKey>& keys, std::vector<Slot> columns,
            std::optional<std::uint64_t> most)
      : keys_(keys), columns_(std::move(columns)), most_(most) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const std::vector<syntax::OrderKey>& keys_;
  std::vector<Slot> columns_;
  std::optional<std::uint64_t> most_;
};

class DistinctStep : public Operator {
 public:
  explicit DistinctStep(std::vector<Slot> columns) : columns_(std::move(columns)) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  std::vector<Slot> columns_;
};

class SliceStep : public Operator {
 public:
  SliceStep(std::uint64_t offset, std::optional<std::uint64_t> limit)
      : offset_(offset), limit_(limit) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  std::uint64_t offset_;
  std::optional<std::uint64_t> limit_;
};

}  // namespace lares::sparql
