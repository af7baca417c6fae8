#include <optional>
#include <string>
#include <utility>

#include "reasoner/sparql/context.h"
#include "reasoner/sparql/operator.h"
#include "reasoner/sparql/plan.h"
#include "reasoner/sparql/solutions.h"

namespace lares::sparql {
namespace {

void Require(const Query& query, bool is_right) {
  if (!is_right) throw Error(Code::kInternal, "the query has another form than it is asked as");
  (void)query;
}

[[noreturn]] void RefuseRows(std::size_t limit) {
  throw Error(Code::kTooLarge, "the answer has more than " + std::to_string(limit) + " rows")
      .WithHint("add LIMIT, or make the query more selective");
}

Statistics StatisticsOf(const Context& context, std::size_t rows) {
  return {rows, context.guard.ticks(), context.account.peak(), context.guard.elapsed()};
}

}  // namespace

void RunPlan(Context& context, Plan& plan, FunctionRef<bool(Row&)> visit) {
  context.guard.Check();
  Row row(context.query.columns.size());
  plan.root->Run(context, row, visit);
}

Statistics Select(const Query& query, const Dataset& dataset, const Limits& limits,
                  std::stop_token stop, const RowVisitor& visit) {
  Require(query, query.form() == Form::kSelect);
  Context context(query.syntax(), dataset, limits, std::move(stop));
  const auto plan = MakePlan(context, false);
  const auto& projection = query.syntax().select.projection;
  std::vector<std::optional<rdf::TermView>> cells(projection.size());
  std::size_t rows = 0;
  RunPlan(context, *plan, [&](Row& row) {
    if (++rows > limits.max_rows) RefuseRows(limits.max_rows);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const TermId id = row[projection[i].slot];
      cells[i] = id == rdf::kAnyTerm ? std::nullopt : std::optional(context.terms.Get(id));
    }
    return visit(cells);
  });
  return StatisticsOf(context, rows);
}

bool Ask(const Query& query, const Dataset& dataset, const Limits& limits, std::stop_token stop) {
  Require(query, query.form() == Form::kAsk);
  Context context(query.syntax(), dataset, limits, std::move(stop));
  const auto plan = MakePlan(context, false);
  bool yes = false;
  RunPlan(context, *plan, [&](Row&) {
    yes = true;
    return false;
  });
  return yes;
}

rdf::Document Construct(const Query& query, const Dataset& dataset, const Limits& limits,
                        std::stop_token stop) {
  const bool describes = query.form() == Form::kDescribe;
  Require(query, describes || query.form() == Form::kConstruct);
  Context context(query.syntax(), dataset, limits, std::move(stop));
  const auto plan = MakePlan(context, false);
  TripleCollector collector(context, limits.max_rows);
  if (describes) {
    DescribeInto(collector, context, *plan);
  } else {
    ConstructInto(collector, context, *plan);
  }
  return collector.ToDocument();
}

Answer Evaluate(const Query& query, const Dataset& dataset, const Limits& limits,
                std::stop_token stop) {
  Answer answer;
  answer.form = query.form();
  answer.variables = query.variables();
  switch (answer.form) {
    case Form::kAsk:
      answer.yes = Ask(query, dataset, limits, std::move(stop));
      break;
    case Form::kSelect: {
      std::size_t bytes = 0;
      answer.statistics = Select(query, dataset, limits, std::move(stop), [&](Cells cells) {
        auto& row = answer.rows.emplace_back();
        for (const auto& cell : cells) {
          row.emplace_back();
          bytes += sizeof(row.back());
          if (!cell) continue;
          bytes += cell->value.size() + cell->datatype.size();
          row.back() = rdf::Term{cell->kind, std::string(cell->value), std::string(cell->datatype),
                                 std::string(cell->language)};
        }
        if (bytes > limits.max_memory_bytes) {
          throw Error(Code::kTooLarge, "the answer is larger than the query's memory");
        }
        return true;
      });
      break;
    }
    default:
      answer.graph = Construct(query, dataset, limits, std::move(stop));
  }
  return answer;
}

Dataset DatasetOf(const rdf::View& view,
                  const std::function<std::string(std::string_view)>& iri_of_name) {
  Dataset dataset{view, {}};
  for (const auto& layer : view.layers()) {
    for (const rdf::Graph& graph : layer->graphs()) {
      dataset.named.push_back({iri_of_name(graph.name), graph.triples, layer});
    }
  }
  return dataset;
}

std::string DocumentGraphIri(std::string_view name) {
  std::string iri = "https://w3id.org/lares/documents/";
  for (const char c : name) iri += c == ':' ? '/' : c;
  return iri;
}

}  // namespace lares::sparql
