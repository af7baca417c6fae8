// What differs between two plans, and why.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// One side of a difference.
struct DiffSide {
  std::string value;  // for people; empty when this plan has no such thing
  std::string why;    // where the value comes from; empty when the plan does not say
};

struct Difference {
  // Of the whole plan: the task, the robot, the environment, a setting, where it starts, what it
  // assumes, leaves out or is given, notes. Of a step: everything else.
  enum class Kind {
    kTask,
    kRobot,
    kEnvironment,
    kSetting,
    kStart,
    kAssumption,
    kDone,
    kGiven,
    kUnordered,
    kNeed,          // a capability that a step needs
    kAvailability,  // of a capability
    kRequirement,   // numbers that steps require of a part
    kDownload,      // what is to be fetched first
    kNote,
    kStep,  // it is in one plan only
    kKind,
    kSkill,
    kTemplate,
    kParameter,
    kOutput,
    kOutcomes,
    kRetries,
    kTimeLimit,
    kTreeFragment,
    kClaims,
    kPrecondition,
    kEffect,
    kParallel,    // what runs it side by side with others
    kMembers,     // of what runs side by side
    kTransition,  // where an outcome leads
  };
  Kind kind = Kind::kTask;
  std::string step;  // the step's id in plan a, or in b when it is only there; empty: of the plan
  std::string name;  // of the parameter, outcome, setting, capability, …; may be empty
  DiffSide a;
  DiffSide b;
};
std::string_view ToString(Difference::Kind kind);  // "robot", "time-limit", …

struct PlanDiff {
  std::string a;  // "SearchForCup for scout in flat (version 1)"
  std::string b;
  std::vector<Difference> differences;  // of the plan first, then step by step in the order of a
};

// Steps are the same when their ids are, or when they are the only ones of the same recipe step.
// Equal plans have no differences, and what can be told apart in JSON is one; the order of states
// and transitions is none, nor are repairs, which a match that has a plan does not need.
PlanDiff DiffPlans(const Plan& a, const Plan& b);

// Follows docs/schemas/plan-diff.schema.json.
nlohmann::json ToJson(const PlanDiff& diff);
// For a terminal.
std::string ToText(const PlanDiff& diff);

}  // namespace lares::recipes
