#include "recipes/plan/parallel.h"

#include <algorithm>
#include <optional>
#include <set>

#include "recipes/plan/conditions.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {
namespace {

using Group = std::vector<const State*>;

bool OnlySucceedsOrFails(const State& state) {
  return state.kind == State::Kind::kSkill &&
         state.outcomes == std::vector<std::string>{"succeeded", "failed"};
}

// Groups of states' ids.
using Groups = std::vector<std::vector<std::string>>;

bool Unordered(const Groups& groups, const State& a, const State& b) {
  const auto in = [](const std::vector<std::string>& group, const State& state) {
    return std::find(group.begin(), group.end(), state.id) != group.end();
  };
  return std::any_of(groups.begin(), groups.end(),
                     [&](const auto& group) { return in(group, a) && in(group, b); });
}

bool Uses(const State& state, const State& creator) {
  return std::any_of(state.inputs.begin(), state.inputs.end(), [&](const Parameter& input) {
    const std::string key = KeyOf(input.value);
    return !key.empty() && std::any_of(creator.outputs.begin(), creator.outputs.end(),
                                       [&](const auto& output) { return output.second == key; });
  });
}

bool CreateTheSame(const State& a, const State& b) {
  return std::any_of(a.outputs.begin(), a.outputs.end(), [&](const auto& mine) {
    return std::any_of(b.outputs.begin(), b.outputs.end(),
                       [&](const auto& other) { return other.second == mine.second; });
  });
}

// A gripper, say, that both were given.
bool ShareAPart(const State& a, const State& b) {
  for (const Parameter& mine : a.inputs) {
    if (mine.source != Parameter::Source::kRobot || mine.type != "designator") continue;
    for (const Parameter& other : b.inputs) {
      if (other.source == Parameter::Source::kRobot && other.value == mine.value) return true;
    }
  }
  return false;
}

bool Disturbs(const State& a, const State& b) {
  return std::any_of(a.effects.begin(), a.effects.end(), [&](const Effect& effect) {
    return std::any_of(b.preconditions.begin(), b.preconditions.end(),
                       [&](const Fluent& need) { return Touches(need, effect.fluent); }) ||
           std::any_of(b.effects.begin(), b.effects.end(),
                       [&](const Effect& other) { return Touches(other.fluent, effect.fluent); });
  });
}

bool GetAlong(const State& a, const State& b) {
  return !Uses(a, b) && !Uses(b, a) && !CreateTheSame(a, b) && !ShareAPart(a, b) &&
         !Disturbs(a, b) && !Disturbs(b, a);
}

bool ClaimsFit(const Group& group, const CountParts& count_parts) {
  std::map<std::string, int> claimed;
  for (const State* state : group) {
    for (const Resource& kind : state->claims) ++claimed[kind.iri];
  }
  return std::all_of(claimed.begin(), claimed.end(), [&](const auto& claim) {
    return claim.second == 1 || claim.second <= count_parts(claim.first);
  });
}

class Grouper {
 public:
  Grouper(const Plan& plan, const Groups& unordered, const CountParts& count_parts)
      : plan_(plan), unordered_(unordered), count_parts_(count_parts), ways_(WaysOf(plan)) {
    for (const Transition& transition : plan.transitions) ++entries_[transition.to];
    ++entries_[plan.start];
  }

  // The longest group that begins with `first`; of one member when nothing goes beside it.
  Group From(const State& first) const {
    Group group{&first};
    while (const State* next = Next(*group.back())) {
      if (!Fits(group, *next)) break;
      group.push_back(next);
      if (ClaimsFit(group, count_parts_)) continue;
      group.pop_back();
      break;
    }
    return group;
  }

 private:
  const State* Next(const State& state) const {
    const auto ways = ways_.find(state.id);
    if (ways == ways_.end() || ways->second.count("succeeded") == 0) return nullptr;
    const State* next = FindState(plan_, ways->second.at("succeeded"));
    if (next == nullptr || entries_.at(next->id) != 1) return nullptr;
    return next;
  }
  std::string FailsTo(const State& state) const {
    const auto ways = ways_.find(state.id);
    if (ways == ways_.end()) return "";
    const auto failed = ways->second.find("failed");
    return failed == ways->second.end() ? "" : failed->second;
  }
  bool Fits(const Group& group, const State& next) const {
    return OnlySucceedsOrFails(next) && FailsTo(next) == FailsTo(*group.front()) &&
           std::all_of(group.begin(), group.end(), [&](const State* state) {
             return OnlySucceedsOrFails(*state) && Unordered(unordered_, *state, next) &&
                    GetAlong(*state, next);
           });
  }

  const Plan& plan_;
  const Groups& unordered_;
  const CountParts& count_parts_;
  const Ways ways_;
  std::map<std::string, int> entries_;
};

std::string FreeId(const Plan& plan, int& number) {
  std::string id;
  do {
    id = "parallel-" + std::to_string(number++);
  } while (FindState(plan, id) != nullptr);
  return id;
}

State MakeParallel(const Group& group, std::string id) {
  State state;
  state.id = std::move(id);
  state.kind = State::Kind::kParallel;
  state.outcomes = {"succeeded", "failed"};
  for (const State* member : group) {
    state.members.push_back(member->id);
    state.label += (state.label.empty() ? "" : " beside ") + member->label;
  }
  return state;
}

// The group's first state hands over its way in, the last its way on.
void Redirect(Plan& plan, const Group& group, const std::string& id) {
  const std::string first = group.front()->id;
  const std::string last = group.back()->id;
  const auto is_member = [&](const std::string& state) {
    return std::any_of(group.begin(), group.end(),
                       [&](const State* member) { return member->id == state; });
  };
  std::vector<Transition> kept;
  for (Transition transition : plan.transitions) {
    const bool way_on = transition.from == last;
    if (is_member(transition.from) && !way_on) continue;
    if (way_on) transition.from = id;
    if (transition.to == first) transition.to = id;
    kept.push_back(std::move(transition));
  }
  plan.transitions = std::move(kept);
  if (plan.start == first) plan.start = id;
}

}  // namespace

void RunSideBySide(Plan& plan, const Groups& unordered, const CountParts& count_parts) {
  int number = 1;
  std::optional<Grouper> grouper(std::in_place, plan, unordered, count_parts);
  for (std::size_t at = 0; at < plan.states.size(); ++at) {
    if (!OnlySucceedsOrFails(plan.states[at]) || !plan.states[at].parallel.empty()) continue;
    const Group group = grouper->From(plan.states[at]);
    if (group.size() < 2) continue;
    State parallel = MakeParallel(group, FreeId(plan, number));
    Redirect(plan, group, parallel.id);
    for (const std::string& id : parallel.members) {
      for (State& state : plan.states) {
        if (state.id == id) state.parallel = parallel.id;
      }
    }
    plan.states.insert(plan.states.begin() + static_cast<std::ptrdiff_t>(at), std::move(parallel));
    grouper.emplace(plan, unordered, count_parts);
  }
}

}  // namespace lares::recipes
