// A small interpreter of the part of BehaviorTree.CPP v4 that plans are written in. It follows that
// library's sources (version 4.6), each named where it is followed; nothing is skipped here, as no
// node has a precondition.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/recipes/skill_run.h"
#include "tests/recipes/xml.h"

namespace lares::testing {

enum class TickStatus { kIdle, kSuccess, kFailure, kRunning };

class TreeNode;
struct TreeContext;

// Runs `<root>`'s main tree, ticked exactly once every 10 ms of a simulated clock
// (Tree::tickExactlyOnce in a loop of the caller). A node that is none of the built-in ones must be
// in TreeNodesModel and is a skill: `start` says how an attempt of it goes; like real skills it
// fails when its outcome is "failed". Throws std::runtime_error for what the library would refuse.
class BehaviorTree {
 public:
  BehaviorTree(const std::string& xml, StartSkill start);
  ~BehaviorTree();
  // kSuccess or kFailure; kRunning when `max_ticks` did not suffice.
  TickStatus RunToEnd(int max_ticks);
  // What the skills did.
  const std::vector<SkillEvent>& events() const;

 private:
  std::unique_ptr<TreeContext> context_;
  XmlElement root_;  // the nodes refer to it
  std::unique_ptr<TreeNode> tree_;
};

}  // namespace lares::testing
