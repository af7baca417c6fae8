#include "recipes/plan/shape.h"

#include <cctype>

namespace lares::recipes {

Ways WaysOf(const Plan& plan) {
  Ways ways;
  for (const Transition& transition : plan.transitions) {
    ways[transition.from].emplace(transition.outcome, transition.to);
  }
  return ways;
}

std::set<std::string> ReachableFrom(const Ways& ways, const std::string& start) {
  std::set<std::string> reached{start};
  std::vector<std::string> open{start};
  while (!open.empty()) {
    const std::string id = std::move(open.back());
    open.pop_back();
    const auto from = ways.find(id);
    if (from == ways.end()) continue;
    for (const auto& [outcome, to] : from->second) {
      if (reached.insert(to).second) open.push_back(to);
    }
  }
  return reached;
}

const State* FindState(const Plan& plan, const std::string& id) {
  for (const State& state : plan.states) {
    if (state.id == id) return &state;
  }
  return nullptr;
}

namespace {

bool Fails(const Plan& plan, const std::string& id) {
  const State* state = FindState(plan, id);
  return state != nullptr && state->kind == State::Kind::kEnd && !state->success;
}

// The state after `state`, or null when it is not a plain step.
const State* PlainNext(const Plan& plan, const Ways& ways, const State& state) {
  const auto from = ways.find(state.id);
  if (from == ways.end()) return nullptr;
  const State* next = nullptr;
  for (const auto& [outcome, to] : from->second) {
    if (outcome == "succeeded") {
      next = FindState(plan, to);
    } else if (outcome != "failed" || !Fails(plan, to)) {
      return nullptr;
    }
  }
  return next;
}

}  // namespace

std::vector<const State*> LinearSteps(const Plan& plan) {
  const Ways ways = WaysOf(plan);
  std::vector<const State*> steps;
  const State* state = FindState(plan, plan.start);
  while (state != nullptr && state->kind != State::Kind::kEnd) {
    if (steps.size() > plan.states.size()) return {};  // a circle
    steps.push_back(state);
    state = PlainNext(plan, ways, *state);
  }
  if (state == nullptr || !state->success) return {};
  return steps;
}

bool IsCIdentifier(std::string_view text) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) != 0) return false;
  for (const char c : text) {
    if (c != '_' && std::isalnum(static_cast<unsigned char>(c)) == 0) return false;
  }
  return true;
}

std::string KeyOf(std::string_view value) {
  if (value.size() < 3 || value.front() != '{' || value.back() != '}') return {};
  return std::string(value.substr(1, value.size() - 2));
}

std::vector<const State*> Running(const Plan& plan, const State& state) {
  if (state.kind != State::Kind::kParallel) return {&state};
  std::vector<const State*> running;
  for (const std::string& id : state.members) {
    if (const State* member = FindState(plan, id)) running.push_back(member);
  }
  return running;
}

}  // namespace lares::recipes
