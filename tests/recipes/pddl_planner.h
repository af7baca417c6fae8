// A small reader of grounded PDDL and a planner that finds a shortest plan.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lares::testing {

// Strict: what is no PDDL 1.2 with :strips, :typing and :negative-preconditions, a name that is not
// declared or declared twice, an argument of the wrong type, an action with parameters: each throws
// std::runtime_error.
struct PddlTask {
  struct Action {
    std::string name;
    std::set<std::string> needs;    // ground atoms, "(at-state s-a)"
    std::set<std::string> refuses;  // that must not hold
    std::set<std::string> adds;
    std::set<std::string> deletes;
  };
  std::vector<Action> actions;
  std::set<std::string> init;
  std::set<std::string> goal;
};
PddlTask ReadPddl(const std::string& domain, const std::string& problem);

// The names of the actions of a shortest plan; nothing when there is none. Breadth first.
std::optional<std::vector<std::string>> FindPddlPlan(const PddlTask& task);

}  // namespace lares::testing
