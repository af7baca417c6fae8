// The cheapest sets of additions that make all wanted things available, as a problem of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lares::recipes {

// Things that depend on things, and what can be added. A thing is there when an addition that is
// taken covers it; or it is present and all its `present_clauses` hold; or it is derived: it has
// `derives`, all its `clauses` hold, and it does not rest on itself alone. A clause holds when any
// of its things is there; one without things never does.
struct RepairProblem {
  using Clause = std::vector<std::size_t>;  // indices of things
  struct Thing {
    bool present = false;
    std::vector<Clause> present_clauses;
    bool derives = false;
    std::vector<Clause> clauses;
    bool grounds = false;  // rests on something besides its clauses
  };
  struct Addition {
    std::vector<std::size_t> covers;
    std::vector<Clause> clauses;  // must hold when it is taken
    std::int64_t cost = 1;        // positive
  };
  std::vector<Thing> things;
  std::vector<Addition> additions;  // what covers less stands before what covers that and more
  std::vector<Clause> wanted;
};

// Which things are there when the additions of `taken` (sorted indices) are: the largest set of
// things that support each other and do not float.
std::vector<bool> Satisfied(const RepairProblem& problem, const std::vector<std::size_t>& taken);
// Whether all clauses that are wanted, and all of the taken additions, hold.
bool IsSolution(const RepairProblem& problem, const std::vector<std::size_t>& taken);

struct RepairSet {
  std::vector<std::size_t> additions;  // sorted; none can be left out
  std::int64_t cost = 0;
};

struct RepairSets {
  // By cost, then number of additions, then their indices. Empty when nothing helps. A set in which
  // a more general addition would do for no more is left out.
  std::vector<RepairSet> sets;
  // False when the work ran out before any set was found to be the cheapest: there is one set then,
  // and a better one may exist.
  bool proven = true;
  // False when it ran out later: other sets may belong among these, the first one costs least.
  bool complete = true;
  std::size_t states = 0;  // that were looked at
};

struct RepairOptions {
  std::size_t sets = 3;
  std::size_t max_states = 20'000;
};

// Exact best-first search (A*, Hart, Nilsson and Raphael 1968): from a set of additions, an unmet
// clause leads to those additions of which every solution above that set takes one. The bound is
// the sum of the cheapest additions of unmet clauses that share none.
RepairSets SmallestRepairs(const RepairProblem& problem, const RepairOptions& options = {});

}  // namespace lares::recipes
