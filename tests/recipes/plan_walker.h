// A plan's JSON walked, without a behaviour tree and without the project's own code: what the
// document says is all it knows.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/recipes/skill_run.h"

namespace lares::testing {

// How the n-th attempt (from 0) of a state goes. Always the same for the same question.
using SkillScript = std::function<SkillAttempt(const std::string& state, int attempt)>;

struct PlanWalk {
  std::vector<SkillEvent> events;
  bool ended = false;  // else `max_starts` attempts have been made and one more was to come
  bool success = false;
};

// States one after another: each skill is tried once and `retries` times more while it fails, each
// attempt for `time_limit_s` at most; `members` run side by side until all have succeeded or one
// has failed, which halts the others. What a tree_fragment says is said instead of retries and
// limit. Time passes in ticks of kTick_ms: what falls due is seen in the next one, what has failed
// in the tick in which it began is tried again in the next.
PlanWalk WalkPlan(const nlohmann::json& plan, const SkillScript& script, std::size_t max_starts);

}  // namespace lares::testing
