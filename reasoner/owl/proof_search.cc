#include "reasoner/owl/proof_search.h"

#include <algorithm>

#include "reasoner/owl/flat_map.h"

namespace lares::owl {
namespace {

constexpr unsigned kRepeated = kUnprovable + 1;

Error TooDeep(unsigned depth) {
  return Error(Code::kTooLarge, "the proof is more than " + std::to_string(depth) + " steps deep");
}

}  // namespace

std::size_t ProofSearch::GoalHash::operator()(const Goal& goal) const {
  const auto [s, p, o] = goal.triple;
  const std::uint64_t ends = PairKey(static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(o));
  return MixBits(MixBits(ends) + (std::uint64_t{goal.avoids} << 32) +
                 static_cast<std::uint32_t>(p));
}

ProofSearch::Tactic ProofSearch::TacticOf(std::string_view rule) {
  if (rule == "prp-trp" || rule == "scm-sco" || rule == "scm-spo" || rule == "eq-trans" ||
      rule == "eq-sym") {
    return {kPath, 0};
  }
  if (rule == "eq-rep-s") return {kReplaceSubject, kReplaceSubject};
  if (rule == "eq-rep-o") return {kReplaceObject, kReplaceSubject | kReplaceObject};
  if (rule == "eq-rep-p") {
    return {kReplacePredicate, kReplaceSubject | kReplaceObject | kReplacePredicate};
  }
  if (rule == "cax-sco") return {kSubClass, kSubClass};
  if (rule == "prp-spo1") return {kSubProperty, kSubProperty};
  return {};
}

ProofSearch::ProofSearch(rdf::View view, bool with_computed)
    : derivations_(view, with_computed ? Derivations::Holds([view](const rdf::Triple& triple) {
                     return Holds(view, triple).has_value();
                   })
                                       : Derivations::Holds()),
      view_(derivations_.view()),
      with_computed_(with_computed) {
  for (const Rule& rule : derivations_.rules()) {
    tactics_.resize(std::max<std::size_t>(tactics_.size(), rule.number + 1));
    tactics_[rule.number] = TacticOf(rule.name);
    table_of_[rule.name] = rule.table;
  }
  transitive_property_ = view_.dictionary().InternIri(Expand("owl:TransitiveProperty"));
  different_from_ = view_.dictionary().InternIri(Expand("owl:differentFrom"));
}

std::optional<Proof> ProofSearch::Why(const rdf::Triple& triple, const ProofOptions& options) {
  Start(options);
  std::optional<Reason> reason;
  if (!view_.Contains(triple)) {
    reason = HoldsByItself(view_, triple);
    if (reason) return OneStep(triple, *reason);
    reason = Holds(view_, triple);
    if (!reason) return std::nullopt;
    const bool is_thing = triple.object == derivations_.words().thing;
    if (is_thing && reason->rule == "scm-cls") return OneStep(triple, *reason);
    if (!with_computed_) throw NoRule();
  }
  const Goal goal = GoalFor(triple, 0);
  if (Lower(goal) > 0 && !Solve(goal, kUnprovable - 1)) {
    if (!reason || reason->rule.empty()) throw NoRule();
    return OneStep(triple, *reason);  // as far as can be told
  }
  return Write(goal);
}

void ProofSearch::Start(const ProofOptions& options) {
  options_ = options;
  if (path_properties_.empty()) FindPathProperties();
  work_ = 0;
  depth_ = 0;
}

Error ProofSearch::NoRule() {
  return Error(Code::kInternal, "no rule concludes it, but it is there");
}

// Whether it follows; for premises of the search that computes.
bool ProofSearch::IsTrue(const rdf::Triple& triple) const {
  return derivations_.known().Contains(triple) ||
         (with_computed_ && (IsRefused(triple) || Holds(view_, triple).has_value()));
}

// An equality of two values that the engine concluded and did not believe.
bool ProofSearch::IsRefused(const rdf::Triple& triple) const {
  const auto [s, p, o] = triple;
  return p == derivations_.words().same_as &&
         refused_.contains({view_.dictionary().SameValue(s), view_.dictionary().SameValue(o)});
}

void ProofSearch::Work() {
  if (++work_ > options_.max_work) {
    throw Error(Code::kTooLarge,
                "no proof after looking at " + std::to_string(options_.max_work) + " triples");
  }
  if (work_ % 256 == 0 && options_.stop.stop_requested()) {
    throw Error(Code::kTimeout, "stopped while looking for a proof");
  }
}

// Rules about paths know better than the others what not to look at twice.
ProofSearch::Goal ProofSearch::GoalFor(const rdf::Triple& triple, unsigned avoids) const {
  return {triple, avoids != 0 && IsPath(triple.predicate) ? avoids & kPath : avoids};
}

ProofSearch::Known& ProofSearch::Recall(const Goal& goal) {
  const auto [found, is_new] = known_.try_emplace(goal);
  if (!is_new) return found->second;
  Known& known = found->second;
  if (view_.IsAsserted(goal.triple)) {
    known.cost = {0, true};
  } else if (with_computed_) {
    if (const auto reason = HoldsByItself(view_, goal.triple)) {
      known.cost = {1, true};
      known.computed = reason->rule;
    } else if (!IsTrue(goal.triple)) {
      known.cost = {kUnprovable, false};
    }
  }
  return known;
}
Derivations::Options ProofSearch::OptionsFor(rdf::TermId p, unsigned avoids,
                                             Derivations::Holds usable) {
  // Replacing in an equality is a path too.
  if ((avoids & kPath) != 0 && p == derivations_.words().same_as) {
    avoids |= kReplaceSubject | kReplaceObject;
  }
  Derivations::Options options;
  options.usable = std::move(usable);
  options.wanted = [this, avoids](const Rule& rule) {
    return (tactics_[rule.number].kind & avoids) == 0;
  };
  options.stop = options_.stop;
  return options;
}

// Whether there is a proof of at most that cost; Recall(goal) knows it then, and knows a better
// lower bound otherwise. Bounds are tried one after the other, so the first proof found is a
// cheapest one, and a goal never comes up again in its own proof: less is left for it there than
// it is known to cost.
bool ProofSearch::Solve(const Goal& goal, unsigned budget) {
  Known& known = Recall(goal);
  while (!known.cost.is_exact && known.cost.lower <= budget) {
    if (depth_ > kMaxDepth) throw TooDeep(kMaxDepth);
    ++depth_;
    if ((goal.avoids & kPath) == 0 && IsPath(goal.triple.predicate)) {
      const auto [s, p, o] = goal.triple;
      const ProofCost cost = PathsTo(p, o).CostFrom(s, budget);
      if (!cost.is_exact && cost.lower <= budget) {
        throw Error(Code::kInternal, "a path was asked for within itself");
      }
      known.cost = cost;
    } else {
      Try(goal, known);
    }
    --depth_;
  }
  return known.cost.is_exact && known.cost.lower <= budget;
}

// Proofs that cost exactly what `known` has as lower bound.
void ProofSearch::Try(const Goal& goal, Known& known) {
  const unsigned bound = known.cost.lower;
  unsigned next = kUnprovable;
  const auto usable = [&](const rdf::Triple& triple) {
    Work();
    const unsigned lower = Lower({triple, 0});
    if (lower >= bound) next = std::min(next, std::max(lower, bound) + 1);
    return lower < bound;
  };
  const auto [s, p, o] = goal.triple;
  derivations_.ForEach({s, p, o}, OptionsFor(p, goal.avoids, usable), [&](const Step& step) {
    unsigned cost = 0;
    std::vector<Goal> premises = PremisesOf(step.rule, step.premises);
    if (!SolveAll(premises, bound - 1, &cost)) {
      next = std::min(next, std::max(cost, bound) + 1);
      return true;
    }
    known.cost = {1 + cost, true};
    known.rule = &step.rule;
    known.premises = std::move(premises);
    return false;
  });
  if (!known.cost.is_exact) known.cost.lower = std::max(bound + 1, next);
}

std::vector<ProofSearch::Goal> ProofSearch::PremisesOf(
    const Rule& rule, std::span<const rdf::Triple> premises) const {
  std::vector<Goal> goals;
  for (std::size_t i = 0; i < premises.size(); ++i) {
    const bool is_last = i + 1 == premises.size();
    goals.push_back(GoalFor(premises[i], is_last ? tactics_[rule.number].last_avoids : 0));
  }
  return goals;
}

// Whether all can be proved for `budget` together, each triple once; `cost` is the cost, or a
// lower bound.
bool ProofSearch::SolveAll(const std::vector<Goal>& goals, unsigned budget, unsigned* cost) {
  std::vector<unsigned> lower;
  unsigned sum = 0;
  for (auto goal = goals.begin(); goal != goals.end(); ++goal) {
    const auto same = [&](const Goal& other) { return other.triple == goal->triple; };
    lower.push_back(std::any_of(goals.begin(), goal, same) ? kRepeated : Lower(*goal));
    if (lower.back() != kRepeated) sum = std::min(kUnprovable, sum + lower.back());
  }
  for (std::size_t i = 0; i < goals.size() && sum <= budget; ++i) {
    if (lower[i] == kRepeated) continue;
    Solve(goals[i], budget - (sum - lower[i]));
    sum = std::min(kUnprovable, sum - lower[i] + Lower(goals[i]));
  }
  *cost = sum;
  return sum <= budget;
}

}  // namespace lares::owl
