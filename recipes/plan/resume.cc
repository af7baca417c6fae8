#include "recipes/plan/resume.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {
namespace {

const State& SkillState(const Plan& plan, const std::string& id) {
  const State* state = FindState(plan, id);
  if (state != nullptr && state->kind == State::Kind::kSkill) return *state;
  std::vector<std::string> ids;
  for (const State& each : plan.states) {
    if (each.kind == State::Kind::kSkill) ids.push_back(each.id);
  }
  Error error(Code::kInvalid, "'" + id + "' is no step of this plan");
  error.WithHint("its steps are " + Join(ids, ", "));
  throw error;
}

// The first state on the way of successes that is not done.
std::string FirstOpen(const Plan& plan, const std::set<std::string>& done) {
  const Ways ways = WaysOf(plan);
  std::set<std::string> passed;
  std::string id = plan.start;
  while (done.count(id) > 0 && passed.insert(id).second) {
    const std::map<std::string, std::string>& own = ways.at(id);
    const auto next = own.find("succeeded");
    if (next == own.end()) {
      Error error(Code::kInvalid, "'" + id + "' is done, but not what it found out");
      error.WithHint("say with which step to go on (from)");
      throw error;
    }
    id = next->second;
  }
  const State* state = FindState(plan, id);
  if (state == nullptr || state->kind == State::Kind::kEnd || done.count(id) > 0) {
    throw Error(Code::kInvalid, "nothing is left to do: every step up to the end is done");
  }
  return id;
}

// A step that is done and lies on no loop is passed over where the plan still comes by it.
void PassOver(Plan& plan, const std::set<std::string>& done) {
  const Ways ways = WaysOf(plan);
  std::map<std::string, std::string> next;  // of each that is passed over
  for (const std::string& id : done) {
    const std::map<std::string, std::string>& own = ways.at(id);
    const auto on = own.find("succeeded");
    if (on == own.end() || ReachableFrom(ways, on->second).count(id) > 0) continue;
    next.emplace(id, on->second);
  }
  for (Transition& transition : plan.transitions) {
    for (auto on = next.find(transition.to); on != next.end(); on = next.find(transition.to)) {
      transition.to = on->second;
    }
  }
}

}  // namespace

void Resume(Plan& plan, const std::string& from, const std::vector<std::string>& done) {
  std::set<std::string> given;
  for (const std::string& id : done) {
    for (const auto& [output, key] : SkillState(plan, id).outputs) given.insert(key);
  }
  plan.start =
      from.empty() ? FirstOpen(plan, {done.begin(), done.end()}) : SkillState(plan, from).id;
  PassOver(plan, {done.begin(), done.end()});
  plan.done = done;
  plan.given.assign(given.begin(), given.end());
  const std::set<std::string> reached = ReachableFrom(WaysOf(plan), plan.start);
  std::erase_if(plan.states, [&](const State& state) { return reached.count(state.id) == 0; });
  std::erase_if(plan.transitions,
                [&](const Transition& transition) { return reached.count(transition.from) == 0; });
}

}  // namespace lares::recipes
