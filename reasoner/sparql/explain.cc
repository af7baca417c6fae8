#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "reasoner/sparql/solutions.h"

namespace lares::sparql {
namespace {

std::string Rows(double estimate) {
  char text[32];
  std::snprintf(text, sizeof text, estimate < 10 ? "%.1f" : "%.0f", std::min(estimate, 1e15));
  return text;
}

void AppendText(const Operator& op, int depth, bool was_run, std::string& out) {
  out.append(static_cast<std::size_t>(2 * depth), ' ');
  out += op.name;
  if (!op.detail.empty()) out += "  " + op.detail;
  out += "  (about " + Rows(op.estimate) + " rows for each";
  if (was_run) out += ", gave " + std::to_string(op.rows_given);
  out += ")\n";
  for (const OperatorPtr& child : op.children) AppendText(*child, depth + 1, was_run, out);
}

nlohmann::json ToJson(const Operator& op, bool was_run) {
  nlohmann::json json{{"step", op.name}, {"estimate", std::min(op.estimate, 1e15)}};
  if (!op.detail.empty()) json["detail"] = op.detail;
  if (was_run) json["rows"] = op.rows_given;
  for (const OperatorPtr& child : op.children) json["steps"].push_back(ToJson(*child, was_run));
  return json;
}

}  // namespace

std::string Explain(const Query& query, const Dataset& dataset, ExplainFormat format,
                    const std::optional<Limits>& limits, std::stop_token stop) {
  Context context(query.syntax(), dataset, limits.value_or(Limits{}), std::move(stop));
  const auto plan = MakePlan(context, true);
  std::size_t rows = 0;
  if (limits) {
    context.counts_rows = true;
    RunPlan(context, *plan, [&](Row&) {
      ++rows;
      return query.form() != Form::kAsk;
    });
  }
  const bool was_run = limits.has_value();
  if (format == ExplainFormat::kText) {
    std::string text;
    AppendText(*plan->root, 0, was_run, text);
    if (was_run) {
      text += std::to_string(rows) + " rows, " + std::to_string(context.guard.ticks()) +
              " steps, " + std::to_string(context.account.peak()) + " bytes, " +
              std::to_string(context.guard.elapsed().count()) + " µs\n";
    }
    return text;
  }
  nlohmann::json json{{"plan", ToJson(*plan->root, was_run)}};
  if (was_run) {
    json["rows"] = rows;
    json["peak_memory_bytes"] = context.account.peak();
    json["elapsed_us"] = context.guard.elapsed().count();
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace lares::sparql
