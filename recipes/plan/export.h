// A plan as text.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "recipes/plan/plan.h"

namespace lares::recipes {

nlohmann::json ToJson(const MatchReport& report);
// Follows docs/schemas/plan.schema.json.
nlohmann::json ToJson(const Plan& plan);
// The same for a PlanResult without a plan: match, choices, problems.
nlohmann::json ToJson(const PlanResult& result);

// BehaviorTree.CPP v4: <root BTCPP_format="4">, one tree, TreeNodesModel with every skill's ports.
std::string ToBehaviorTreeXml(const Plan& plan);
// Graphviz.
std::string ToDot(const Plan& plan);
// For a terminal.
std::string ToText(const Plan& plan);
// For a terminal: which step needs what, what lacks, the smallest repair.
std::string ToText(const MatchReport& report);

}  // namespace lares::recipes
