#include <algorithm>
#include <cctype>
#include <deque>

#include "base/text.h"
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
    if (state.kind != State::Kind::kEnd && state.outcomes.empty()) {
      found.push_back(Quoted(state.id) + " has no outcomes");
    }
    if (!state.parallel.empty()) continue;
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

void CheckMember(const Plan& plan, const State& parallel, const std::string& id,
                 Violations& found) {
  const State* member = FindState(plan, id);
  const std::string what = Quoted(id) + ", which " + Quoted(parallel.id) + " runs,";
  if (member == nullptr) return found.push_back(what + " is no state of the plan");
  if (member->kind != State::Kind::kSkill) return found.push_back(what + " is no skill");
  if (member->parallel != parallel.id) found.push_back(what + " does not say so");
  for (const std::string& outcome : member->outcomes) {
    if (outcome != "succeeded" && outcome != "failed") {
      found.push_back(what + " may end as " + Quoted(outcome));
    }
  }
  for (const Transition& transition : plan.transitions) {
    if (transition.from == id || transition.to == id) {
      found.push_back(what + " is also on a way of its own, from " + Quoted(transition.from));
    }
  }
}

void CheckParallels(const Plan& plan, Violations& found) {
  for (const State& state : plan.states) {
    if (!state.parallel.empty()) {
      const State* parallel = FindState(plan, state.parallel);
      const bool is_listed = parallel != nullptr && parallel->kind == State::Kind::kParallel &&
                             std::find(parallel->members.begin(), parallel->members.end(),
                                       state.id) != parallel->members.end();
      if (!is_listed) {
        found.push_back(Quoted(state.id) + " is to be run by " + Quoted(state.parallel) +
                        ", which does not");
      }
    }
    if (state.kind != State::Kind::kParallel) continue;
    if (state.members.size() < 2) {
      found.push_back(Quoted(state.id) + " runs fewer than two states side by side");
    }
    for (const std::string& id : state.members) CheckMember(plan, state, id, found);
  }
}

// The ways apart from failures that nobody wrote down: every skill may fail, so an end that only
// they lead to is none.
Ways IntendedWays(const Plan& plan) {
  Ways ways;
  for (const Transition& transition : plan.transitions) {
    if (transition.added && transition.outcome == "failed") continue;
    ways[transition.from].emplace(transition.outcome, transition.to);
  }
  return ways;
}

bool ReachesEnd(const Plan& plan, const Ways& ways, const std::string& from) {
  const std::set<std::string> after = ReachableFrom(ways, from);
  return std::any_of(plan.states.begin(), plan.states.end(), [&](const State& state) {
    return state.kind == State::Kind::kEnd && after.count(state.id) > 0;
  });
}

// That nothing is left to try is the aim of a recipe that goes through everything.
bool CanBeDone(const Plan& plan, const Ways& ways) {
  const std::set<std::string> after = ReachableFrom(ways, plan.start);
  return std::any_of(plan.states.begin(), plan.states.end(), [&](const State& state) {
    return state.kind == State::Kind::kEnd && (state.success || state.id == "exhausted") &&
           after.count(state.id) > 0;
  });
}

void CheckReachability(const Plan& plan, const Ways& ways, Violations& found) {
  const std::set<std::string> reached = ReachableFrom(ways, plan.start);
  const Ways intended = IntendedWays(plan);
  for (const State& state : plan.states) {
    if (!state.parallel.empty()) continue;  // as its parallel is
    if (reached.count(state.id) == 0) {
      found.push_back("the state " + Quoted(state.id) + " cannot be reached from the start");
    }
    if (state.kind != State::Kind::kEnd && !ReachesEnd(plan, intended, state.id)) {
      found.push_back("no end can be reached from " + Quoted(state.id) + " unless a step fails");
    }
  }
  if (!CanBeDone(plan, intended)) {
    found.push_back("no end that is a success can be reached from the start");
  }
}

bool Creates(const Plan& plan, const State& state, const std::string& key) {
  for (const std::string& id : state.members) {
    const State* member = FindState(plan, id);
    if (member != nullptr && member->members.empty() && Creates(plan, *member, key)) return true;
  }
  return std::any_of(state.outputs.begin(), state.outputs.end(),
                     [&](const auto& output) { return output.second == key; });
}

// The states on a shortest path from the start to `user` on which nothing creates `key` before it
// is used; empty when there is none. A step that failed has created nothing.
std::vector<std::string> PathWithout(const Plan& plan, const Ways& ways, const std::string& user,
                                     const std::string& key) {
  std::map<std::string, std::string> before{{plan.start, ""}};
  std::deque<std::string> open{plan.start};
  while (!open.empty() && before.count(user) == 0) {
    const std::string id = std::move(open.front());
    open.pop_front();
    const State* state = FindState(plan, id);
    const auto from = ways.find(id);
    if (state == nullptr || from == ways.end()) continue;
    for (const auto& [outcome, to] : from->second) {
      if (outcome != "failed" && Creates(plan, *state, key)) continue;
      if (before.emplace(to, id).second) open.push_back(to);
    }
  }
  std::vector<std::string> path;
  if (before.count(user) == 0) return path;
  for (std::string id = user; !id.empty(); id = before.at(id)) path.push_back(id);
  std::reverse(path.begin(), path.end());
  return path;
}

void CheckParameter(const Plan& plan, const Ways& ways, const State& state,
                    const Parameter& parameter, Violations& found) {
  const std::string what = "parameter " + Quoted(parameter.name) + " of " + Quoted(state.id);
  if (!IsCIdentifier(parameter.name) || parameter.name == "name" || parameter.name == "ID") {
    found.push_back(what + " has a name that behaviour trees cannot use");
  }
  static const std::set<std::string> kTypes = {"pose",       "pose_list",  "class",
                                               "class_list", "designator", "designator_list",
                                               "string",     "number",     "boolean"};
  if (kTypes.count(parameter.type) == 0) {
    found.push_back(what + " has the unknown type " + Quoted(parameter.type));
  }
  if (parameter.value.empty()) found.push_back(what + " is not bound");
  const std::string key = KeyOf(parameter.value);
  if (parameter.source != Parameter::Source::kStep) {
    if (!key.empty()) found.push_back(what + " has a value written like a key, " + parameter.value);
  } else if (key.empty()) {
    found.push_back(what + " comes from another step but names no key");
  } else if (std::find(plan.given.begin(), plan.given.end(), key) != plan.given.end()) {
    return;
  } else if (const auto path =
                 PathWithout(plan, ways, state.parallel.empty() ? state.id : state.parallel, key);
             !path.empty()) {
    found.push_back(what + " uses " + Quoted(key) + ", which no step creates on the way " +
                    Join(path, " → "));
  }
}

void CheckSkills(const Plan& plan, const Ways& ways, Violations& found) {
  for (const State& state : plan.states) {
    if (state.kind == State::Kind::kEnd) {
      if (!state.outcomes.empty()) found.push_back("the end " + Quoted(state.id) + " leads on");
      continue;
    }
    if (state.kind == State::Kind::kParallel) continue;
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
  CheckParallels(plan, found);
  CheckReachability(plan, ways, found);
  CheckSkills(plan, ways, found);
  return found;
}

}  // namespace lares::recipes
