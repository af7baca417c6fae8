#include "reasoner/sparql/plan.h"

#include <algorithm>
#include <utility>

#include "reasoner/sparql/join_order.h"
#include "reasoner/sparql/modifiers.h"

namespace lares::sparql {

using syntax::Expression;
using syntax::Pattern;
using syntax::Selection;
using Kind = syntax::Pattern::Kind;

namespace {

using Patterns = std::vector<const Pattern*>;

bool IsSubset(const Slots& part, const Slots& whole) {
  return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

// Whether a column of `used` may come from outside without being bound for certain inside.
bool Leaks(const Slots& used, const Slots& possible, const Slots& certain) {
  return std::ranges::any_of(
      used, [&](Slot slot) { return possible.count(slot) != 0 && certain.count(slot) == 0; });
}

bool IsJoinOnly(const Pattern& group) {
  return std::ranges::all_of(group.children, [](const Pattern& child) {
    return child.kind != Kind::kFilter && child.kind != Kind::kOptional &&
           child.kind != Kind::kMinus && child.kind != Kind::kBind;
  });
}

// The children of a group, groups that only join taken apart.
void Flatten(const Pattern& group, Patterns& out) {
  for (const Pattern& child : group.children) {
    if (child.kind == Kind::kGroup && IsJoinOnly(child)) {
      Flatten(child, out);
    } else {
      out.push_back(&child);
    }
  }
}

class Planner {
 public:
  Planner(Context& context, Plan& plan, bool describes)
      : context_(context), query_(context.query), plan_(plan), describes_(describes) {}

  OperatorPtr PlanSelection(const Selection& select, GraphScope& scope) {
    Slots bound;
    CollectCertain(select.where, bound);
    PrepareExists(select, bound, scope);
    OperatorPtr op = PlanWhere(select, scope);
    Slots visible;
    CollectVisible(select.where, visible);
    if (select.values) CollectVisible(*select.values, visible);
    if (select.is_grouped) {
      op = Wrap(Named(std::make_unique<GroupStep>(
                          select, std::vector<Slot>(visible.begin(), visible.end())),
                      "group", ""),
                std::move(op));
    }
    op = PlanAssignments(select, std::move(op));
    std::vector<Slot> columns;
    for (const auto& column : select.projection) columns.push_back(column.slot);
    if (!select.order_by.empty()) {
      std::optional<std::uint64_t> most;
      if (select.limit && !select.is_distinct) most = *select.limit + select.offset;
      if (most && *most < select.offset) most.reset();
      op = Wrap(Named(std::make_unique<OrderStep>(select.order_by, columns, most), "order", ""),
                std::move(op));
    }
    if (select.is_distinct) {
      op = Wrap(Named(std::make_unique<DistinctStep>(columns), "distinct", ""), std::move(op));
    }
    if (select.limit || select.offset != 0) {
      auto slice = Named(std::make_unique<SliceStep>(select.offset, select.limit), "slice", "");
      if (describes_) {
        slice->detail = "offset " + std::to_string(select.offset) +
                        (select.limit ? " limit " + std::to_string(*select.limit) : "");
      }
      op = Wrap(std::move(slice), std::move(op));
    }
    return op;
  }

 private:
  OperatorPtr Named(OperatorPtr op, std::string_view name, std::string detail) {
    op->name = name;
    op->detail = std::move(detail);
    return op;
  }

  static OperatorPtr Wrap(OperatorPtr parent, OperatorPtr child) {
    parent->estimate = child->estimate;
    parent->children.push_back(std::move(child));
    return parent;
  }

  OperatorPtr PlanWhere(const Selection& select, GraphScope& scope) {
    Patterns parts{&select.where};
    if (!select.values) return PlanPattern(select.where, {}, scope);
    if (IsJoinOnly(select.where)) {
      parts.clear();
      Flatten(select.where, parts);
    }
    parts.push_back(&*select.values);
    return PlanPipeline(parts, {}, scope);
  }

  OperatorPtr PlanAssignments(const Selection& select, OperatorPtr op) {
    auto pipeline = std::make_unique<PipelineStep>();
    pipeline->name = "sequence";
    pipeline->estimate = op->estimate;
    pipeline->children.push_back(std::move(op));
    for (const Expression& having : select.having) AddFilter(having, *pipeline);
    bool is_first = true;
    for (const auto& column : select.projection) {
      if (!column.expression) continue;
      pipeline->children.push_back(
          PlanBind(*column.expression, column.slot, std::exchange(is_first, false)));
    }
    if (pipeline->children.size() > 1) return pipeline;
    return std::move(pipeline->children[0]);
  }

  // Patterns in the EXISTS of expressions that stand outside the WHERE pattern.
  void PrepareExists(const Selection& select, const Slots& bound, GraphScope& scope) {
    for (const auto& column : select.projection) {
      if (column.expression) PrepareExists(*column.expression, bound, scope);
    }
    for (const auto& key : select.group_by) {
      if (key.expression) PrepareExists(*key.expression, bound, scope);
    }
    for (const auto& aggregate : select.aggregates) {
      if (aggregate.argument) PrepareExists(*aggregate.argument, bound, scope);
    }
    for (const Expression& having : select.having) PrepareExists(having, bound, scope);
    for (const auto& key : select.order_by) PrepareExists(key.expression, bound, scope);
  }

  void PrepareExists(const Expression& expression, const Slots& bound, GraphScope& scope) {
    for (const Expression& argument : expression.arguments) PrepareExists(argument, bound, scope);
    if (!expression.pattern) return;
    context_.exists[expression.pattern.get()] =
        PlanPattern(*expression.pattern, {{}, bound}, scope);
  }

  OperatorPtr PlanPattern(const Pattern& pattern, const Bound& bound, GraphScope& scope) {
    switch (pattern.kind) {
      case Kind::kGroup: {
        Patterns children;
        Flatten(pattern, children);
        return PlanGroup(pattern, children, bound, scope);
      }
      case Kind::kUnion:
        return PlanUnion(pattern, bound, scope);
      case Kind::kGraph:
        return PlanGraph(pattern, bound, scope);
      case Kind::kSelect:
        return PlanSubSelect(pattern, bound, scope);
      case Kind::kService:
        return PlanService(pattern);
      case Kind::kValues:
        return Named(std::make_unique<ValuesStep>(pattern), "values",
                     std::to_string(pattern.rows.size()) + " rows");
      case Kind::kPath: {
        auto path = Named(std::make_unique<PathStep>(pattern, scope), "path", "");
        if (describes_) {
          path->detail = TextOf(pattern.ends.subject, query_) + " " + TextOf(pattern.path, query_) +
                         " " + TextOf(pattern.ends.object, query_);
        }
        return path;
      }
      default:
        return PlanPipeline({&pattern}, bound, scope);
    }
  }

  // A group may be asked with the bindings that come only when none of its filters, optional parts,
  // differences and assignments would see more than the group itself binds (18.2.1, 18.6: patterns
  // are evaluated from the inside out).
  OperatorPtr PlanGroup(const Pattern& pattern, const Patterns& children, const Bound& bound,
                        GraphScope& scope) {
    if (SeesOutside(children, bound.possible)) {
      OperatorPtr inside = PlanPipeline(children, {}, scope);
      return PlanTable(pattern, bound, std::move(inside), scope);
    }
    return PlanPipeline(children, bound, scope);
  }

  static bool SeesOutside(const Patterns& children, const Slots& possible) {
    if (possible.empty()) return false;
    Slots certain, filters;
    for (const Pattern* child : children) {
      Slots used;
      switch (child->kind) {
        case Kind::kFilter:
          CollectUsed(child->expression, filters);
          break;
        case Kind::kBind:
          CollectUsed(child->expression, used);
          break;
        case Kind::kOptional:
        case Kind::kMinus:
          CollectMentioned(*child, used);
          for (const Pattern& inner : child->children) CollectMentioned(inner, used);
          break;
        default:
          break;
      }
      if (Leaks(used, possible, certain)) return true;
      CollectCertain(*child, certain);
    }
    return Leaks(filters, possible, certain);
  }

  template <typename Step>
  OperatorPtr MakeTable(const Slots& visible, const Slots& keys, OperatorPtr inside,
                        const Slots& mentioned, GraphScope& scope) {
    auto table =
        std::make_unique<Step>(std::vector<Slot>(visible.begin(), visible.end()),
                               std::vector<Slot>(keys.begin(), keys.end()),
                               std::vector<Slot>(mentioned.begin(), mentioned.end()), scope);
    table->estimate = keys.empty() ? inside->estimate : std::min(inside->estimate, 2.0);
    table->children.push_back(std::move(inside));
    return table;
  }

  static Slots KeysOf(const Pattern& pattern, const Bound& bound) {
    Slots keys;
    CollectCertain(pattern, keys);
    std::erase_if(keys, [&](Slot slot) { return bound.certain.count(slot) == 0; });
    return keys;
  }

  OperatorPtr PlanTable(const Pattern& pattern, const Bound& bound, OperatorPtr inside,
                        GraphScope& scope) {
    Slots visible, mentioned;
    CollectVisible(pattern, visible);
    CollectMentioned(pattern, mentioned);
    return Named(
        MakeTable<TableStep>(visible, KeysOf(pattern, bound), std::move(inside), mentioned, scope),
        "table", "kept and looked up");
  }

  OperatorPtr PlanUnion(const Pattern& pattern, const Bound& bound, GraphScope& scope) {
    OperatorPtr both = Named(std::make_unique<UnionStep>(), "union", "");
    both->estimate = 0;
    for (const Pattern& child : pattern.children) {
      both->children.push_back(PlanPattern(child, bound, scope));
      both->estimate += both->children.back()->estimate;
    }
    return both;
  }

  OperatorPtr PlanGraph(const Pattern& pattern, const Bound& bound, GraphScope& scope) {
    GraphScope& inside = plan_.scopes.emplace_back();
    inside.source = context_.named.empty() ? scope.source : context_.named[0].source;
    Bound within = bound;
    if (pattern.node.is_variable()) {
      within.possible.insert(pattern.node.index);
      within.certain.insert(pattern.node.index);
    }
    OperatorPtr child = PlanPattern(pattern.children[0], within, inside);
    OperatorPtr graph = std::make_unique<GraphStep>(pattern.node, inside);
    return Wrap(Named(std::move(graph), "graph", describes_ ? TextOf(pattern.node, query_) : ""),
                std::move(child));
  }

  OperatorPtr PlanSubSelect(const Pattern& pattern, const Bound& bound, GraphScope& scope) {
    OperatorPtr select = Wrap(Named(std::make_unique<SubSelectStep>(*pattern.select), "select", ""),
                              PlanSelection(*pattern.select, scope));
    return PlanTable(pattern, bound, std::move(select), scope);
  }

  OperatorPtr PlanService(const Pattern& pattern) {
    if (pattern.is_silent) return Named(std::make_unique<PipelineStep>(), "service", "silent");
    throw Error(Code::kUnsupported, "SERVICE is not answered: no other endpoint is ever asked")
        .WithHint("SERVICE SILENT gives no bindings");
  }

  OperatorPtr PlanBind(const Expression& expression, Slot slot, bool renews_blanks) {
    return Named(
        std::make_unique<BindStep>(expression, slot, renews_blanks), "bind",
        describes_ ? "?" + query_.columns[slot].name + " := " + TextOf(expression, query_) : "");
  }

  void AddFilter(const Expression& expression, Operator& pipeline) {
    pipeline.children.push_back(Named(std::make_unique<FilterStep>(expression), "filter",
                                      describes_ ? TextOf(expression, query_) : ""));
  }

  // Parts of a group in order; only joins between them are reordered. Filters stand as early as
  // everything that they use, and that the group may bind, is bound.
  OperatorPtr PlanPipeline(const Patterns& children, Bound bound, GraphScope& scope) {
    auto pipeline = std::make_unique<PipelineStep>();
    pipeline->name = "sequence";
    Pipeline building{*pipeline, scope, std::move(bound), {}, {}, {}, true};
    Slots finally = building.bound.certain;
    for (const Pattern* child : children) CollectCertain(*child, finally);
    for (const Pattern* child : children) {
      if (child->kind == Kind::kFilter) {
        PrepareExists(child->expression, finally, scope);
        Slots used;
        CollectUsed(child->expression, used);
        building.filters.emplace_back(&child->expression, std::move(used));
      } else {
        CollectVisible(*child, building.visible);
      }
    }
    for (auto& [expression, used] : building.filters) {
      std::erase_if(used, [&](Slot slot) {
        return building.visible.count(slot) == 0 && building.bound.possible.count(slot) == 0;
      });
    }
    PlaceFilters(building);
    for (const Pattern* child : children) AddPart(*child, building);
    FlushJoin(building);
    for (const auto& [expression, used] : building.filters) AddFilter(*expression, *pipeline);
    pipeline->estimate = 1;
    for (const OperatorPtr& child : pipeline->children) pipeline->estimate *= child->estimate;
    if (pipeline->children.size() == 1) return std::move(pipeline->children[0]);
    return pipeline;
  }

  struct Pipeline {
    Operator& out;
    GraphScope& scope;
    Bound bound;
    Slots visible;
    std::vector<std::pair<const Expression*, Slots>> filters;  // still to be placed
    std::vector<JoinPart> joins;                               // still to be ordered
    bool is_first_bind = true;
  };

  void AddPart(const Pattern& child, Pipeline& building) {
    switch (child.kind) {
      case Kind::kFilter:
        return;
      case Kind::kTriples:
        for (const auto& triple : child.triples) {
          JoinPart part;
          part.triple = &triple;
          for (const syntax::Node& node : {triple.subject, triple.predicate, triple.object}) {
            if (node.is_variable()) part.columns.insert(node.index);
          }
          building.joins.push_back(std::move(part));
        }
        return;
      case Kind::kOptional:
        FlushJoin(building);
        AddOptional(child, building);
        break;
      case Kind::kMinus:
        FlushJoin(building);
        AddMinus(child, building);
        break;
      case Kind::kBind:
        FlushJoin(building);
        PrepareExists(child.expression, building.bound.certain, building.scope);
        building.out.children.push_back(
            PlanBind(child.expression, child.slot, std::exchange(building.is_first_bind, false)));
        break;
      default: {
        JoinPart part;
        part.pattern = &child;
        CollectVisible(child, part.columns);
        building.joins.push_back(std::move(part));
        return;
      }
    }
    Learn(child, building);
  }

  // What a placed part binds; then the filters that wait for it.
  void Learn(const Pattern& child, Pipeline& building) {
    CollectVisible(child, building.bound.possible);
    CollectCertain(child, building.bound.certain);
    PlaceFilters(building);
  }

  void PlaceFilters(Pipeline& building) {
    std::erase_if(building.filters, [&](const auto& filter) {
      if (!IsSubset(filter.second, building.bound.certain)) return false;
      AddFilter(*filter.first, building.out);
      return true;
    });
  }

  void FlushJoin(Pipeline& building) {
    OrderJoin(building.joins, building.bound.certain, *building.scope.source, context_);
    for (JoinPart& part : building.joins) {
      OperatorPtr step = part.triple != nullptr
                             ? Named(std::make_unique<TripleStep>(*part.triple, building.scope),
                                     "triple", describes_ ? TextOf(*part.triple, query_) : "")
                             : PlanPattern(*part.pattern, building.bound, building.scope);
      step->estimate = part.estimate;
      building.out.children.push_back(std::move(step));
      building.bound.possible.insert(part.columns.begin(), part.columns.end());
      if (part.triple != nullptr) {
        building.bound.certain.insert(part.columns.begin(), part.columns.end());
      } else {
        CollectCertain(*part.pattern, building.bound.certain);
      }
      PlaceFilters(building);
    }
    building.joins.clear();
  }

  // The filters of the optional group itself are the condition of the join: they see both sides.
  void AddOptional(const Pattern& child, Pipeline& building) {
    const Pattern& group = child.children[0];
    Patterns parts, filters;
    Patterns all;
    Flatten(group, all);
    for (const Pattern* part : all) (part->kind == Kind::kFilter ? filters : parts).push_back(part);
    OperatorPtr inside;
    if (SeesOutside(parts, building.bound.possible)) {
      auto pipeline = std::make_unique<PipelineStep>();
      pipeline->name = "sequence";
      OperatorPtr body = PlanPipeline(parts, {}, building.scope);
      pipeline->children.push_back(
          PlanTable(group, building.bound, std::move(body), building.scope));
      for (const Pattern* filter : filters) {
        PrepareExists(filter->expression, building.bound.certain, building.scope);
        AddFilter(filter->expression, *pipeline);
      }
      inside = std::move(pipeline);
    } else {
      inside = PlanPipeline(all, building.bound, building.scope);
    }
    const double estimate = std::max(1.0, inside->estimate);
    OperatorPtr optional =
        Wrap(Named(std::make_unique<OptionalStep>(), "optional", ""), std::move(inside));
    optional->estimate = estimate;
    building.out.children.push_back(std::move(optional));
  }

  void AddMinus(const Pattern& child, Pipeline& building) {
    const Pattern& group = child.children[0];
    Slots visible, mentioned;
    CollectVisible(group, visible);
    CollectMentioned(group, mentioned);
    OperatorPtr inside = PlanPattern(group, {}, building.scope);
    OperatorPtr minus = MakeTable<MinusStep>(visible, KeysOf(group, building.bound),
                                             std::move(inside), mentioned, building.scope);
    minus->estimate = 0.5;
    building.out.children.push_back(Named(std::move(minus), "minus", ""));
  }

  Context& context_;
  const syntax::Query& query_;
  Plan& plan_;
  bool describes_;
};

}  // namespace

std::unique_ptr<Plan> MakePlan(Context& context, bool describes) {
  auto plan = std::make_unique<Plan>();
  GraphScope& scope = plan->scopes.emplace_back();
  scope.source = context.default_graph;
  plan->root = Planner(context, *plan, describes).PlanSelection(context.query.select, scope);
  return plan;
}

}  // namespace lares::sparql
