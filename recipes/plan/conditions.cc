#include "recipes/plan/conditions.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "base/text.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {
namespace {

constexpr std::size_t kMaxSituations = 20'000;

enum class Truth { kNo, kYes, kMaybe };

// What is known; of what is not in it nothing has been said yet.
class World {
 public:
  std::optional<Truth> Find(const Fluent& fluent) const {
    const auto one = known_.find({fluent.name, fluent.argument});
    if (one != known_.end()) return one->second;
    if (fluent.argument.empty()) return std::nullopt;
    const auto any = known_.find({fluent.name, "*"});
    return any == known_.end() ? std::nullopt : std::optional(any->second);
  }
  void Set(const Fluent& fluent, Truth truth) {
    if (fluent.argument == "*") {
      std::erase_if(known_, [&](const auto& entry) {
        return entry.first.first == fluent.name && !entry.first.second.empty();
      });
    }
    known_[{fluent.name, fluent.argument}] = truth;
  }
  void Set(const Fluent& fluent) { Set(fluent, fluent.holds ? Truth::kYes : Truth::kNo); }
  friend auto operator<=>(const World&, const World&) = default;

 private:
  std::map<std::pair<std::string, std::string>, Truth> known_;
};

struct Situation {
  const State* state = nullptr;
  World world;
  int before = -1;  // the situation that led here
};

class Simulator {
 public:
  explicit Simulator(const Plan& plan) : plan_(plan), ways_(WaysOf(plan)) {
    Reach(FindState(plan, plan.start), World(), -1);
  }

  Simulation Run(const std::vector<Fluent>& brought_about) {
    for (std::size_t at = 0; at < situations_.size(); ++at) {
      if (situations_.size() > kMaxSituations) {
        result_.complete = false;
        break;
      }
      Visit(static_cast<int>(at));
    }
    CheckStart(brought_about);
    std::sort(result_.assumptions.begin(), result_.assumptions.end(),
              [](const Fluent& a, const Fluent& b) {
                return std::pair(a.name, a.argument) < std::pair(b.name, b.argument);
              });
    return std::move(result_);
  }

 private:
  void Reach(const State* state, World world, int before) {
    if (state == nullptr || !seen_.insert({state->id, world}).second) return;
    situations_.push_back({state, std::move(world), before});
  }

  void Visit(int at) {
    const State& state = *situations_[at].state;
    if (state.kind == State::Kind::kEnd) return;
    World world = situations_[at].world;
    const std::vector<const State*> running = Running(plan_, state);
    for (const State* each : running) {
      for (const Fluent& fluent : each->preconditions) Need(at, *each, fluent, world);
    }
    const auto ways = ways_.find(state.id);
    if (ways == ways_.end()) return;
    for (const auto& [outcome, to] : ways->second) {
      World next = world;
      for (const State* each : running) Apply(state, *each, outcome, next);
      Reach(FindState(plan_, to), std::move(next), at);
    }
  }

  void CheckStart(const std::vector<Fluent>& brought_about) {
    World start;
    for (const Fluent& fluent : brought_about) start.Set(fluent);
    for (const Fluent& needed : result_.assumptions) {
      const auto truth = start.Find(needed);
      if (truth && *truth != (needed.holds ? Truth::kYes : Truth::kNo)) {
        result_.problems.push_back("'" + plan_.start + "' and what follows need " + ToText(needed) +
                                   ", which is not so after what is done");
      }
    }
  }

  // Of steps side by side one may have come to its end when another failed.
  static void Apply(const State& whole, const State& each, const std::string& outcome,
                    World& world) {
    const bool stopped = whole.kind == State::Kind::kParallel && outcome == "failed";
    for (const Effect& effect : each.effects) {
      if (stopped) {
        world.Set(effect.fluent, Truth::kMaybe);
      } else if (effect.outcome == outcome) {
        world.Set(effect.fluent);
      }
    }
  }

  // What nothing has been said of is assumed to be so from the start.
  void Need(int at, const State& state, const Fluent& fluent, World& world) {
    const auto truth = world.Find(fluent);
    const Truth wanted = fluent.holds ? Truth::kYes : Truth::kNo;
    if (truth && *truth != Truth::kMaybe && *truth != wanted) {
      return Complain("'" + state.id + "' needs " + ToText(fluent) +
                      ", which is not so on the way " + Way(at));
    }
    if (truth) return;
    const auto same = std::find_if(result_.assumptions.begin(), result_.assumptions.end(),
                                   [&](const Fluent& other) { return Touches(other, fluent); });
    if (same == result_.assumptions.end()) {
      result_.assumptions.push_back(fluent);
    } else if (same->holds != fluent.holds) {
      return Complain("'" + state.id + "' needs " + ToText(fluent) + " on the way " + Way(at) +
                      ", and another step needs at the start that it is not so");
    }
    world.Set(fluent);
  }

  void Complain(const std::string& problem) {
    if (complaints_.insert(problem.substr(0, problem.find(" on the way "))).second) {
      result_.problems.push_back(problem);
    }
  }

  std::string Way(int at) const {
    std::vector<std::string> ids;
    for (; at >= 0; at = situations_[at].before) ids.push_back(situations_[at].state->id);
    std::reverse(ids.begin(), ids.end());
    return Join(ids, " → ");
  }

  const Plan& plan_;
  const Ways ways_;
  std::deque<Situation> situations_;
  std::set<std::pair<std::string, World>> seen_;
  std::set<std::string> complaints_;
  Simulation result_;
};

}  // namespace

std::optional<Fluent> ParseFluent(std::string_view text) {
  Fluent fluent;
  text = Trim(text);
  if (text == "not" || text.starts_with("not ")) {
    fluent.holds = false;
    text = Trim(text.substr(3));
  }
  const std::size_t open = text.find('(');
  if (open != std::string_view::npos) {
    if (!text.ends_with(')')) return std::nullopt;
    const std::string_view argument = Trim(text.substr(open + 1, text.size() - open - 2));
    if (argument != "*" && !IsCIdentifier(argument)) return std::nullopt;
    fluent.argument = argument;
    text = Trim(text.substr(0, open));
  }
  if (!IsCIdentifier(text)) return std::nullopt;
  fluent.name = text;
  return fluent;
}

Fluent Ground(Fluent fluent, const State& state) {
  if (fluent.argument.empty() || fluent.argument == "*") return fluent;
  for (const Parameter& input : state.inputs) {
    if (input.name != fluent.argument) continue;
    fluent.argument = input.value;
    return fluent;
  }
  const auto output = state.outputs.find(fluent.argument);
  fluent.argument = output == state.outputs.end() ? "" : "{" + output->second + "}";
  return fluent;
}

bool Touches(const Fluent& a, const Fluent& b) {
  if (a.name != b.name) return false;
  if (a.argument == b.argument) return true;
  const bool is_any = a.argument == "*" || b.argument == "*";
  return is_any && !a.argument.empty() && !b.argument.empty();
}

std::string ToText(const Fluent& fluent) {
  std::string text = fluent.holds ? fluent.name : "not " + fluent.name;
  if (fluent.argument.empty()) return text;
  const bool is_iri = fluent.argument.find("://") != std::string::npos;
  return text + "(" + std::string(is_iri ? LocalName(fluent.argument) : fluent.argument) + ")";
}

Simulation Simulate(const Plan& plan, const std::vector<Fluent>& brought_about) {
  return Simulator(plan).Run(brought_about);
}

}  // namespace lares::recipes
