#include "recipes/plan/diff.h"

#include <algorithm>
#include <functional>
#include <map>

#include "base/text.h"
#include "recipes/plan/diff_entries.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {
namespace {

using Kind = Difference::Kind;

std::string Head(const Plan& plan) {
  std::string head = plan.task.label + " for " + plan.robot.label;
  if (!plan.environment.empty()) {
    head +=
        " in " + plan.environment + " (version " + std::to_string(plan.environment_version) + ")";
  }
  return head;
}

class Comparison {
 public:
  // A single value; `exact` where the text for people says less.
  void Value(Kind kind, const std::string& step, const DiffSide& a, const DiffSide& b,
             bool same_otherwise = true) {
    if (a.value == b.value && same_otherwise) return;
    found_.push_back({kind, step, "", a, b});
  }
  void Text(Kind kind, const std::string& step, const std::string& a, const std::string& b) {
    Value(kind, step, {a, ""}, {b, ""});
  }

  // In the order of a, then what is only in b. Of several with one key the n-th stands for the
  // n-th.
  void Lists(Kind kind, const std::string& step, const Entries& a, const Entries& b) {
    std::vector<bool> used(b.size(), false);
    for (const Entry& entry : a) {
      std::size_t other = 0;
      while (other < b.size() && (used[other] || b[other].key != entry.key)) ++other;
      if (other == b.size()) {
        found_.push_back({kind, step, entry.name, entry.side, {}});
        continue;
      }
      used[other] = true;
      if (b[other].exact != entry.exact) {
        Difference difference{kind, step, entry.name, entry.side, b[other].side};
        if (entry.side.value == b[other].side.value && entry.side.why == b[other].side.why) {
          difference.a.why = entry.fuller;
          difference.b.why = b[other].fuller;
        }
        found_.push_back(std::move(difference));
      }
    }
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (!used[i]) found_.push_back({kind, step, b[i].name, {}, b[i].side});
    }
  }

  std::vector<Difference> Take() { return std::move(found_); }

 private:
  std::vector<Difference> found_;
};

// Which state of the other plan stands for which of this one.
class Pairs {
 public:
  Pairs(const Plan& a, const Plan& b) {
    for (const State& state : a.states) {
      if (FindState(b, state.id) != nullptr) Pair(state.id, state.id);
    }
    for (const State& state : a.states) {
      if (b_of_.count(state.id) > 0 || state.step.iri.empty()) continue;
      const State* other = TheOnly(b, state.step.iri, a_of_);
      if (other != nullptr && TheOnly(a, state.step.iri, b_of_) == &state) {
        Pair(state.id, other->id);
      }
    }
  }

  const State* InB(const Plan& b, const std::string& id) const {
    const auto found = b_of_.find(id);
    return found == b_of_.end() ? nullptr : FindState(b, found->second);
  }
  bool HasA(const std::string& id_in_b) const { return a_of_.count(id_in_b) > 0; }
  // The id in plan a of a state of b; b's own where a has none.
  std::string IdInA(const std::string& id_in_b) const {
    const auto found = a_of_.find(id_in_b);
    return found == a_of_.end() ? id_in_b : found->second;
  }

 private:
  void Pair(const std::string& a, const std::string& b) {
    b_of_[a] = b;
    a_of_[b] = a;
  }
  static const State* TheOnly(const Plan& plan, const std::string& step,
                              const std::map<std::string, std::string>& taken) {
    const State* only = nullptr;
    for (const State& state : plan.states) {
      if (state.step.iri != step || taken.count(state.id) > 0) continue;
      if (only != nullptr) return nullptr;
      only = &state;
    }
    return only;
  }
  std::map<std::string, std::string> b_of_;
  std::map<std::string, std::string> a_of_;
};

std::string DescribeKind(const State& state) {
  if (state.kind == State::Kind::kSkill) return "a skill";
  if (state.kind == State::Kind::kParallel) return "steps side by side";
  return state.success ? "a successful end" : "an end without success";
}

std::string DescribeStep(const State& state) {
  if (state.kind == State::Kind::kSkill) return state.skill;
  if (state.kind == State::Kind::kEnd) return DescribeKind(state);
  return "side by side: " + Join(state.members, ", ");
}

// How near the template is to what the step asks for.
std::string TemplateReason(const State& state) {
  if (state.kind != State::Kind::kSkill) return "";
  std::string reason = "a template for " + NameOf(state.action);
  reason += state.rada_distance == 0
                ? ", the step's own action"
                : ", " + std::to_string(state.rada_distance) +
                      (state.rada_distance == 1 ? " edge" : " edges") + " above the step";
  return reason;
}

std::string Retries(const State& state) {
  if (state.kind != State::Kind::kSkill) return "";
  return state.retries == 0 ? "none" : std::to_string(state.retries);
}

std::string TimeLimit(const State& state) {
  if (state.kind != State::Kind::kSkill) return "";
  return state.time_limit_s > 0 ? NumberText(state.time_limit_s) + " s" : "none";
}

Entries WayEntries(const Plan& plan, const std::string& id,
                   const std::function<std::string(const std::string&)>& id_in_a) {
  Entries entries;
  for (const Transition& transition : plan.transitions) {
    if (transition.from != id) continue;
    const std::string exact =
        Join({id_in_a(transition.to), transition.added ? "added" : "", transition.reason}, "\n");
    std::string why = transition.added ? "added: " + transition.reason : "the recipe says so";
    entries.push_back({transition.outcome, transition.outcome, exact, {transition.to, why}});
  }
  return entries;
}

void CompareSkills(const State& a, const State& b, Comparison& found) {
  const std::string& step = a.id;
  found.Value(Kind::kSkill, step, {a.skill, TemplateReason(a)}, {b.skill, TemplateReason(b)});
  const bool same_choice = a.rada_distance == b.rada_distance && a.action == b.action;
  found.Value(Kind::kTemplate, step, {a.skill_template, TemplateReason(a)},
              {b.skill_template, TemplateReason(b)}, same_choice);
  found.Lists(Kind::kParameter, step, InputEntries(a), InputEntries(b));
  found.Lists(Kind::kOutput, step, OutputEntries(a), OutputEntries(b));
  found.Text(Kind::kRetries, step, Retries(a), Retries(b));
  found.Text(Kind::kTimeLimit, step, TimeLimit(a), TimeLimit(b));
  found.Text(Kind::kTreeFragment, step, a.tree_fragment, b.tree_fragment);
  found.Lists(Kind::kClaims, step, ClaimEntries(a), ClaimEntries(b));
  found.Lists(Kind::kPrecondition, step, FluentEntries(a.preconditions),
              FluentEntries(b.preconditions));
  found.Lists(Kind::kEffect, step, EffectEntries(a.effects), EffectEntries(b.effects));
}

void CompareStates(const Plan& plan_a, const Plan& plan_b, const State& a, const State& b,
                   const Pairs& pairs, Comparison& found) {
  const auto same = [](const std::string& id) { return id; };
  const auto in_a = [&](const std::string& id) { return pairs.IdInA(id); };
  const bool same_words = a.id == b.id && a.label == b.label && a.step == b.step;
  found.Value(Kind::kStep, a.id, {Join({a.id, a.label}, ": "), NameOf(a.step)},
              {Join({b.id, b.label}, ": "), NameOf(b.step)}, same_words);
  found.Text(Kind::kKind, a.id, DescribeKind(a), DescribeKind(b));
  CompareSkills(a, b, found);
  found.Text(Kind::kOutcomes, a.id, Join(a.outcomes, ", "), Join(b.outcomes, ", "));
  found.Text(Kind::kParallel, a.id, a.parallel, b.parallel.empty() ? "" : in_a(b.parallel));
  found.Text(Kind::kMembers, a.id, Join(a.members, ", "), Listed(b.members, in_a));
  found.Lists(Kind::kTransition, a.id, WayEntries(plan_a, a.id, same),
              WayEntries(plan_b, b.id, in_a));
}

// What a step that is in one plan only brings with it is that plan's own.
void CompareSteps(const Plan& a, const Plan& b, Comparison& found) {
  const Pairs pairs(a, b);
  for (const State& state : a.states) {
    if (const State* other = pairs.InB(b, state.id)) {
      CompareStates(a, b, state, *other, pairs, found);
    } else {
      found.Value(Kind::kStep, state.id, {DescribeStep(state), TemplateReason(state)}, {});
    }
  }
  for (const State& state : b.states) {
    if (pairs.HasA(state.id)) continue;
    found.Value(Kind::kStep, state.id, {}, {DescribeStep(state), TemplateReason(state)});
  }
  found.Value(Kind::kStart, "", {a.start, ""}, {pairs.IdInA(b.start), ""});
}

std::string Environment(const Plan& plan) {
  if (plan.environment.empty()) return "";
  return plan.environment + " (version " + std::to_string(plan.environment_version) + ")";
}

void CompareWholes(const Plan& a, const Plan& b, Comparison& found) {
  found.Value(Kind::kTask, "", {NameOf(a.task), a.task.iri}, {NameOf(b.task), b.task.iri},
              a.task == b.task && a.match.task == b.match.task);
  found.Value(Kind::kRobot, "", {NameOf(a.robot), a.robot.iri}, {NameOf(b.robot), b.robot.iri},
              a.robot == b.robot && a.match.robot == b.match.robot);
  found.Text(Kind::kEnvironment, "", Environment(a), Environment(b));
  found.Lists(Kind::kSetting, "", SettingEntries(a), SettingEntries(b));
  found.Lists(Kind::kAssumption, "", FluentEntries(a.assumptions), FluentEntries(b.assumptions));
  found.Lists(Kind::kDone, "", TextEntries(a.done), TextEntries(b.done));
  found.Lists(Kind::kGiven, "", TextEntries(a.given), TextEntries(b.given));
  const auto group = [](const std::vector<std::string>& steps) { return Join(steps, ", "); };
  std::vector<std::string> groups_a, groups_b;
  for (const auto& steps : a.unordered) groups_a.push_back(group(steps));
  for (const auto& steps : b.unordered) groups_b.push_back(group(steps));
  found.Lists(Kind::kUnordered, "", TextEntries(groups_a), TextEntries(groups_b));
  found.Lists(Kind::kNeed, "", NeedEntries(a), NeedEntries(b));
  found.Lists(Kind::kAvailability, "", FindingEntries(a), FindingEntries(b));
  found.Lists(Kind::kRequirement, "", RequirementEntries(a), RequirementEntries(b));
  found.Lists(Kind::kDownload, "", DownloadEntries(a), DownloadEntries(b));
  found.Lists(Kind::kNote, "", TextEntries(a.notes), TextEntries(b.notes));
  found.Lists(Kind::kNote, "", TextEntries(a.match.warnings), TextEntries(b.match.warnings));
}

}  // namespace

std::string_view ToString(Difference::Kind kind) {
  static constexpr std::string_view kNames[] = {
      "task",      "robot",        "environment", "setting",  "start",        "assumption",
      "done",      "given",        "unordered",   "need",     "availability", "requirement",
      "download",  "note",         "step",        "kind",     "skill",        "template",
      "parameter", "output",       "outcomes",    "retries",  "time-limit",   "tree-fragment",
      "claims",    "precondition", "effect",      "parallel", "members",      "transition"};
  return kNames[static_cast<std::size_t>(kind)];
}

PlanDiff DiffPlans(const Plan& a, const Plan& b) {
  Comparison found;
  CompareWholes(a, b, found);
  CompareSteps(a, b, found);
  PlanDiff diff{Head(a), Head(b), found.Take()};
  std::stable_sort(
      diff.differences.begin(), diff.differences.end(),
      [](const Difference& x, const Difference& y) { return x.step.empty() && !y.step.empty(); });
  return diff;
}

}  // namespace lares::recipes
