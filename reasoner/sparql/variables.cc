#include "reasoner/sparql/variables.h"

#include <algorithm>

namespace lares::sparql {

using syntax::Expression;
using syntax::Node;
using syntax::Op;
using syntax::Pattern;
using Kind = syntax::Pattern::Kind;

namespace {

void Add(const Node& node, Slots& slots) {
  if (node.is_variable()) slots.insert(node.index);
}

void AddEnds(const syntax::TriplePattern& triple, Slots& slots) {
  Add(triple.subject, slots);
  Add(triple.predicate, slots);
  Add(triple.object, slots);
}

// Columns that have a term in each row of VALUES.
void AddFilled(const Pattern& values, Slots& slots) {
  for (std::size_t i = 0; i < values.slots.size(); ++i) {
    const bool is_filled =
        std::all_of(values.rows.begin(), values.rows.end(),
                    [&](const auto& row) { return row[i].kind != Node::Kind::kNone; });
    if (is_filled) slots.insert(values.slots[i]);
  }
}

void CollectCertainOfUnion(const Pattern& both, Slots& certain) {
  Slots common;
  for (std::size_t i = 0; i < both.children.size(); ++i) {
    Slots one;
    CollectCertain(both.children[i], one);
    if (i == 0) {
      common = std::move(one);
    } else {
      std::erase_if(common, [&](syntax::Slot slot) { return one.count(slot) == 0; });
    }
  }
  certain.insert(common.begin(), common.end());
}

void CollectCertainOfSelect(const syntax::Selection& select, Slots& certain) {
  Slots inside;
  CollectCertain(select.where, inside);
  if (select.values) CollectCertain(*select.values, inside);
  if (select.is_grouped) {
    // Keys keep their values; what is counted is always there.
    Slots keys;
    for (const auto& key : select.group_by) {
      if (!key.expression && inside.count(key.slot) != 0) keys.insert(key.slot);
    }
    inside = std::move(keys);
  }
  for (const auto& [from, to] : select.outside) {
    if (inside.count(from) != 0) certain.insert(to);
  }
}

}  // namespace

void CollectVisible(const Pattern& pattern, Slots& visible) {
  switch (pattern.kind) {
    case Kind::kTriples:
      for (const auto& triple : pattern.triples) AddEnds(triple, visible);
      break;
    case Kind::kPath:
      AddEnds(pattern.ends, visible);
      break;
    case Kind::kBind:
      visible.insert(pattern.slot);
      break;
    case Kind::kValues:
      visible.insert(pattern.slots.begin(), pattern.slots.end());
      break;
    case Kind::kSelect:
      for (const auto& [inside, outside] : pattern.select->outside) visible.insert(outside);
      break;
    case Kind::kMinus:
    case Kind::kFilter:
      break;
    default:
      Add(pattern.node, visible);
      for (const Pattern& child : pattern.children) CollectVisible(child, visible);
  }
}

void CollectCertain(const Pattern& pattern, Slots& certain) {
  switch (pattern.kind) {
    case Kind::kTriples:
    case Kind::kPath:
      CollectVisible(pattern, certain);
      break;
    case Kind::kBind:
      if (pattern.expression.op == Op::kTerm) certain.insert(pattern.slot);
      break;
    case Kind::kValues:
      AddFilled(pattern, certain);
      break;
    case Kind::kSelect:
      CollectCertainOfSelect(*pattern.select, certain);
      break;
    case Kind::kUnion:
      CollectCertainOfUnion(pattern, certain);
      break;
    case Kind::kOptional:
    case Kind::kMinus:
    case Kind::kFilter:
    case Kind::kService:
      break;
    case Kind::kGraph:
    case Kind::kGroup:
      Add(pattern.node, certain);
      for (const Pattern& child : pattern.children) CollectCertain(child, certain);
      break;
  }
}

void CollectUsed(const Expression& expression, Slots& used) {
  if (expression.op == Op::kVariable) Add(expression.node, used);
  for (const Expression& argument : expression.arguments) CollectUsed(argument, used);
  if (expression.pattern) CollectMentioned(*expression.pattern, used);
}

void CollectMentioned(const Pattern& pattern, Slots& mentioned) {
  CollectVisible(pattern, mentioned);
  if (pattern.kind == Kind::kFilter || pattern.kind == Kind::kBind) {
    CollectUsed(pattern.expression, mentioned);
  }
  for (const Pattern& child : pattern.children) CollectMentioned(child, mentioned);
}

}  // namespace lares::sparql
