#include <nlohmann/json.hpp>

#include "recipes/plan/export.h"

namespace lares::recipes {

namespace {

using nlohmann::json;

json ToJson(const Resource& resource) {
  return {{"iri", resource.iri}, {"label", resource.label}, {"as_written", resource.as_written}};
}

// Declared before the template that calls them.
json ToJson(const Finding& finding);
json ToJson(const Need& need);
json ToJson(const Parameter& parameter);
json ToJson(const State& state);
json ToJson(const Transition& transition);
json ToJson(const Choice& choice);

// Null for what there is none of.
json ToJsonOrNull(const Resource& resource) {
  return resource.iri.empty() ? json(nullptr) : ToJson(resource);
}

template <typename Items>
json ToArray(const Items& items) {
  json array = json::array();
  for (const auto& item : items) array.push_back(ToJson(item));
  return array;
}

json ToJson(const Finding& finding) {
  return {{"kind", finding.kind == Finding::Kind::kCapability ? "capability" : "component"},
          {"what", ToJson(finding.what)},
          {"availability", ToString(finding.availability)},
          {"asserted", finding.asserted},
          {"provided_by", ToArray(finding.provided_by)},
          {"dependencies", ToArray(finding.dependencies)},
          {"explanation", finding.explanation}};
}

json ToJson(const Need& need) {
  return {{"step", ToJson(need.step)},
          {"capability", ToJson(need.capability)},
          {"inherited_through", ToArray(need.inherited_through)}};
}

json ToJson(const Parameter& parameter) {
  json value = {{"name", parameter.name},
                {"type", parameter.type},
                {"value", parameter.value},
                {"text", parameter.text},
                {"source", ToString(parameter.source)},
                {"origin", ToJsonOrNull(parameter.origin)}};
  if (!parameter.unit.empty()) value["unit"] = parameter.unit;
  if (!parameter.frame.empty()) value["frame"] = parameter.frame;
  return value;
}

json ToJson(const State& state) {
  if (state.kind == State::Kind::kEnd) {
    return {{"id", state.id}, {"label", state.label}, {"kind", "end"}, {"success", state.success}};
  }
  return {{"id", state.id},
          {"label", state.label},
          {"kind", "skill"},
          {"step", ToJson(state.step)},
          {"action", ToJson(state.action)},
          {"skill", state.skill},
          {"skill_template", state.skill_template},
          {"rada_distance", state.rada_distance},
          {"inputs", ToArray(state.inputs)},
          {"outputs", json(state.outputs)},
          {"outcomes", state.outcomes}};
}

json ToJson(const Transition& transition) {
  json value = {{"from", transition.from},
                {"outcome", transition.outcome},
                {"to", transition.to},
                {"added", transition.added}};
  if (!transition.reason.empty()) value["reason"] = transition.reason;
  return value;
}

json ToJson(const Choice& choice) {
  return {{"step", ToJson(choice.step)}, {"templates", ToArray(choice.templates)}};
}

}  // namespace

json ToJson(const MatchReport& report) {
  return {{"task", ToJson(report.task)},
          {"robot", ToJson(report.robot)},
          {"feasible", report.feasible},
          {"needs", ToArray(report.needs)},
          {"capabilities", ToArray(report.capabilities)},
          {"smallest_repair", ToArray(report.smallest_repair)},
          {"warnings", report.warnings}};
}

json ToJson(const Plan& plan) {
  json environment = nullptr;
  if (!plan.environment.empty()) {
    environment = {{"id", plan.environment}, {"version", plan.environment_version}};
  }
  return {{"format", "lares-plan"},         {"format_version", 1},
          {"task", ToJson(plan.task)},      {"robot", ToJson(plan.robot)},
          {"environment", environment},     {"start", plan.start},
          {"states", ToArray(plan.states)}, {"transitions", ToArray(plan.transitions)},
          {"unordered", plan.unordered},    {"notes", plan.notes},
          {"match", ToJson(plan.match)}};
}

json ToJson(const PlanResult& result) {
  return {{"plan", result.plan ? ToJson(*result.plan) : json(nullptr)},
          {"match", ToJson(result.match)},
          {"choices", ToArray(result.choices)},
          {"problems", result.problems}};
}

}  // namespace lares::recipes
