// A small interpreter of the part of BehaviorTree.CPP v4 that plans are written in.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lares::testing {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;
  std::string text;
};
// Well-formed documents without DTD or CDATA; throws std::runtime_error otherwise.
XmlElement ParseXml(const std::string& text);

enum class TickStatus { kSuccess, kFailure, kRunning };

// Runs `<root>`'s main tree to its end. A node that is none of the built-in ones is a skill:
// `run(state name)` gives its outcome; like real skills it fails when that is "failed".
class BehaviorTree {
 public:
  using Run = std::function<std::string(const std::string& state)>;
  BehaviorTree(const std::string& xml, Run run);
  // kSuccess or kFailure; kRunning when `max_ticks` did not suffice.
  TickStatus RunToEnd(int max_ticks);

 private:
  TickStatus Tick(const XmlElement& element);
  TickStatus RunSkill(const XmlElement& element);
  std::string Evaluate(const std::string& code);

  XmlElement root_;
  Run run_;
  std::map<std::string, std::string> blackboard_;
};

}  // namespace lares::testing
