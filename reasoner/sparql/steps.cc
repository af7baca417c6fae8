#include "reasoner/sparql/steps.h"

#include <array>

#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using rdf::kAnyTerm;
using rdf::Triple;

namespace {

// Binds a variable for the time of a call, when it agrees with what is bound already.
class Binding {
 public:
  bool Bind(Row& row, const syntax::Node& node, TermId id) {
    if (!node.is_variable()) return true;  // matched by the pattern
    TermId& cell = row[node.index];
    if (cell == kAnyTerm) {
      cell = id;
      bound_[count_++] = &cell;
      return true;
    }
    return cell == id;
  }
  ~Binding() {
    for (std::size_t i = 0; i < count_; ++i) *bound_[i] = kAnyTerm;
  }
  Binding() = default;
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  std::array<TermId*, 3> bound_{};
  std::size_t count_ = 0;
};

// Extends `row` by `cells` in `columns` for the time of a call of `next`.
bool Extend(const std::vector<Slot>& columns, std::span<const TermId> cells, Row& row, Next next) {
  std::vector<Slot> bound;
  bool is_compatible = true;
  for (std::size_t i = 0; is_compatible && i < columns.size(); ++i) {
    if (cells[i] == kAnyTerm) continue;
    TermId& cell = row[columns[i]];
    if (cell == kAnyTerm) {
      cell = cells[i];
      bound.push_back(columns[i]);
    } else {
      is_compatible = cell == cells[i];
    }
  }
  bool goes_on = true;
  if (is_compatible) goes_on = next(row);
  for (const Slot slot : bound) row[slot] = kAnyTerm;
  return goes_on;
}

}  // namespace

bool TripleStep::Step(Context& context, Row& row, Next next) {
  const rdf::Pattern pattern{context.At(pattern_.subject, row), context.At(pattern_.predicate, row),
                             context.At(pattern_.object, row)};
  return scope_.source->ForEach(pattern, [&](const Triple& triple) {
    context.guard.Tick();
    Binding binding;
    if (!binding.Bind(row, pattern_.subject, triple.subject) ||
        !binding.Bind(row, pattern_.predicate, triple.predicate) ||
        !binding.Bind(row, pattern_.object, triple.object)) {
      return true;
    }
    return next(row);
  });
}

bool ValuesStep::Step(Context& context, Row& row, Next next) {
  std::vector<TermId> cells(pattern_.slots.size());
  for (const auto& values : pattern_.rows) {
    context.guard.Tick();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] = values[i].kind == syntax::Node::Kind::kNone ? kAnyTerm
                                                             : context.constants[values[i].index];
    }
    if (!Extend(pattern_.slots, cells, row, next)) return false;
  }
  return true;
}

bool PipelineStep::Step(Context& context, Row& row, Next next) {
  return RunFrom(0, context, row, next);
}

bool PipelineStep::RunFrom(std::size_t child, Context& context, Row& row, Next next) {
  if (child == children.size()) return next(row);
  return children[child]->Run(context, row, [&, child](Row& extended) {
    return RunFrom(child + 1, context, extended, next);
  });
}

bool UnionStep::Step(Context& context, Row& row, Next next) {
  for (const OperatorPtr& child : children) {
    if (!child->Run(context, row, next)) return false;
  }
  return true;
}

bool OptionalStep::Step(Context& context, Row& row, Next next) {
  bool has_solution = false;
  const bool goes_on = children[0]->Run(context, row, [&](Row& extended) {
    has_solution = true;
    return next(extended);
  });
  if (!goes_on) return false;
  return has_solution || next(row);
}

bool FilterStep::Step(Context& context, Row& row, Next next) {
  context.guard.Tick();
  const std::size_t mark = context.terms.Mark();
  const bool holds = IsTrue(expression_, row, context);
  context.terms.Forget(mark);
  return !holds || next(row);
}

bool BindStep::Step(Context& context, Row& row, Next next) {
  context.guard.Tick();
  if (renews_blanks_) context.blanks.clear();
  const std::size_t mark = context.terms.Mark();
  const Value value = EvaluateExpression(expression_, row, context);
  if (value.is_error()) return next(row);
  const TermId id = Intern(value, context.terms);
  TermId& cell = row[slot_];
  if (cell != kAnyTerm && cell != id) return true;
  const TermId before = cell;
  cell = id;
  const bool goes_on = next(row);
  row[slot_] = before;
  context.terms.Forget(mark);
  return goes_on;
}

bool GraphStep::Step(Context& context, Row& row, Next next) {
  const TermId wanted = context.At(graph_, row);
  for (const Named& graph : context.named) {
    if (wanted != kAnyTerm && graph.iri != wanted) continue;
    Source* const before = std::exchange(inside_.source, graph.source);
    if (wanted == kAnyTerm) row[graph_.index] = graph.iri;
    const bool goes_on = children[0]->Run(context, row, next);
    if (wanted == kAnyTerm) row[graph_.index] = kAnyTerm;
    inside_.source = before;
    if (!goes_on) return false;
  }
  return true;
}

Table& TableStep::Fresh(Context& context) {
  std::vector<TermId> wanted_for;
  for (const Slot slot : parameters_) wanted_for.push_back(context.base_row[slot]);
  if (!table_ || made_in_ != scope_.source || made_for_ != wanted_for) {
    table_.emplace(columns_, keys_, context);
    Row start = context.base_row;
    table_->Load(*children[0], start);
    made_in_ = scope_.source;
    made_for_ = std::move(wanted_for);
  }
  return *table_;
}

bool TableStep::Step(Context& context, Row& row, Next next) {
  return Fresh(context).Probe(
      row, [&](std::span<const TermId> cells) { return Extend(columns_, cells, row, next); });
}

bool MinusStep::Step(Context& context, Row& row, Next next) {
  bool is_removed = false;
  Fresh(context).Probe(row, [&](std::span<const TermId> cells) {
    bool shares = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const TermId have = row[columns_[i]];
      if (have == kAnyTerm || cells[i] == kAnyTerm) continue;
      if (have != cells[i]) return true;
      shares = true;
    }
    is_removed = shares;
    return !is_removed;
  });
  return is_removed || next(row);
}

bool SubSelectStep::Step(Context& context, Row& row, Next next) {
  Row start = context.base_row;
  std::vector<Slot> columns;
  for (const auto& [inside, outside] : select_.outside) {
    start[inside] = context.base_row[outside];
    columns.push_back(outside);
  }
  std::vector<TermId> cells(columns.size());
  return children[0]->Run(context, start, [&](Row& solution) {
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = solution[select_.outside[i].first];
    return Extend(columns, cells, row, next);
  });
}

}  // namespace lares::sparql
