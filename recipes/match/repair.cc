#include "recipes/match/repair.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_set>

namespace lares::recipes {

namespace {

using Clause = RepairProblem::Clause;
using Thing = RepairProblem::Thing;
using Taken = std::vector<std::size_t>;  // sorted

bool Holds(const Clause& clause, const std::vector<bool>& there) {
  return std::any_of(clause.begin(), clause.end(), [&](std::size_t thing) { return there[thing]; });
}

bool AllHold(const std::vector<Clause>& clauses, const std::vector<bool>& there) {
  return std::all_of(clauses.begin(), clauses.end(),
                     [&](const Clause& clause) { return Holds(clause, there); });
}

// Drops what lacks support until nothing more falls.
void DropUnsupported(const RepairProblem& problem, const std::vector<bool>& covered,
                     std::vector<bool>& there) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < problem.things.size(); ++i) {
      if (!there[i] || covered[i]) continue;
      const Thing& thing = problem.things[i];
      if (thing.present && AllHold(thing.present_clauses, there)) continue;
      if (thing.derives && AllHold(thing.clauses, there)) continue;
      there[i] = false;
      changed = true;
    }
  }
}

// Of the things in `there`, those that do not rest on each other alone.
std::vector<bool> Grounded(const RepairProblem& problem, const std::vector<bool>& covered,
                           const std::vector<bool>& there) {
  std::vector<bool> grounded(there.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < problem.things.size(); ++i) {
      if (!there[i] || grounded[i]) continue;
      const Thing& thing = problem.things[i];
      const bool stands =
          covered[i] || thing.grounds || (thing.present && AllHold(thing.present_clauses, there)) ||
          std::any_of(thing.clauses.begin(), thing.clauses.end(),
                      [&](const Clause& clause) { return Holds(clause, grounded); });
      if (!stands) continue;
      grounded[i] = true;
      changed = true;
    }
  }
  return grounded;
}

// What can be reached from what, through clauses: which things lie in circles.
std::vector<bool> InCircles(const RepairProblem& problem) {
  const std::size_t count = problem.things.size();
  std::vector<bool> in_circle(count, false);
  for (std::size_t start = 0; start < count; ++start) {
    std::vector<bool> seen(count, false);
    std::vector<std::size_t> open{start};
    while (!open.empty() && !in_circle[start]) {
      const Thing& thing = problem.things[open.back()];
      open.pop_back();
      for (const auto* clauses : {&thing.clauses, &thing.present_clauses}) {
        for (const Clause& clause : *clauses) {
          for (const std::size_t next : clause) {
            if (next == start) in_circle[start] = true;
            if (seen[next]) continue;
            seen[next] = true;
            open.push_back(next);
          }
        }
      }
    }
  }
  return in_circle;
}

struct State {
  Taken taken;
  std::int64_t cost = 0;
  std::int64_t bound = 0;  // no solution above it costs less

  bool operator>(const State& other) const {
    // Of equally promising ones the one that has come farthest.
    return std::forward_as_tuple(bound, other.taken.size(), taken) >
           std::forward_as_tuple(other.bound, taken.size(), other.taken);
  }
};

struct TakenHash {
  std::size_t operator()(const Taken& taken) const {
    std::size_t hash = 1469598103934665603ULL;
    for (const std::size_t one : taken) hash = (hash ^ one) * 1099511628211ULL;
    return hash;
  }
};

// Costs no more and covers part of what `special` does.
bool IsMoreGeneral(const RepairProblem::Addition& general, const RepairProblem::Addition& special) {
  const auto covered = [&](std::size_t thing) {
    return std::find(special.covers.begin(), special.covers.end(), thing) != special.covers.end();
  };
  return general.cost <= special.cost && general.covers.size() < special.covers.size() &&
         std::all_of(general.covers.begin(), general.covers.end(), covered);
}

class Search {
 public:
  Search(const RepairProblem& problem, const RepairOptions& options)
      : problem_(problem), options_(options), in_circle_(InCircles(problem)) {
    covered_by_.resize(problem.things.size());
    for (std::size_t a = 0; a < problem.additions.size(); ++a) {
      for (const std::size_t thing : problem.additions[a].covers) covered_by_[thing].push_back(a);
    }
  }

  RepairSets Run() {
    Push({});
    while (!open_.empty() && !IsDone()) {
      if (result_.states >= options_.max_states) {
        GiveUp();
        break;
      }
      ++result_.states;
      State state = open_.top();
      open_.pop();
      Expand(state);
    }
    Finish();
    return std::move(result_);
  }

 private:
  // The additions of which every solution above the present state takes one: those that cover an
  // unmet thing below the clause. (Of a thing outside circles one unmet clause is enough: it must
  // be met in any case.)
  std::vector<std::size_t> Ways(const Clause& clause, const std::vector<bool>& there) const {
    std::set<std::size_t> ways;
    std::vector<bool> seen(problem_.things.size(), false);
    std::vector<std::size_t> open(clause.begin(), clause.end());
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (seen[at]) continue;
      seen[at] = true;
      ways.insert(covered_by_[at].begin(), covered_by_[at].end());
      const Thing& thing = problem_.things[at];
      if (thing.present) Descend(at, thing.present_clauses, there, open);
      if (thing.derives) Descend(at, thing.clauses, there, open);
    }
    return {ways.begin(), ways.end()};
  }

  void Descend(std::size_t at, const std::vector<Clause>& clauses, const std::vector<bool>& there,
               std::vector<std::size_t>& open) const {
    for (const Clause& clause : clauses) {
      if (Holds(clause, there)) continue;
      open.insert(open.end(), clause.begin(), clause.end());
      if (!in_circle_[at]) return;
    }
  }

  // The ways of each unmet clause, the fewest first; one of them empty when nothing helps.
  std::vector<std::vector<std::size_t>> Unmet(const Taken& taken,
                                              const std::vector<bool>& there) const {
    std::vector<std::vector<std::size_t>> unmet;
    const auto look_at = [&](const std::vector<Clause>& clauses) {
      for (const Clause& clause : clauses) {
        if (!Holds(clause, there)) unmet.push_back(Ways(clause, there));
      }
    };
    look_at(problem_.wanted);
    for (const std::size_t a : taken) look_at(problem_.additions[a].clauses);
    std::sort(unmet.begin(), unmet.end(), [](const auto& a, const auto& b) {
      return std::forward_as_tuple(a.size(), a) < std::forward_as_tuple(b.size(), b);
    });
    return unmet;
  }

  // Clauses that share no addition are each paid for.
  std::int64_t BoundOf(const std::vector<std::vector<std::size_t>>& unmet) const {
    std::int64_t bound = 0;
    std::set<std::size_t> counted;
    for (const auto& ways : unmet) {
      std::int64_t cheapest = std::numeric_limits<std::int64_t>::max();
      bool is_new = true;
      for (const std::size_t a : ways) {
        is_new = is_new && !counted.contains(a);
        cheapest = std::min(cheapest, problem_.additions[a].cost);
      }
      if (!is_new || ways.empty()) continue;
      bound += cheapest;
      counted.insert(ways.begin(), ways.end());
    }
    return bound;
  }

  std::int64_t CostOf(const Taken& taken) const {
    std::int64_t cost = 0;
    for (const std::size_t a : taken) cost += problem_.additions[a].cost;
    return cost;
  }

  void Push(Taken taken) {
    if (!seen_.insert(taken).second) return;
    const auto unmet = Unmet(taken, Satisfied(problem_, taken));
    if (!unmet.empty() && unmet.front().empty()) return;  // nothing above it is a solution
    const std::int64_t cost = CostOf(taken);
    const std::int64_t bound = cost + BoundOf(unmet);
    open_.push({std::move(taken), cost, bound});
  }

  void Expand(const State& state) {
    const auto unmet = Unmet(state.taken, Satisfied(problem_, state.taken));
    if (unmet.empty()) {
      Keep({state.taken, state.cost});
      return;
    }
    for (const std::size_t a : unmet.front()) {
      Taken more = state.taken;
      const auto place = std::lower_bound(more.begin(), more.end(), a);
      if (place != more.end() && *place == a) continue;
      more.insert(place, a);
      Push(std::move(more));
    }
  }

  // A set that holds another solution is none: that one was cheaper, so it came first.
  void Keep(RepairSet set) {
    const auto holds = [&](const RepairSet& other) {
      return std::includes(set.additions.begin(), set.additions.end(), other.additions.begin(),
                           other.additions.end());
    };
    if (std::any_of(solutions_.begin(), solutions_.end(), holds)) return;
    solutions_.push_back(set);
    if (!CanBeMoreGeneral(set.additions)) result_.sets.push_back(std::move(set));
  }

  bool CanBeMoreGeneral(const Taken& taken) const {
    for (const std::size_t a : taken) {
      for (std::size_t other = 0; other < a; ++other) {
        if (!IsMoreGeneral(problem_.additions[other], problem_.additions[a])) continue;
        Taken with = taken;
        with.erase(std::find(with.begin(), with.end(), a));
        with.insert(std::lower_bound(with.begin(), with.end(), other), other);
        if (IsSolution(problem_, with)) return true;
      }
    }
    return false;
  }

  // As many as asked for, and no other that costs as much as the last of them.
  bool IsDone() const {
    if (result_.sets.size() < std::max<std::size_t>(options_.sets, 1)) return false;
    return open_.top().bound > result_.sets[options_.sets == 0 ? 0 : options_.sets - 1].cost;
  }

  // The work has run out. What is there stays; when nothing is, the most promising state is
  // completed with the cheapest way of each unmet clause.
  void GiveUp() {
    result_.complete = false;
    result_.proven = !result_.sets.empty();
    while (result_.sets.empty() && !open_.empty()) {
      Taken taken = open_.top().taken;
      open_.pop();
      if (Complete(taken)) Keep({taken, CostOf(taken)});
    }
  }

  bool Complete(Taken& taken) const {
    for (std::size_t i = 0; i <= problem_.additions.size(); ++i) {
      const auto unmet = Unmet(taken, Satisfied(problem_, taken));
      if (unmet.empty()) {
        DropSpare(taken);
        return true;
      }
      const std::size_t* cheapest = nullptr;
      for (const std::size_t& a : unmet.front()) {
        if (std::binary_search(taken.begin(), taken.end(), a)) continue;
        if (cheapest == nullptr ||
            problem_.additions[a].cost < problem_.additions[*cheapest].cost) {
          cheapest = &a;
        }
      }
      if (cheapest == nullptr) return false;
      taken.insert(std::lower_bound(taken.begin(), taken.end(), *cheapest), *cheapest);
    }
    return false;
  }

  void DropSpare(Taken& taken) const {
    for (std::size_t i = 0; i < taken.size();) {
      Taken without = taken;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (IsSolution(problem_, without)) {
        taken = std::move(without);
      } else {
        ++i;
      }
    }
  }

  void Finish() {
    std::sort(result_.sets.begin(), result_.sets.end(), [](const RepairSet& a, const RepairSet& b) {
      return std::forward_as_tuple(a.cost, a.additions.size(), a.additions) <
             std::forward_as_tuple(b.cost, b.additions.size(), b.additions);
    });
    if (result_.sets.size() > options_.sets) result_.sets.resize(options_.sets);
  }

  const RepairProblem& problem_;
  const RepairOptions& options_;
  const std::vector<bool> in_circle_;
  std::vector<std::vector<std::size_t>> covered_by_;  // thing → additions
  std::priority_queue<State, std::vector<State>, std::greater<>> open_;
  std::unordered_set<Taken, TakenHash> seen_;
  std::vector<RepairSet> solutions_;  // none can do with less
  RepairSets result_;
};

}  // namespace

std::vector<bool> Satisfied(const RepairProblem& problem, const std::vector<std::size_t>& taken) {
  std::vector<bool> covered(problem.things.size(), false);
  for (const std::size_t a : taken) {
    for (const std::size_t thing : problem.additions[a].covers) covered[thing] = true;
  }
  std::vector<bool> there(problem.things.size(), true);
  for (;;) {
    DropUnsupported(problem, covered, there);
    std::vector<bool> grounded = Grounded(problem, covered, there);
    if (grounded == there) return there;
    there = std::move(grounded);
  }
}

bool IsSolution(const RepairProblem& problem, const std::vector<std::size_t>& taken) {
  const std::vector<bool> there = Satisfied(problem, taken);
  return AllHold(problem.wanted, there) &&
         std::all_of(taken.begin(), taken.end(),
                     [&](std::size_t a) { return AllHold(problem.additions[a].clauses, there); });
}

RepairSets SmallestRepairs(const RepairProblem& problem, const RepairOptions& options) {
  return Search(problem, options).Run();
}

}  // namespace lares::recipes
