// Groups and the values of aggregates (SPARQL 1.1, 18.5.1).
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

#include "reasoner/sparql/expression.h"
#include "reasoner/sparql/modifiers.h"

namespace lares::sparql {

using rdf::kAnyTerm;
using syntax::Aggregate;
using Kind = syntax::Aggregate::Kind;

namespace {

// The value of one aggregate in one group, as rows come.
class Accumulator {
 public:
  Accumulator(const Aggregate& aggregate, std::size_t visible, Context& context)
      : aggregate_(aggregate), context_(context), charge_(context.account) {
    if (aggregate.is_distinct) {
      distinct_ = std::make_unique<RowSet>(aggregate.argument ? 1 : visible, context);
    }
    charge_.Add(sizeof(Accumulator));
  }

  void Add(Row& row, const std::vector<Slot>& visible) {
    if (!aggregate_.argument) {
      if (distinct_ && !IsNewRow(row, visible)) return;
      ++count_;
      return;
    }
    const Value value = EvaluateExpression(*aggregate_.argument, row, context_);
    if (value.is_error()) {
      has_error_ = true;
      return;
    }
    if (distinct_) {
      const TermId id = Intern(value, context_.terms);
      if (!distinct_->Insert({&id, 1}).second) return;
    }
    AddValue(value);
  }

  Value Result() const {
    switch (aggregate_.kind) {
      case Kind::kCount:
        return MakeInteger(static_cast<std::int64_t>(count_));
      case Kind::kSum:
        if (has_error_) return {};
        return count_ == 0 ? MakeInteger(0) : number_;
      case Kind::kAvg:
        if (has_error_) return {};
        if (count_ == 0) return MakeInteger(0);
        return Calculate(syntax::Op::kDivide, number_,
                         MakeInteger(static_cast<std::int64_t>(count_)));
      case Kind::kMin:
      case Kind::kMax:
        if (has_error_) return {};
        return context_.ValueAt(term_);
      case Kind::kSample:
        return context_.ValueAt(term_);
      case Kind::kGroupConcat:
        return has_error_ ? Value{} : MakeString(text_);
    }
    return {};
  }

 private:
  bool IsNewRow(const Row& row, const std::vector<Slot>& visible) {
    std::vector<TermId> cells;
    for (const Slot slot : visible) cells.push_back(row[slot]);
    return distinct_->Insert(cells).second;
  }

  void AddValue(const Value& value) {
    ++count_;
    switch (aggregate_.kind) {
      case Kind::kSum:
      case Kind::kAvg:
        number_ = count_ == 1 && value.is_numeric()
                      ? Calculate(syntax::Op::kAdd, MakeInteger(0), value)
                      : Calculate(syntax::Op::kAdd, number_, value);
        has_error_ = has_error_ || number_.is_error();
        break;
      case Kind::kMin:
      case Kind::kMax: {
        if (count_ > 1) {
          const int order = OrderValues(value, context_.ValueAt(term_));
          if (aggregate_.kind == Kind::kMin ? order >= 0 : order <= 0) break;
        }
        Take(value);
        break;
      }
      case Kind::kSample:
        if (count_ == 1) Take(value);
        break;
      case Kind::kGroupConcat:
        Append(value);
        break;
      case Kind::kCount:
        break;
    }
  }

  void Take(const Value& value) {
    term_ = Intern(value, context_.terms);
    if (IsLocal(term_)) context_.terms.Keep();
  }

  void Append(const Value& value) {
    if (value.kind == Value::Kind::kBlank) {
      has_error_ = true;
      return;
    }
    const std::size_t more = value.text().size() + aggregate_.separator.size();
    charge_.Add(2 * more);
    context_.guard.Work(more);
    if (count_ > 1) text_ += aggregate_.separator;
    text_ += value.text();
  }

  const Aggregate& aggregate_;
  Context& context_;
  Charge charge_;
  std::unique_ptr<RowSet> distinct_;
  std::size_t count_ = 0;
  bool has_error_ = false;
  Value number_;
  TermId term_{};
  std::string text_;
};

using Group = std::vector<std::unique_ptr<Accumulator>>;

}  // namespace

bool GroupStep::Step(Context& context, Row& row, Next next) {
  const auto& keys = select_.group_by;
  RowSet known(keys.size(), context);
  std::vector<Group> groups;
  std::vector<TermId> key(keys.size());
  const auto group_of = [&](std::span<const TermId> cells) -> Group& {
    const auto [number, is_new] = known.Insert(cells);
    if (is_new) {
      groups.emplace_back();
      for (const Aggregate& aggregate : select_.aggregates) {
        groups.back().push_back(std::make_unique<Accumulator>(aggregate, visible_.size(), context));
      }
    }
    return groups[number];
  };
  children[0]->Run(context, row, [&](Row& solution) {
    context.guard.Tick();
    const std::size_t mark = context.terms.Mark();
    for (std::size_t i = 0; i < keys.size(); ++i) {
      key[i] = solution[keys[i].slot];
      if (!keys[i].expression) continue;
      const Value value = EvaluateExpression(*keys[i].expression, solution, context);
      key[i] = value.is_error() ? kAnyTerm : Intern(value, context.terms);
      solution[keys[i].slot] = kAnyTerm;
    }
    for (const auto& accumulator : group_of(key)) accumulator->Add(solution, visible_);
    context.terms.Forget(mark);
    return true;
  });
  if (keys.empty()) group_of({});
  for (std::size_t number = 0; number < groups.size(); ++number) {
    Row out = context.base_row;
    for (std::size_t i = 0; i < keys.size(); ++i) out[keys[i].slot] = known.At(number)[i];
    for (std::size_t i = 0; i < select_.aggregates.size(); ++i) {
      const Value value = groups[number][i]->Result();
      if (!value.is_error()) {
        out[select_.aggregates[i].slot] = Intern(value, context.terms);
      }
    }
    if (!next(out)) return false;
  }
  return true;
}

}  // namespace lares::sparql
