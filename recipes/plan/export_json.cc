#include <nlohmann/json.hpp>

#include "recipes/plan/export.h"
#include "recipes/plan/export_words.h"

namespace lares::recipes {

namespace {

using nlohmann::json;

json ToJson(const Resource& resource) {
  return {{"iri", resource.iri}, {"label", resource.label}, {"as_written", resource.as_written}};
}

// Declared before the template that calls them.
json ToJson(const Finding& finding);
json ToJson(const Measure& measure);
json ToJson(const Offer& offer);
json ToJson(const Download& download);
json ToJson(const StepRequirement& requirement);
json ToJson(const RepairItem& item);
json ToJson(const Repair& repair);
json ToJson(const Need& need);
json ToJson(const Parameter& parameter);
json ToJson(const State& state);
json ToJson(const Transition& transition);
json ToJson(const Choice& choice);
json ToJson(const Fluent& fluent);
json ToJson(const Effect& effect);
json ToJson(const Setting& setting);

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
  json value = {{"kind", finding.kind == Finding::Kind::kCapability ? "capability" : "component"},
                {"what", ToJson(finding.what)},
                {"availability", ToString(finding.availability)},
                {"asserted", finding.asserted},
                {"provided_by", ToArray(finding.provided_by)},
                {"dependencies", ToArray(finding.dependencies)},
                {"explanation", finding.explanation}};
  if (!finding.measures.empty()) value["measures"] = ToArray(finding.measures);
  if (!finding.downloads.empty()) value["downloads"] = ToArray(finding.downloads);
  return value;
}

json ToJson(const Measure& measure) {
  json required = json::object();
  if (measure.at_least) required["at_least"] = *measure.at_least;
  if (measure.at_most) required["at_most"] = *measure.at_most;
  json value = {{"quantity", ToJson(measure.quantity)},
                {"unit", measure.unit},
                {"required", required},
                {"actual", measure.actual ? json(*measure.actual) : json(nullptr)},
                {"verdict", ToString(measure.verdict)},
                {"stated_by", ToJson(measure.stated_by)}};
  if (measure.verdict == Measure::Verdict::kInsufficient) value["short_by"] = measure.short_by;
  if (measure.short_by_percent) value["short_by_percent"] = *measure.short_by_percent;
  return value;
}

json ToJson(const Offer& offer) {
  return {{"class", offer.class_iri},
          {"for", offer.for_what},
          {"document", offer.document},
          {"file", offer.file},
          {"link", offer.link},
          {"sha256", offer.sha256},
          {"size_bytes", offer.size_bytes}};
}

json ToJson(const Download& download) {
  return {{"what", ToJson(download.what)}, {"offer", ToJson(download.offer)}};
}

json ToJson(const StepRequirement& requirement) {
  return {{"steps", ToArray(requirement.steps)}, {"finding", ToJson(requirement.finding)}};
}

json ToJson(const RepairItem& item) {
  json value = {{"what", ToJson(item.what)}, {"cost", item.cost}, {"text", item.text}};
  for (const Measure& bound : item.bounds) {
    json limits = {{"quantity", ToJson(bound.quantity)}, {"unit", bound.unit}};
    if (bound.at_least) limits["at_least"] = *bound.at_least;
    if (bound.at_most) limits["at_most"] = *bound.at_most;
    value["bounds"].push_back(limits);
  }
  return value;
}

json ToJson(const Repair& repair) { return {{"add", ToArray(repair.add)}, {"cost", repair.cost}}; }

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

// What a state may have, left out where there is nothing to say.
void AddWhatItMayHave(const State& state, json& value) {
  if (!state.parallel.empty()) value["parallel"] = state.parallel;
  if (state.retries > 0) value["retries"] = state.retries;
  if (state.time_limit_s > 0) value["time_limit_s"] = state.time_limit_s;
  if (!state.tree_fragment.empty()) value["tree_fragment"] = state.tree_fragment;
  if (!state.claims.empty()) value["claims"] = ToArray(state.claims);
  if (!state.preconditions.empty()) value["preconditions"] = ToArray(state.preconditions);
  if (!state.effects.empty()) value["effects"] = ToArray(state.effects);
}

json ToJson(const State& state) {
  json value{{"id", state.id}, {"label", state.label}};
  if (state.kind == State::Kind::kEnd) {
    value["kind"] = "end";
    value["success"] = state.success;
    return value;
  }
  value["outcomes"] = state.outcomes;
  if (state.kind == State::Kind::kParallel) {
    value["kind"] = "parallel";
    value["members"] = state.members;
    return value;
  }
  value["kind"] = "skill";
  value["step"] = ToJson(state.step);
  value["action"] = ToJson(state.action);
  value["skill"] = state.skill;
  value["skill_template"] = state.skill_template;
  value["rada_distance"] = state.rada_distance;
  value["inputs"] = ToArray(state.inputs);
  value["outputs"] = json(state.outputs);
  AddWhatItMayHave(state, value);
  return value;
}

json ToJson(const Fluent& fluent) {
  json value{{"name", fluent.name}, {"holds", fluent.holds}};
  if (!fluent.argument.empty()) value["argument"] = fluent.argument;
  return value;
}

json ToJson(const Effect& effect) {
  return {{"outcome", effect.outcome}, {"fluent", ToJson(effect.fluent)}};
}

json ToJson(const Setting& setting) {
  json value{{"name", setting.name},
             {"type", setting.type},
             {"value", setting.value},
             {"text", setting.text},
             {"is_default", setting.is_default}};
  if (!setting.unit.empty()) value["unit"] = setting.unit;
  if (!setting.was.empty()) value["was"] = setting.was;
  return value;
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
          {"requirements", ToArray(report.requirements)},
          {"downloads", ToArray(report.downloads)},
          {"smallest_repair", ToArray(report.smallest_repair)},
          {"repairs", ToArray(report.repairs)},
          {"repair_is_smallest", report.repair_is_smallest},
          {"warnings", report.warnings}};
}

json ToJson(const Plan& plan) {
  json environment = nullptr;
  if (!plan.environment.empty()) {
    environment = {{"id", plan.environment}, {"version", plan.environment_version}};
  }
  json value{{"format", "lares-plan"},         {"format_version", 1},
             {"task", ToJson(plan.task)},      {"robot", ToJson(plan.robot)},
             {"environment", environment},     {"start", plan.start},
             {"states", ToArray(plan.states)}, {"transitions", ToArray(plan.transitions)},
             {"unordered", plan.unordered},    {"notes", plan.notes},
             {"match", ToJson(plan.match)}};
  if (!plan.settings.empty()) value["settings"] = ToArray(plan.settings);
  if (!plan.assumptions.empty()) value["assumptions"] = ToArray(plan.assumptions);
  if (!plan.done.empty()) value["done"] = plan.done;
  if (!plan.given.empty()) value["given"] = plan.given;
  return value;
}

json ToJson(const PlanResult& result) {
  return {{"plan", result.plan ? ToJson(*result.plan) : json(nullptr)},
          {"match", ToJson(result.match)},
          {"choices", ToArray(result.choices)},
          {"problems", result.problems}};
}

}  // namespace lares::recipes
