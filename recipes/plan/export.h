// A plan as text.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "recipes/plan/plan.h"

namespace lares::recipes {

nlohmann::json ToJson(const MatchReport& report);
// Follows docs/schemas/plan.schema.json.
nlohmann::json ToJson(const Plan& plan);
// What ToJson(Plan) wrote: PlanFromJson(ToJson(plan)) is the plan. Strict and bounded; throws
// kInvalid naming the JSON pointer: "/states/0/kind must be one of skill, parallel, end". Says
// nothing of whether the plan is a sound one: CheckPlan does.
Plan PlanFromJson(const nlohmann::json& value);
// The same for a PlanResult without a plan: match, choices, problems.
nlohmann::json ToJson(const PlanResult& result);

// BehaviorTree.CPP v4: <root BTCPP_format="4">, one tree, TreeNodesModel with every skill's ports.
std::string ToBehaviorTreeXml(const Plan& plan);
// PDDL: the plan's graph as a grounded planning problem, in which each outcome of each state is an
// action. STRIPS with typing and negative preconditions. A plan found in it is a way through the
// graph from the start to a successful end on which every precondition holds; actions are called
// STATE__OUTCOME.
std::string ToPddlDomain(const Plan& plan);
std::string ToPddlProblem(const Plan& plan);
// Graphviz.
std::string ToDot(const Plan& plan);
// For a terminal.
std::string ToText(const Plan& plan);
// For a terminal: which step needs what, what lacks, the smallest repair.
std::string ToText(const MatchReport& report);

}  // namespace lares::recipes
