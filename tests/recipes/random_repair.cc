#include "tests/recipes/random_repair.h"

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

namespace lares::testing {

using recipes::IsSolution;
using recipes::RepairProblem;
using recipes::RepairSet;

namespace {

std::vector<RepairProblem::Clause> RandomClauses(std::mt19937& random, std::size_t things,
                                                 int most) {
  std::vector<RepairProblem::Clause> clauses(random() % static_cast<unsigned>(most + 1));
  for (auto& clause : clauses) {
    const std::size_t size = 1 + (random() % 4 == 0 ? random() % 3 : 0);
    for (std::size_t i = 0; i < size; ++i) clause.push_back(random() % things);
  }
  return clauses;
}

}  // namespace

RepairProblem RandomRepairProblem(std::uint32_t seed) {
  std::mt19937 random(seed);
  RepairProblem problem;
  problem.things.resize(4 + random() % 12);
  const std::size_t count = problem.things.size();
  for (auto& thing : problem.things) {
    const auto kind = random() % 10;
    thing.present = kind < 2;
    if (kind == 0) thing.present_clauses = RandomClauses(random, count, 2);
    thing.derives = kind > 4;
    if (thing.derives) thing.clauses = RandomClauses(random, count, 3);
    thing.grounds = random() % 12 == 0;
  }
  problem.additions.resize(1 + random() % 11);
  for (auto& addition : problem.additions) {
    std::set<std::size_t> covers{random() % count};
    while (random() % 3 == 0) covers.insert(random() % count);
    addition.covers.assign(covers.begin(), covers.end());
    if (random() % 4 == 0) addition.clauses = RandomClauses(random, count, 2);
    addition.cost = 1 + static_cast<std::int64_t>(random() % 6);
  }
  std::stable_sort(problem.additions.begin(), problem.additions.end(),
                   [](const auto& a, const auto& b) { return a.covers.size() < b.covers.size(); });
  problem.wanted = RandomClauses(random, count, 4);
  return problem;
}

std::vector<std::size_t> Members(std::uint32_t set, std::size_t count) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < count; ++i) {
    if ((set >> i & 1U) != 0) members.push_back(i);
  }
  return members;
}

std::vector<RepairSet> AllRepairs(const RepairProblem& problem) {
  std::vector<RepairSet> all;
  for (std::uint32_t set = 0; set < (1U << problem.additions.size()); ++set) {
    RepairSet one{Members(set, problem.additions.size()), 0};
    for (const std::size_t a : one.additions) one.cost += problem.additions[a].cost;
    if (IsSolution(problem, one.additions)) all.push_back(std::move(one));
  }
  std::sort(all.begin(), all.end(), [](const RepairSet& a, const RepairSet& b) {
    return std::forward_as_tuple(a.cost, a.additions.size(), a.additions) <
           std::forward_as_tuple(b.cost, b.additions.size(), b.additions);
  });
  return all;
}

}  // namespace lares::testing
