// How skills go in tests: what is decided beforehand, and what happened.
#pragma once

#include <functional>
#include <string>

namespace lares::testing {

constexpr int kTick_ms = 10;

// One attempt of a skill.
struct SkillAttempt {
  std::string outcome;
  int duration_ms = 0;        // it ends in the first tick when that time is over; 0: in its first
  std::string early_outcome;  // written when it starts, as a skill should not do; empty: nothing
};
// Asked when an attempt starts.
using StartSkill = std::function<SkillAttempt(const std::string& state)>;

struct SkillEvent {
  enum class Kind { kStart, kEnd, kHalt } kind = Kind::kStart;
  std::string state;
  std::string outcome;  // of kEnd
  friend bool operator==(const SkillEvent&, const SkillEvent&) = default;
};

}  // namespace lares::testing
