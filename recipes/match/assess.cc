#include "recipes/match/assess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace lares::recipes {

namespace {

using Verdict = Measure::Verdict;
using GroupVerdict = Assessment::Group::Verdict;

// -- numbers --

// How a part's value keeps a bound; of a span of stated values the worse end counts.
Measure Measured(const Bound& bound, const RobotProfile::Part& part) {
  Measure measure;
  measure.quantity = bound.quantity;
  measure.unit = bound.unit;
  measure.at_least = bound.least;
  measure.at_most = bound.most;
  measure.stated_by = bound.stated_by;
  for (const RobotProfile::Quantity& quantity : part.quantities) {
    if (quantity.property != bound.property) continue;
    measure.verdict = Verdict::kMet;
    measure.actual = bound.least ? quantity.least : quantity.most;
    const auto miss = [&](double end, double value, double by) {
      measure.verdict = Verdict::kInsufficient;
      measure.actual = value;
      measure.short_by = by;
      if (end != 0) measure.short_by_percent = 100 * by / end;
    };
    if (bound.most && quantity.most > *bound.most) {
      miss(*bound.most, quantity.most, quantity.most - *bound.most);
    }
    if (bound.least && quantity.least < *bound.least) {
      miss(*bound.least, quantity.least, *bound.least - quantity.least);
    }
  }
  return measure;
}

GroupVerdict VerdictOf(const std::vector<Measure>& measures) {
  GroupVerdict verdict = GroupVerdict::kMet;
  for (const Measure& measure : measures) {
    if (measure.verdict == Verdict::kInsufficient) return GroupVerdict::kInsufficient;
    if (measure.verdict == Verdict::kUnknown) verdict = GroupVerdict::kUnknown;
  }
  return verdict;
}

// The greatest part by which an end is missed: what makes one insufficient part better than
// another.
double Shortfall(const std::vector<Measure>& measures) {
  double most = 0;
  for (const Measure& measure : measures) {
    if (measure.verdict != Verdict::kInsufficient) continue;
    most = std::max(most, measure.short_by_percent.value_or(std::numeric_limits<double>::max()));
  }
  return most;
}

Assessment::Group JudgeGroup(const BoundGroup& group, const std::vector<std::size_t>& parts,
                             const RobotProfile& robot) {
  Assessment::Group best;
  const auto judge = [&](std::size_t index, const RobotProfile::Part& part) {
    Assessment::Group one;
    one.part = index;
    for (const Bound& bound : group.bounds) one.measures.push_back(Measured(bound, part));
    one.verdict = VerdictOf(one.measures);
    const bool is_better = std::tuple(one.verdict, Shortfall(one.measures)) <
                           std::tuple(best.verdict, Shortfall(best.measures));
    if (best.measures.empty() || is_better) best = std::move(one);
  };
  if (group.of_robot) {
    judge(0, robot.self);
  } else {
    for (const std::size_t part : parts) judge(part, robot.parts[part]);
  }
  if (!best.measures.empty()) return best;
  for (const Bound& bound : group.bounds) best.measures.push_back(Measured(bound, {}));
  return best;
}

// -- what the robot has --

class Assessor {
 public:
  Assessor(const Needs& needs, const RobotProfile& robot, const MatchOptions& options)
      : needs_(needs), robot_(robot), options_(options) {}

  Assessment Run() {
    result_.nodes.resize(needs_.nodes.size());
    FindParts();
    FindClaims();
    FindOffers();
    for (const BoundGroup& group : needs_.groups) {
      result_.groups.push_back(JudgeGroup(group, result_.nodes[group.part].parts, robot_));
    }
    for (std::size_t i = 0; i < needs_.nodes.size(); ++i) AddNode(i);
    for (const Assessment::Group& group : result_.groups) AddGroup(group);
    result_.problem.wanted = needs_.wanted;
    for (const Needs::StepGroup& step : needs_.step_groups) {
      result_.problem.wanted.push_back({ThingOf(step.group)});
    }
    Judge();
    if (!result_.feasible) AddAdditions();
    return std::move(result_);
  }

 private:
  std::size_t ThingOf(std::size_t group) const { return needs_.nodes.size() + group; }
  const std::vector<std::size_t>* NodesAbove(rdf::TermId term) const {
    const auto found = needs_.nodes_above.find(term);
    return found == needs_.nodes_above.end() ? nullptr : &found->second;
  }

  void FindParts() {
    for (const RobotProfile::Typed& typed : robot_.by_type) {
      const auto* above = NodesAbove(typed.type);
      if (above == nullptr) continue;
      for (const std::size_t node : *above) {
        std::vector<std::size_t>& parts = result_.nodes[node].parts;
        parts.insert(parts.end(), typed.parts.begin(), typed.parts.end());
      }
    }
    for (Assessment::Node& node : result_.nodes) {
      std::sort(node.parts.begin(), node.parts.end());
      node.parts.erase(std::unique(node.parts.begin(), node.parts.end()), node.parts.end());
    }
  }

  void FindClaims() {
    for (std::size_t c = 0; c < robot_.claims.size(); ++c) {
      std::set<std::size_t> claimed;
      for (const rdf::TermId term : robot_.claims[c].above) {
        if (const auto* above = NodesAbove(term)) claimed.insert(above->begin(), above->end());
      }
      for (const std::size_t node : claimed) {
        if (needs_.nodes[node].is_capability) result_.nodes[node].claims.push_back(c);
      }
    }
    for (Assessment::Node& node : result_.nodes) KeepMostSpecific(node.claims);
  }

  void KeepMostSpecific(std::vector<std::size_t>& claims) const {
    const std::vector<std::size_t> all = claims;
    std::erase_if(claims, [&](std::size_t claim) {
      return std::any_of(all.begin(), all.end(), [&](std::size_t other) {
        return other != claim && IsBelow(other, claim) && (!IsBelow(claim, other) || other < claim);
      });
    });
  }
  bool IsBelow(std::size_t claim, std::size_t other) const {
    const std::vector<rdf::TermId>& above = robot_.claims[claim].above;
    return std::binary_search(above.begin(), above.end(), robot_.claims[other].term);
  }

  void FindOffers() {
    for (std::size_t i = 0; i < options_.offers.size(); ++i) {
      const auto term = needs_.dictionary->FindIri(options_.offers[i].class_iri);
      const auto* above = term ? NodesAbove(*term) : nullptr;
      if (above == nullptr) continue;
      for (const std::size_t node : *above) {
        if (!needs_.nodes[node].is_capability) result_.nodes[node].offers.push_back(i);
      }
    }
  }

  // -- the problem --

  std::vector<Clause> GroupClauses(const NeedNode& node, bool only_insufficient) const {
    std::vector<Clause> clauses;
    for (const std::size_t group : node.groups) {
      if (only_insufficient && result_.groups[group].verdict != GroupVerdict::kInsufficient)
        continue;
      clauses.push_back({ThingOf(group)});
    }
    return clauses;
  }

  // What it takes when it is not simply there.
  std::vector<Clause> ClausesOf(const NeedNode& node) const {
    std::vector<Clause> clauses = node.requirements;
    if (node.is_capability && clauses.empty()) clauses.push_back(node.special_cases);
    const std::vector<Clause> groups = GroupClauses(node, false);
    clauses.insert(clauses.end(), groups.begin(), groups.end());
    return clauses;
  }

  void AddNode(std::size_t i) {
    const NeedNode& node = needs_.nodes[i];
    const Assessment::Node& found = result_.nodes[i];
    RepairProblem::Thing& thing = result_.problem.things.emplace_back();
    thing.clauses = ClausesOf(node);
    if (node.is_capability) {
      const bool claimed = !found.claims.empty();
      thing.present = claimed && (!options_.strict || node.requirements.empty());
      thing.present_clauses = GroupClauses(node, !options_.strict);
      thing.derives = !node.requirements.empty() || !node.special_cases.empty();
      thing.grounds = claimed;
    } else {
      thing.present = !found.parts.empty();
      thing.present_clauses = GroupClauses(node, true);
      thing.derives = thing.grounds = !found.offers.empty();
    }
  }

  void AddGroup(const Assessment::Group& group) {
    RepairProblem::Thing& thing = result_.problem.things.emplace_back();
    thing.present = group.verdict == GroupVerdict::kMet ||
                    (group.verdict == GroupVerdict::kUnknown && !options_.strict);
  }

  void Judge() {
    const std::vector<bool> there = Satisfied(result_.problem, {});
    for (std::size_t i = 0; i < result_.nodes.size(); ++i) result_.nodes[i].is_there = there[i];
    for (std::size_t i = 0; i < result_.groups.size(); ++i) {
      result_.groups[i].is_there = there[ThingOf(i)];
    }
    result_.feasible = IsSolution(result_.problem, {});
  }

  // -- what could be added --

  // What rests on parts, or on capabilities that are only claimed, comes with them; what rests on
  // nothing of the kind can only be claimed itself.
  bool CanBeAdded(std::size_t start) const {
    if (!needs_.nodes[start].is_capability || needs_.nodes[start].requirements.empty()) return true;
    std::vector<bool> seen(needs_.nodes.size(), false);
    std::vector<std::size_t> open{start};
    seen[start] = true;
    while (!open.empty()) {
      const NeedNode& node = needs_.nodes[open.back()];
      open.pop_back();
      if (!node.is_capability || node.requirements.empty()) return false;
      for (const Clause& clause : node.requirements) {
        for (const std::size_t next : clause) {
          if (seen[next]) continue;
          seen[next] = true;
          open.push_back(next);
        }
      }
    }
    return true;
  }

  static bool Agree(const Bound& a, const Bound& b) {
    if (a.property != b.property) return true;
    const auto low = std::max(a.least.value_or(0), b.least.value_or(0));
    const double high = std::min(a.most.value_or(std::numeric_limits<double>::infinity()),
                                 b.most.value_or(std::numeric_limits<double>::infinity()));
    return low <= high;
  }
  bool Agree(std::size_t a, std::size_t b) const {
    for (const Bound& one : needs_.groups[a].bounds) {
      for (const Bound& other : needs_.groups[b].bounds) {
        if (!Agree(one, other)) return false;
      }
    }
    return true;
  }

  // The groups that a new part of class `node` can be chosen to keep: all at once, or, where their
  // bounds contradict each other, several choices.
  std::vector<std::vector<std::size_t>> ChoicesOf(std::size_t node) const {
    std::vector<std::size_t> concerned;
    const std::vector<std::size_t>& above = needs_.nodes[node].above;
    for (std::size_t g = 0; g < needs_.groups.size(); ++g) {
      const std::size_t part = needs_.groups[g].part;
      if (!Agree(g, g)) continue;
      if (part == node || std::find(above.begin(), above.end(), part) != above.end()) {
        concerned.push_back(g);
      }
    }
    std::set<std::vector<std::size_t>> choices;
    for (const std::size_t first : concerned) {
      std::vector<std::size_t> choice{first};
      for (const std::size_t other : concerned) {
        const bool fits = std::all_of(choice.begin(), choice.end(), [&](std::size_t one) {
          return one != other && Agree(one, other);
        });
        if (fits) choice.push_back(other);
      }
      std::sort(choice.begin(), choice.end());
      choices.insert(std::move(choice));
    }
    if (choices.empty()) choices.insert(std::vector<std::size_t>{});
    return {choices.begin(), choices.end()};
  }

  void AddAdditions() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < needs_.nodes.size(); ++i) {
      if (CanBeAdded(i)) order.push_back(i);
    }
    // The general before the special.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return needs_.nodes[a].above.size() < needs_.nodes[b].above.size();
    });
    for (const std::size_t i : order) {
      for (std::vector<std::size_t>& groups : ChoicesOf(i)) AddAddition(i, std::move(groups));
    }
  }

  void AddAddition(std::size_t i, std::vector<std::size_t> groups) {
    const NeedNode& node = needs_.nodes[i];
    RepairProblem::Addition& addition = result_.problem.additions.emplace_back();
    addition.covers.push_back(i);
    addition.covers.insert(addition.covers.end(), node.above.begin(), node.above.end());
    for (const std::size_t group : groups) addition.covers.push_back(ThingOf(group));
    addition.clauses = GroupClauses(node, false);
    if (!node.is_capability) {
      addition.clauses.insert(addition.clauses.end(), node.requirements.begin(),
                              node.requirements.end());
    }
    addition.cost = std::max<std::int64_t>(1, std::llround(std::min(node.cost, 1e9) * kCostScale));
    result_.additions.push_back({i, std::move(groups)});
  }

  const Needs& needs_;
  const RobotProfile& robot_;
  const MatchOptions& options_;
  Assessment result_;
};

// The member of a clause that is taken: the first that is there, else the first.
std::size_t Taken(const Clause& clause, const Assessment& assessment) {
  for (const std::size_t node : clause) {
    if (assessment.nodes[node].is_there) return node;
  }
  return clause.front();
}

}  // namespace

Assessment Assess(const Needs& needs, const RobotProfile& robot, const MatchOptions& options) {
  return Assessor(needs, robot, options).Run();
}

std::vector<std::size_t> Downloaded(const Needs& needs, const Assessment& assessment,
                                    const MatchOptions& options) {
  std::set<std::size_t> downloaded;
  if (options.offers.empty()) return {};
  std::vector<bool> seen(needs.nodes.size(), false);
  std::vector<std::size_t> open;
  for (const Clause& clause : needs.wanted) {
    if (!clause.empty()) open.push_back(Taken(clause, assessment));
  }
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (seen[at]) continue;
    seen[at] = true;
    const RepairProblem::Thing& thing = assessment.problem.things[at];
    if (thing.present && thing.present_clauses.empty()) continue;
    if (!needs.nodes[at].is_capability && assessment.nodes[at].is_there) downloaded.insert(at);
    std::vector<Clause> clauses = needs.nodes[at].requirements;
    if (clauses.empty()) clauses.push_back(needs.nodes[at].special_cases);
    for (const Clause& clause : clauses) {
      if (!clause.empty()) open.push_back(Taken(clause, assessment));
    }
  }
  return {downloaded.begin(), downloaded.end()};
}

}  // namespace lares::recipes
