// The operators of patterns.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reasoner/sparql/operator.h"
#include "reasoner/sparql/row_set.h"

namespace lares::sparql {

using syntax::Slot;

// The graph that patterns match in; GRAPH ?g moves it on.
struct GraphScope {
  Source* source = nullptr;
};

class TripleStep : public Operator {
 public:
  TripleStep(const syntax::TriplePattern& pattern, const GraphScope& scope)
      : pattern_(pattern), scope_(scope) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::TriplePattern& pattern_;
  const GraphScope& scope_;
};

// A path that triples cannot say: *, +, ?, !. In paths.cc.
class PathStep : public Operator {
 public:
  PathStep(const syntax::Pattern& pattern, const GraphScope& scope)
      : pattern_(pattern), scope_(scope) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Pattern& pattern_;
  const GraphScope& scope_;
};

class ValuesStep : public Operator {
 public:
  explicit ValuesStep(const syntax::Pattern& pattern) : pattern_(pattern) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Pattern& pattern_;
};

// Its children one after the other.
class PipelineStep : public Operator {
 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  bool RunFrom(std::size_t child, Context& context, Row& row, Next next);
};

class UnionStep : public Operator {
 protected:
  bool Step(Context& context, Row& row, Next next) override;
};

class OptionalStep : public Operator {
 protected:
  bool Step(Context& context, Row& row, Next next) override;
};

class FilterStep : public Operator {
 public:
  explicit FilterStep(const syntax::Expression& expression) : expression_(expression) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Expression& expression_;
};

// Assignments; `renews_blanks`: BNODE("…") begins a new solution.
class BindStep : public Operator {
 public:
  BindStep(const syntax::Expression& expression, Slot slot, bool renews_blanks)
      : expression_(expression), slot_(slot), renews_blanks_(renews_blanks) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Expression& expression_;
  Slot slot_;
  bool renews_blanks_;
};

class GraphStep : public Operator {
 public:
  GraphStep(const syntax::Node& graph, GraphScope& inside) : graph_(graph), inside_(inside) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Node& graph_;
  GraphScope& inside_;
};

// Solutions of its child that do not depend on the rows that come: found once and kept, then looked
// up. Found again only when the graph, or the row that an EXISTS is asked for, is another.
class TableStep : public Operator {
 public:
  TableStep(std::vector<Slot> columns, std::vector<Slot> keys, std::vector<Slot> parameters,
            const GraphScope& scope)
      : columns_(std::move(columns)),
        keys_(std::move(keys)),
        parameters_(std::move(parameters)),
        scope_(scope) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;
  Table& Fresh(Context& context);

  std::vector<Slot> columns_, keys_, parameters_;
  const GraphScope& scope_;
  std::optional<Table> table_;
  const Source* made_in_ = nullptr;
  std::vector<TermId> made_for_;
};

// Rows that no solution of the child is compatible with and shares a binding with.
class MinusStep : public TableStep {
 public:
  using TableStep::TableStep;

 protected:
  bool Step(Context& context, Row& row, Next next) override;
};

// A sub-select, from its own columns to those outside.
class SubSelectStep : public Operator {
 public:
  explicit SubSelectStep(const syntax::Selection& select) : select_(select) {}

 protected:
  bool Step(Context& context, Row& row, Next next) override;

 private:
  const syntax::Selection& select_;
};

}  // namespace lares::sparql
