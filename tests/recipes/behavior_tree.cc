#include "tests/recipes/behavior_tree.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

#include "tests/recipes/script.h"

namespace lares::testing {

struct Timer {
  long long time_ms = 0;
  const void* owner = nullptr;
  std::function<void()> fire;
};

// What the nodes of one tree share.
struct TreeContext {
  StartSkill start;
  long long now_ms = 0;
  std::vector<Timer> timers;  // in the order in which they were set
  std::map<std::string, std::string> blackboard;
  std::map<std::string, std::set<std::string>> ports;  // of each skill
  std::vector<SkillEvent> events;

  void Cancel(const void* owner) {
    std::erase_if(timers, [&](const Timer& timer) { return timer.owner == owner; });
  }
  // What falls due until the next tick, in order. (utils/timer_queue.h: a thread that waits.)
  void Advance(long long until_ms) {
    for (;;) {
      const auto next = std::min_element(timers.begin(), timers.end(),
                                         [](auto& a, auto& b) { return a.time_ms < b.time_ms; });
      if (next == timers.end() || next->time_ms > until_ms) break;
      now_ms = next->time_ms;
      const auto fire = next->fire;
      timers.erase(next);
      fire();
    }
    now_ms = until_ms;
  }
};

// tree_node.cpp: executeTick keeps what tick() gave; haltNode calls halt().
class TreeNode {
 public:
  TreeNode(TreeContext& context, const XmlElement& element)
      : context_(context), element_(element) {}
  virtual ~TreeNode() = default;

  TickStatus ExecuteTick() { return status_ = Tick(); }
  // What resetChild and resetChildren do with one child (decorator_node.cpp, control_node.cpp).
  void Reset() {
    if (status_ == TickStatus::kRunning) Halt();
    status_ = TickStatus::kIdle;
  }
  TickStatus status() const { return status_; }

  std::vector<std::unique_ptr<TreeNode>> children;

 protected:
  virtual TickStatus Tick() = 0;
  virtual void Halt() { ResetChildren(); }

  void ResetChildren() {
    for (auto& child : children) child->Reset();
  }
  TreeNode& child() { return *children.front(); }
  const std::string& Attribute(const std::string& name) const {
    return element_.attributes.at(name);
  }
  int Number(const std::string& name) const {
    const std::string& text = Attribute(name);
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw std::runtime_error(name + " is no whole number: " + text);
    }
    return number;
  }

  TreeContext& context_;
  const XmlElement& element_;
  TickStatus status_ = TickStatus::kIdle;
};

namespace {

bool Completed(TickStatus status) {
  return status == TickStatus::kSuccess || status == TickStatus::kFailure;
}

// controls/sequence_node.cpp and controls/fallback_node.cpp: both go on at the child that was
// running, and begin anew once they have ended.
class MemoryNode : public TreeNode {
 public:
  MemoryNode(TreeContext& context, const XmlElement& element, TickStatus goes_on)
      : TreeNode(context, element), goes_on_(goes_on) {}

 private:
  TickStatus Tick() override {
    while (at_ < children.size()) {
      const TickStatus status = children[at_]->ExecuteTick();
      if (status == TickStatus::kRunning) return status;
      if (status != goes_on_) return End(status);
      ++at_;
    }
    return End(goes_on_);
  }
  TickStatus End(TickStatus status) {
    ResetChildren();
    at_ = 0;
    return status;
  }
  void Halt() override {
    at_ = 0;
    TreeNode::Halt();
  }

  const TickStatus goes_on_;
  std::size_t at_ = 0;
};

// controls/parallel_node.cpp: children that have ended are not ticked again; both thresholds are
// looked at after each child, and a negative one counts from the number of children.
class ParallelNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  std::size_t Threshold(const std::string& name) const {
    const int number = Number(name);
    const int count = static_cast<int>(children.size());
    return static_cast<std::size_t>(number < 0 ? std::max(count + number + 1, 0) : number);
  }
  TickStatus Tick() override {
    const std::size_t needed = Threshold("success_count");
    const std::size_t fatal = Threshold("failure_count");
    if (children.size() < needed || children.size() < fatal) {
      throw std::runtime_error("Parallel has fewer children than its threshold");
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (completed_.count(i) == 0) {
        const TickStatus status = children[i]->ExecuteTick();
        if (Completed(status)) completed_.insert(i);
        successes_ += status == TickStatus::kSuccess;
        failures_ += status == TickStatus::kFailure;
      }
      if (successes_ >= needed) return End(TickStatus::kSuccess);
      if (children.size() - failures_ < needed || failures_ == fatal) {
        return End(TickStatus::kFailure);
      }
    }
    return TickStatus::kRunning;
  }
  TickStatus End(TickStatus status) {
    Clear();
    ResetChildren();
    return status;
  }
  void Halt() override {
    Clear();
    TreeNode::Halt();
  }
  void Clear() {
    completed_.clear();
    successes_ = failures_ = 0;
  }

  std::set<std::size_t> completed_;
  std::size_t successes_ = 0;
  std::size_t failures_ = 0;
};

// decorators/force_success_node.h
class ForceSuccessNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    const TickStatus status = child().ExecuteTick();
    if (!Completed(status)) return status;
    child().Reset();
    return TickStatus::kSuccess;
  }
};

// decorators/keep_running_until_failure_node.h
class KeepRunningNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    const TickStatus status = child().ExecuteTick();
    if (Completed(status)) child().Reset();
    return status == TickStatus::kFailure ? status : TickStatus::kRunning;
  }
};

// decorators/retry_node.cpp: tries again at once when the attempt took time, and in the next tick
// when it failed in the very tick in which it began.
class RetryNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    const int attempts = Number("num_attempts");
    bool goes_on = tried_ < attempts || attempts == -1;
    while (goes_on) {
      const TickStatus before = child().status();
      const TickStatus status = child().ExecuteTick();
      if (status == TickStatus::kRunning) return status;
      child().Reset();
      if (status == TickStatus::kSuccess) {
        tried_ = 0;
        return status;
      }
      ++tried_;
      goes_on = tried_ < attempts || attempts == -1;
      if (before == TickStatus::kIdle && goes_on) return TickStatus::kRunning;
    }
    tried_ = 0;
    return TickStatus::kFailure;
  }
  void Halt() override {
    tried_ = 0;
    TreeNode::Halt();
  }

  int tried_ = 0;
};

// decorators/timeout_node.cpp: the timer halts the child; the next tick says FAILURE.
class TimeoutNode : public TreeNode {
 public:
  using TreeNode::TreeNode;
  ~TimeoutNode() override { context_.Cancel(this); }

 private:
  TickStatus Tick() override {
    if (!started_) {
      started_ = true;
      child_halted_ = false;
      const int limit_ms = Number("msec");
      if (limit_ms > 0) {
        context_.timers.push_back({context_.now_ms + limit_ms, this, [this] { Fire(); }});
      }
    }
    if (child_halted_) {
      started_ = false;
      return TickStatus::kFailure;
    }
    const TickStatus status = child().ExecuteTick();
    if (Completed(status)) {
      started_ = false;
      context_.Cancel(this);
      child().Reset();
    }
    return status;
  }
  void Fire() {
    if (child().status() != TickStatus::kRunning) return;
    child_halted_ = true;
    child().Reset();
  }
  void Halt() override {
    started_ = false;
    context_.Cancel(this);
    TreeNode::Halt();
  }

  bool started_ = false;
  bool child_halted_ = false;
};

// decorators/delay_node.cpp
class DelayNode : public TreeNode {
 public:
  using TreeNode::TreeNode;
  ~DelayNode() override { context_.Cancel(this); }

 private:
  TickStatus Tick() override {
    if (!started_) {
      started_ = true;
      complete_ = false;
      context_.timers.push_back(
          {context_.now_ms + Number("delay_msec"), this, [this] { complete_ = true; }});
    }
    if (!complete_) return TickStatus::kRunning;
    const TickStatus status = child().ExecuteTick();
    if (Completed(status)) {
      started_ = false;
      child().Reset();
    }
    return status;
  }
  void Halt() override {
    started_ = false;
    context_.Cancel(this);
    TreeNode::Halt();
  }

  bool started_ = false;
  bool complete_ = false;
};

// actions/script_node.h
class ScriptNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    RunScript(Attribute("code"), context_.blackboard);
    return TickStatus::kSuccess;
  }
};

// actions/script_condition.h
class ScriptConditionNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    const bool holds = RunScript(Attribute("code"), context_.blackboard) == "true";
    return holds ? TickStatus::kSuccess : TickStatus::kFailure;
  }
};

// action_node.cpp, StatefulActionNode: onStart when it was idle, onRunning when it was running,
// onHalted when it is halted while running.
class SkillNode : public TreeNode {
 public:
  using TreeNode::TreeNode;

 private:
  TickStatus Tick() override {
    if (status_ != TickStatus::kRunning) {
      attempt_ = context_.start(State());
      ends_ms_ = context_.now_ms + attempt_.duration_ms;
      context_.events.push_back({SkillEvent::Kind::kStart, State(), ""});
      if (!attempt_.early_outcome.empty()) WriteOutcome(attempt_.early_outcome);
    }
    if (context_.now_ms < ends_ms_) return TickStatus::kRunning;
    context_.events.push_back({SkillEvent::Kind::kEnd, State(), attempt_.outcome});
    WriteOutcome(attempt_.outcome);
    return attempt_.outcome == "failed" ? TickStatus::kFailure : TickStatus::kSuccess;
  }
  void Halt() override { context_.events.push_back({SkillEvent::Kind::kHalt, State(), ""}); }
  const std::string& State() const { return Attribute("name"); }
  void WriteOutcome(const std::string& outcome) {
    const std::string& port = Attribute("outcome");
    context_.blackboard[port.substr(1, port.size() - 2)] = outcome;
  }

  SkillAttempt attempt_;
  long long ends_ms_ = 0;
};

// What the library knows, and what it takes.
struct BuiltIn {
  std::set<std::string> attributes;  // all of them needed, apart from "name"
  std::size_t least_children = 0;
  std::size_t most_children = 0;
};
constexpr std::size_t kAny = 100'000;
const std::map<std::string, BuiltIn>& BuiltIns() {
  static const std::map<std::string, BuiltIn> known = {
      {"Sequence", {{}, 1, kAny}},
      {"Fallback", {{}, 1, kAny}},
      {"Parallel", {{"success_count", "failure_count"}, 1, kAny}},
      {"ForceSuccess", {{}, 1, 1}},
      {"KeepRunningUntilFailure", {{}, 1, 1}},
      {"RetryUntilSuccessful", {{"num_attempts"}, 1, 1}},
      {"Timeout", {{"msec"}, 1, 1}},
      {"Delay", {{"delay_msec"}, 1, 1}},
      {"Script", {{"code"}, 0, 0}},
      {"ScriptCondition", {{"code"}, 0, 0}}};
  return known;
}

void CheckBuiltIn(const XmlElement& element, const BuiltIn& built_in) {
  const auto refuse = [&](const std::string& what) {
    throw std::runtime_error("<" + element.name + "> " + what);
  };
  for (const std::string& name : built_in.attributes) {
    if (element.attributes.count(name) == 0) refuse("lacks " + name);
  }
  for (const auto& [name, value] : element.attributes) {
    if (name != "name" && built_in.attributes.count(name) == 0) refuse("has no port " + name);
  }
  const std::size_t count = element.children.size();
  if (count < built_in.least_children || count > built_in.most_children) {
    refuse("has the wrong number of children");
  }
}

void CheckSkill(const XmlElement& element, const TreeContext& context) {
  const auto ports = context.ports.find(element.name);
  if (ports == context.ports.end()) throw std::runtime_error("no node " + element.name);
  if (!element.children.empty()) throw std::runtime_error(element.name + " has children");
  for (const auto& [name, value] : element.attributes) {
    if (name != "name" && ports->second.count(name) == 0) {
      throw std::runtime_error(element.name + " has no port " + name);
    }
  }
  const std::string& outcome = element.attributes.at("outcome");
  if (outcome.size() < 3 || outcome.front() != '{' || outcome.back() != '}') {
    throw std::runtime_error("an output port must name a blackboard entry: " + outcome);
  }
}

template <typename Node>
std::unique_ptr<TreeNode> Make(TreeContext& context, const XmlElement& element) {
  return std::make_unique<Node>(context, element);
}

std::unique_ptr<TreeNode> MakeNode(TreeContext& context, const XmlElement& element) {
  if (element.name == "Sequence") {
    return std::make_unique<MemoryNode>(context, element, TickStatus::kSuccess);
  }
  if (element.name == "Fallback") {
    return std::make_unique<MemoryNode>(context, element, TickStatus::kFailure);
  }
  static const std::map<std::string, std::unique_ptr<TreeNode> (*)(TreeContext&, const XmlElement&)>
      makers = {{"Parallel", Make<ParallelNode>},
                {"ForceSuccess", Make<ForceSuccessNode>},
                {"KeepRunningUntilFailure", Make<KeepRunningNode>},
                {"RetryUntilSuccessful", Make<RetryNode>},
                {"Timeout", Make<TimeoutNode>},
                {"Delay", Make<DelayNode>},
                {"Script", Make<ScriptNode>},
                {"ScriptCondition", Make<ScriptConditionNode>}};
  const auto maker = makers.find(element.name);
  return maker == makers.end() ? Make<SkillNode>(context, element)
                               : maker->second(context, element);
}

std::unique_ptr<TreeNode> Build(TreeContext& context, const XmlElement& element) {
  const auto built_in = BuiltIns().find(element.name);
  if (built_in == BuiltIns().end()) {
    CheckSkill(element, context);
  } else {
    CheckBuiltIn(element, built_in->second);
  }
  auto node = MakeNode(context, element);
  for (const XmlElement& child : element.children) {
    node->children.push_back(Build(context, child));
  }
  return node;
}

const XmlElement& FindTree(const XmlElement& root, const std::string& id) {
  for (const XmlElement& child : root.children) {
    if (child.name == "BehaviorTree" && child.attributes.at("ID") == id) return child;
  }
  throw std::runtime_error("no tree " + id);
}

void ReadModels(const XmlElement& root, TreeContext& context) {
  for (const XmlElement& models : root.children) {
    if (models.name != "TreeNodesModel") continue;
    for (const XmlElement& model : models.children) {
      std::set<std::string>& ports = context.ports[model.attributes.at("ID")];
      for (const XmlElement& port : model.children) ports.insert(port.attributes.at("name"));
    }
  }
}

}  // namespace

BehaviorTree::BehaviorTree(const std::string& xml, StartSkill start)
    : context_(std::make_unique<TreeContext>()), root_(ParseXml(xml)) {
  if (root_.name != "root" || root_.attributes.at("BTCPP_format") != "4") {
    throw std::runtime_error("no BehaviorTree.CPP v4 document");
  }
  context_->start = std::move(start);
  ReadModels(root_, *context_);
  const XmlElement& tree = FindTree(root_, root_.attributes.at("main_tree_to_execute"));
  if (tree.children.size() != 1) throw std::runtime_error("a tree has one root");
  tree_ = Build(*context_, tree.children.front());
}

BehaviorTree::~BehaviorTree() = default;

const std::vector<SkillEvent>& BehaviorTree::events() const { return context_->events; }

TickStatus BehaviorTree::RunToEnd(int max_ticks) {
  for (int tick = 0; tick < max_ticks; ++tick) {
    const TickStatus status = tree_->ExecuteTick();
    if (status != TickStatus::kRunning) return status;
    context_->Advance(context_->now_ms + kTick_ms);
  }
  return TickStatus::kRunning;
}

}  // namespace lares::testing
