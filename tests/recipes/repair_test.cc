// Exact repairs of abstract problems: rules one by one, and a thousand random ones against trying
// every set.
#include "recipes/match/repair.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/recipes/random_repair.h"

namespace lares::testing {
namespace {

using recipes::IsSolution;
using recipes::RepairOptions;
using recipes::RepairProblem;
using recipes::RepairSet;
using recipes::SmallestRepairs;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

RepairProblem::Thing Absent() { return {}; }
RepairProblem::Thing Derived(std::vector<RepairProblem::Clause> clauses) {
  RepairProblem::Thing thing;
  thing.derives = true;
  thing.clauses = std::move(clauses);
  return thing;
}

TEST(Repair, WhatIsThereNeedsNone) {
  RepairProblem problem;
  problem.things = {Absent()};
  problem.things[0].present = true;
  problem.wanted = {{0}};
  const auto found = SmallestRepairs(problem);
  ASSERT_THAT(found.sets, SizeIs(1));
  EXPECT_THAT(found.sets[0].additions, IsEmpty());
}

TEST(Repair, WhatNothingCoversHasNone) {
  RepairProblem problem;
  problem.things = {Absent()};
  problem.wanted = {{0}};
  EXPECT_THAT(SmallestRepairs(problem).sets, IsEmpty());
  EXPECT_TRUE(SmallestRepairs(problem).proven);
}

TEST(Repair, OneDearThingLosesAgainstTwoCheapOnes) {
  RepairProblem problem;
  problem.things = {Derived({{1}, {2}}), Absent(), Absent()};
  problem.additions = {{{1}, {}, 3}, {{2}, {}, 3}, {{1, 2}, {}, 7}};
  problem.wanted = {{0}};
  const auto found = SmallestRepairs(problem);
  ASSERT_THAT(found.sets, SizeIs(2));
  EXPECT_THAT(found.sets[0].additions, ElementsAre(0, 1));
  EXPECT_EQ(found.sets[0].cost, 6);
  EXPECT_THAT(found.sets[1].additions, ElementsAre(2));
}

TEST(Repair, OfEquallyCheapOnesTheOneWithFewerAdditionsComesFirst) {
  RepairProblem problem;
  problem.things = {Absent(), Absent()};
  problem.additions = {{{0}, {}, 3}, {{1}, {}, 4}, {{0, 1}, {}, 7}};
  problem.wanted = {{0}, {1}};
  EXPECT_THAT(SmallestRepairs(problem).sets.front().additions, ElementsAre(2));
}

TEST(Repair, WhatAnAdditionNeedsIsPaidForToo) {
  RepairProblem problem;
  problem.things = {Absent(), Absent(), Absent()};
  problem.additions = {{{0}, {{1}}, 1}, {{1}, {}, 9}, {{0, 2}, {}, 5}};
  problem.wanted = {{0}};
  EXPECT_THAT(SmallestRepairs(problem).sets.front().additions, ElementsAre(2));
}

TEST(Repair, ACircleThatFloatsIsGroundedByOneOfItsOwn) {
  RepairProblem problem;
  problem.things = {Derived({{1}}), Derived({{0}, {2}}), Absent()};
  problem.additions = {{{2}, {}, 4}};
  problem.wanted = {{0}};
  EXPECT_FALSE(IsSolution(problem, {}));
  EXPECT_THAT(SmallestRepairs(problem).sets.front().additions, ElementsAre(0));
}

TEST(Repair, WhenTheWorkRunsOutItIsSaidAndWhatComesIsASolution) {
  RepairProblem problem;
  for (std::size_t i = 0; i < 24; ++i) {
    problem.things.push_back(Absent());
    problem.additions.push_back({{i}, {}, 1 + static_cast<std::int64_t>(i % 3)});
  }
  std::mt19937 random(7);
  for (int i = 0; i < 30; ++i) {
    RepairProblem::Clause clause;
    for (int j = 0; j < 3; ++j) clause.push_back(random() % 24);
    problem.wanted.push_back(clause);
  }
  RepairOptions options;
  options.max_states = 2;
  const auto found = SmallestRepairs(problem, options);
  EXPECT_FALSE(found.proven);
  ASSERT_THAT(found.sets, SizeIs(1));
  EXPECT_TRUE(IsSolution(problem, found.sets.front().additions));
  EXPECT_TRUE(SmallestRepairs(problem).proven);
}

// What is there, written down from the meaning and not from the way the solver works.
class Truth {
 public:
  Truth(const RepairProblem& problem, const std::vector<std::size_t>& taken) : problem_(problem) {
    covered_.resize(problem.things.size(), false);
    for (const std::size_t a : taken) {
      for (const std::size_t thing : problem.additions[a].covers) covered_[thing] = true;
    }
  }

  // The union of all sets of things that support themselves and do not float.
  std::vector<bool> There() const {
    const std::size_t count = problem_.things.size();
    std::vector<bool> there(count, false);
    for (std::uint32_t set = 0; set < (1U << count); ++set) {
      bool adds = false;
      for (std::size_t i = 0; i < count; ++i) adds = adds || (Has(set, i) && !there[i]);
      if (!adds || !Supports(set) || Floats(set)) continue;
      for (std::size_t i = 0; i < count; ++i) there[i] = there[i] || Has(set, i);
    }
    return there;
  }

 private:
  static bool Has(std::uint32_t set, std::size_t thing) { return (set >> thing & 1U) != 0; }
  static bool Hold(const std::vector<RepairProblem::Clause>& clauses, std::uint32_t set) {
    for (const auto& clause : clauses) {
      bool holds = false;
      for (const std::size_t thing : clause) holds = holds || Has(set, thing);
      if (!holds) return false;
    }
    return true;
  }
  bool Stands(std::size_t i, std::uint32_t set) const {
    const auto& thing = problem_.things[i];
    return covered_[i] || (thing.present && Hold(thing.present_clauses, set));
  }
  bool Supports(std::uint32_t set) const {
    for (std::size_t i = 0; i < problem_.things.size(); ++i) {
      const auto& thing = problem_.things[i];
      if (!Has(set, i) || Stands(i, set)) continue;
      if (!thing.derives || !Hold(thing.clauses, set)) return false;
    }
    return true;
  }
  bool Floats(std::uint32_t set) const {
    std::uint32_t grounded = 0;
    for (std::uint32_t before = 1; before != grounded;) {
      before = grounded;
      for (std::size_t i = 0; i < problem_.things.size(); ++i) {
        const auto& thing = problem_.things[i];
        if (!Has(set, i)) continue;
        bool is = Stands(i, set) || thing.grounds;
        for (const auto& clause : thing.clauses) {
          for (const std::size_t other : clause) is = is || Has(grounded, other);
        }
        if (is) grounded |= 1U << i;
      }
    }
    return grounded != set;
  }

  const RepairProblem& problem_;
  std::vector<bool> covered_;
};

TEST(Repair, AThousandRandomProblemsAreSolvedAsByTryingEverySet) {
  int solvable = 0;
  int with_additions = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const RepairProblem problem = RandomRepairProblem(seed);
    const auto found = SmallestRepairs(problem);
    const auto all = AllRepairs(problem);
    ASSERT_TRUE(found.proven) << seed;
    ASSERT_EQ(found.sets.empty(), all.empty()) << seed;
    if (all.empty()) continue;
    EXPECT_EQ(found.sets.front().cost, all.front().cost) << seed;
    EXPECT_EQ(found.sets.front().additions, all.front().additions) << seed;
    for (const RepairSet& set : found.sets) EXPECT_TRUE(IsSolution(problem, set.additions)) << seed;
    ++solvable;
    with_additions += all.front().additions.empty() ? 0 : 1;
  }
  EXPECT_GT(solvable, 500);
  EXPECT_GT(with_additions, 300) << "the problems must be ones to solve";
}

TEST(Repair, WhatIsThereIsTheLargestSetThatSupportsItselfAndDoesNotFloat) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const RepairProblem problem = RandomRepairProblem(seed);
    std::mt19937 random(seed);
    const auto taken = Members(static_cast<std::uint32_t>(random()), problem.additions.size());
    ASSERT_EQ(Satisfied(problem, taken), Truth(problem, taken).There()) << seed;
  }
}

}  // namespace
}  // namespace lares::testing
