// Questions about a plan's graph that checking and writing share.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// Where each outcome of each state leads; the first transition where there are several.
using Ways = std::map<std::string, std::map<std::string, std::string>>;
Ways WaysOf(const Plan& plan);

// The states that can be reached from `start`, itself included.
std::set<std::string> ReachableFrom(const Ways& ways, const std::string& start);

const State* FindState(const Plan& plan, const std::string& id);

// What runs in a state: itself, or the members of a parallel one.
std::vector<const State*> Running(const Plan& plan, const State& state);

// The skill and parallel states in a row, when the plan is no more than that: each goes on to the
// next on "succeeded", the last to a successful end, and everything else fails. Empty otherwise.
std::vector<const State*> LinearSteps(const Plan& plan);

// A C identifier: [A-Za-z_][A-Za-z0-9_]*.
bool IsCIdentifier(std::string_view text);
// "{key}" → "key"; empty for anything else.
std::string KeyOf(std::string_view value);

}  // namespace lares::recipes
