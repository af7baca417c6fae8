#include <algorithm>
#include <cctype>

#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

using Violations = std::vector<std::string>;

std::string Quoted(const std::string& text) { return "'" + text + "'"; }

bool IsStateId(const std::string& id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

void CheckIds(const Plan& plan, Violations& found) {
  std::set<std::string> seen;
  for (const State& state : plan.states) {
    if (!IsStateId(state.id)) found.push_back("the state id " + Quoted(state.id) + " is malformed");
    if (!seen.insert(state.id).second) {
      found.push_back("two states have the id " + Quoted(state.id));
    }
  }
  const State* start = FindState(plan, plan.start);
  if (start == nullptr) {
    found.push_back("the start " + Quoted(plan.start) + " is no state of the plan");
  } else if (start->kind == State::Kind::kEnd) {
    found.push_back("the start " + Quoted(plan.start) + " is an end");
  }
}

void CheckTransition(const Plan& plan, const Transition& transition, Violations& found) {
  const State* from = FindState(plan, transition.from);
  if (FindState(plan, transition.to) == nullptr) {
    found.push_back("on " + Quoted(transition.outcome) + ", " + Quoted(transition.from) +
                    " leads to " + Quoted(transition.to) + ", which is no state of the plan");
  }
  if (from == nullptr) {
    found.push_back("a transition comes from " + Quoted(transition.from) +
                    ", which is no state of the plan");
  } else if (std::find(from->outcomes.begin(), from->outcomes.end(), transition.outcome) ==
             from->outcomes.end()) {
    found.push_back(Quoted(transition.from) + " has no outcome " + Quoted(transition.outcome));
  }
}

void CheckTransitions(const Plan& plan, Violations& found) {
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const Transition& transition : plan.transitions) {
    CheckTransition(plan, transition, found);
    ++counts[{transition.from, transition.outcome}];
  }
  for (const State& state : plan.states) {
    if (state.kind == State::Kind::kSkill && state.outcomes.empty()) {
      found.push_back(Quoted(state.id) + " has no outcomes");
    }
    for (const std::string& outcome : state.outcomes) {
      const int count = counts[{state.id, outcome}];
      if (count == 0) {
        found.push_back("outcome " + Quoted(outcome) + " of " + Quoted(state.id) +
                        " leads nowhere");
      } else if (count > 1) {
        found.push_back("outcome " + Quoted(outcome) + " of " + Quoted(state.id) +
                        " leads to several states");
      }
    }
  }
}

void CheckReachability(const Plan& plan, const Ways& ways, Violations& found) {
  const std::set<std::string> reached = ReachableFrom(ways, plan.start);
  for (const State& state : plan.states) {
    if (reached.count(state.id) == 0) {
      found.push_back("the state " + Quoted(state.id) + " cannot be reached from the start");
    }
    if (state.kind == State::Kind::kEnd) continue;
    const std::set<std::string> after = ReachableFrom(ways, state.id);
    const bool ends = std::any_of(after.begin(), after.end(), [&](const std::string& id) {
      const State* other = FindState(plan, id);
      return other != nullptr && other->kind == State::Kind::kEnd;
    });
    if (!ends) found.push_back("no end can be reached from " + Quoted(state.id));
  }
}

bool IsCreatedBefore(const Plan& plan, const Ways& ways, const State& user,
                     const std::string& key) {
  return std::any_of(plan.states.begin(), plan.states.end(), [&](const State& creator) {
    const bool creates = std::any_of(creator.outputs.begin(), creator.outputs.end(),
                                     [&](const auto& output) { return output.second == key; });
    if (!creates) return false;
    const auto next = ways.find(creator.id);
    return next != ways.end() &&
           std::any_of(next->second.begin(), next->second.end(), [&](const auto& way) {
             return ReachableFrom(ways, way.second).count(user.id) > 0;
           });
  });
}

void CheckParameter(const Plan& plan, const Ways& ways, const State& state,
                    const Parameter& parameter, Violations& found) {
  const std::string what = "parameter " + Quoted(parameter.name) + " of " + Quoted(state.id);
  if (!IsCIdentifier(parameter.name) || parameter.name == "name" || parameter.name == "ID") {
    found.push_back(what + " has a name that behaviour trees cannot use");
  }
  static const std::set<std::string> kTypes = {"pose",   "pose_list", "class",  "designator",
                                               "string", "number",    "boolean"};
  if (kTypes.count(parameter.type) == 0) {
    found.push_back(what + " has the unknown type " + Quoted(parameter.type));
  }
  if (parameter.value.empty()) found.push_back(what + " is not bound");
  const std::string key = KeyOf(parameter.value);
  if (parameter.source != Parameter::Source::kStep) {
    if (!key.empty()) found.push_back(what + " has a value written like a key, " + parameter.value);
  } else if (key.empty()) {
    found.push_back(what + " comes from another step but names no key");
  } else if (!IsCreatedBefore(plan, ways, state, key)) {
    found.push_back(what + " uses " + Quoted(key) + ", which no step before it creates");
  }
}

void CheckSkills(const Plan& plan, const Ways& ways, Violations& found) {
  for (const State& state : plan.states) {
    if (state.kind == State::Kind::kEnd) {
      if (!state.outcomes.empty()) found.push_back("the end " + Quoted(state.id) + " leads on");
      continue;
    }
    if (!IsCIdentifier(state.skill)) {
      found.push_back(Quoted(state.id) +
                      " has no skill that can be called: " + Quoted(state.skill));
    }
    for (const auto& [output, key] : state.outputs) {
      if (!IsCIdentifier(output) || !IsCIdentifier(key)) {
        found.push_back("output " + Quoted(output) + " of " + Quoted(state.id) + " or its key " +
                        Quoted(key) + " is no identifier");
      }
    }
    std::set<std::string> names;
    for (const Parameter& parameter : state.inputs) {
      CheckParameter(plan, ways, state, parameter, found);
      if (!names.insert(parameter.name).second) {
        found.push_back("parameter " + Quoted(parameter.name) + " of " + Quoted(state.id) +
                        " is bound twice");
      }
    }
  }
}

}  // namespace

std::vector<std::string> CheckPlan(const Plan& plan) {
  Violations found;
  const Ways ways = WaysOf(plan);
  CheckIds(plan, found);
  CheckTransitions(plan, found);
  CheckReachability(plan, ways, found);
  CheckSkills(plan, ways, found);
  return found;
}

}  // namespace lares::recipes
