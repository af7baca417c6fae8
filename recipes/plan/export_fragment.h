// A skill template's own behaviour-tree decorators: nested elements around one "<Skill/>".
#pragma once

#include <string>
#include <vector>

namespace lares::recipes {

// One decorator of BehaviorTree.CPP v4 that leaves a skill's outcome its meaning: what is around
// the skill succeeds exactly when its last attempt did.
struct TreeDecorator {
  std::string name;       // "Timeout", "RetryUntilSuccessful", "Delay"
  std::string attribute;  // "msec", "num_attempts", "delay_msec"
  long long number = 0;
  friend bool operator==(const TreeDecorator&, const TreeDecorator&) = default;
};

struct TreeFragment {
  std::vector<TreeDecorator> decorators;  // outermost first
  std::vector<std::string> problems;      // one sentence each; with any there are no decorators
};
// `xml`: at most 4 096 bytes and 16 decorators, elements and white space only: no declarations,
// comments, entities or references. A Delay must leave time to a Timeout around it.
TreeFragment ParseTreeFragment(const std::string& xml);

// What is wrong with a fragment, one sentence for each problem; nothing when it can be used.
std::vector<std::string> TreeFragmentProblems(const std::string& xml);

}  // namespace lares::recipes
