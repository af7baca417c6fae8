#include "recipes/match/explain.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "recipes/match/words.h"

namespace lares::recipes {

namespace {

using GroupVerdict = Assessment::Group::Verdict;
using Missing = std::vector<std::size_t>;  // things: nodes and groups

constexpr std::size_t kMaxFindings = 5000;  // of one report; what lies deeper is left out

std::vector<Measure> With(const std::vector<Measure>& measures, Measure::Verdict verdict) {
  std::vector<Measure> kept;
  for (const Measure& measure : measures) {
    if (measure.verdict == verdict) kept.push_back(measure);
  }
  return kept;
}

// A finding with what only the explanation of others needs.
struct Explained {
  Finding finding;
  Missing missing;
  std::set<std::size_t> rests_on;  // nodes
};

class Explainer {
 public:
  Explainer(const Needs& needs, const RobotProfile& robot, const MatchOptions& options,
            const Assessment& assessment)
      : needs_(needs), robot_(robot), options_(options), assessment_(assessment) {}

  void Run(MatchReport& report) {
    std::vector<Explained> found;
    std::vector<std::size_t> nodes;
    for (const Clause& clause : needs_.wanted) {
      nodes.push_back(clause.empty() ? 0 : Taken(clause));
      found.push_back(clause.empty() ? Explained{} : Node(nodes.back(), {}));
    }
    report.needs = StepNeeds(nodes);
    MarkDerivable(nodes, found);
    for (Explained& one : found) report.capabilities.push_back(std::move(one.finding));
    report.requirements = StepRequirements();
    for (const std::size_t node : Downloaded(needs_, assessment_, options_)) {
      for (const std::size_t offer : assessment_.nodes[node].offers) {
        report.downloads.push_back({needs_.nodes[node].what, options_.offers[offer]});
      }
    }
    report.warnings = std::move(warnings_);
  }

 private:
  std::size_t ThingOf(std::size_t group) const { return needs_.nodes.size() + group; }
  bool IsThere(std::size_t node) const { return assessment_.nodes[node].is_there; }
  const std::string& Label(std::size_t node) const { return needs_.nodes[node].what.label; }

  void Warn(const std::string& sentence) {
    if (std::find(warnings_.begin(), warnings_.end(), sentence) == warnings_.end()) {
      warnings_.push_back(sentence);
    }
  }

  // Of a union any member will do: the first that is there, else one with the least missing.
  std::size_t Taken(const Clause& clause) {
    if (clause.size() == 1) return clause.front();
    std::size_t best = clause.front();
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::size_t node : clause) {
      if (IsThere(node)) return node;
      std::vector<std::size_t> seen;
      const std::size_t missing = MissingBelow(node, seen);
      if (missing < least) {
        least = missing;
        best = node;
      }
    }
    return best;
  }

  // About how much is missing for a node.
  std::size_t MissingBelow(std::size_t node, std::vector<std::size_t>& seen) const {
    if (IsThere(node) || std::find(seen.begin(), seen.end(), node) != seen.end()) return 0;
    seen.push_back(node);
    const NeedNode& need = needs_.nodes[node];
    std::size_t missing = need.is_capability && !need.requirements.empty() ? 0 : 1;
    for (const Clause& clause : need.requirements) {
      if (!clause.empty()) missing += MissingBelow(clause.front(), seen);
    }
    return missing;
  }

  // The most specific of them, each once.
  Missing Distinct(Missing things) const {
    std::sort(things.begin(), things.end());
    things.erase(std::unique(things.begin(), things.end()), things.end());
    const Missing all = things;
    std::erase_if(things, [&](std::size_t thing) {
      return std::any_of(all.begin(), all.end(), [&](std::size_t other) {
        return other != thing && IsBelow(other, thing) && (!IsBelow(thing, other) || other < thing);
      });
    });
    return things;
  }
  bool IsBelow(std::size_t thing, std::size_t other) const {
    if (thing >= needs_.nodes.size()) return false;
    const std::vector<std::size_t>& above = needs_.nodes[thing].above;
    return std::find(above.begin(), above.end(), other) != above.end();
  }

  std::string Names(const Missing& things) const {
    std::vector<std::string> names;
    for (const std::size_t thing : things) {
      if (thing < needs_.nodes.size()) {
        names.push_back(Label(thing));
      } else {
        const std::size_t group = thing - needs_.nodes.size();
        names.push_back(WithArticle(Label(needs_.groups[group].part)) + " with " +
                        TextOf(assessment_.groups[group].measures));
      }
    }
    return Listed(names);
  }

  std::vector<Resource> PartsOf(std::size_t node) const {
    std::vector<Resource> parts;
    for (const std::size_t part : assessment_.nodes[node].parts) {
      parts.push_back(robot_.parts[part].what);
    }
    return parts;
  }

  Explained Node(std::size_t node, std::vector<std::size_t> above) {
    Explained explained;
    Finding& finding = explained.finding;
    finding.what = needs_.nodes[node].what;
    finding.kind =
        needs_.nodes[node].is_capability ? Finding::Kind::kCapability : Finding::Kind::kComponent;
    explained.rests_on.insert(node);
    if (std::find(above.begin(), above.end(), node) != above.end()) {
      finding.availability = Availability::kAvailable;
      finding.explanation = Label(node) + " is explained further up";
      return explained;
    }
    above.push_back(node);
    if (needs_.nodes[node].is_capability) {
      Capability(node, above, explained);
    } else {
      Component(node, above, explained);
    }
    return explained;
  }

  void Depend(Explained&& on, Explained& explained) {
    explained.missing.insert(explained.missing.end(), on.missing.begin(), on.missing.end());
    explained.rests_on.insert(on.rests_on.begin(), on.rests_on.end());
    explained.finding.dependencies.push_back(std::move(on.finding));
  }

  void Requirements(std::size_t node, const std::vector<std::size_t>& above, Explained& explained) {
    for (const Clause& clause : needs_.nodes[node].requirements) {
      if (clause.empty() || ++findings_ > kMaxFindings) continue;
      Depend(Node(Taken(clause), above), explained);
    }
  }

  // -- numbers --

  void Groups(std::size_t node, Explained& explained) {
    for (const std::size_t group : needs_.nodes[node].groups) {
      Depend(Group(group, needs_.nodes[node].what), explained);
    }
  }

  Explained Group(std::size_t index, const Resource& subject) {
    const Assessment::Group& group = assessment_.groups[index];
    const std::string& part_label = Label(needs_.groups[index].part);
    Explained explained;
    Finding& finding = explained.finding;
    finding.kind = Finding::Kind::kComponent;
    finding.what = needs_.nodes[needs_.groups[index].part].what;
    finding.measures = group.measures;
    if (!group.is_there) explained.missing.push_back(ThingOf(index));
    if (group.verdict == GroupVerdict::kAbsent) {
      finding.availability = Availability::kMissing;
      finding.explanation = "the robot's description lists no " + part_label + ", of which " +
                            subject.label + " requires " + TextOf(group.measures);
      return explained;
    }
    const Resource& part =
        needs_.groups[index].of_robot ? robot_.self.what : robot_.parts[group.part].what;
    finding.provided_by = {part};
    if (group.verdict == GroupVerdict::kMet) {
      finding.availability = Availability::kAvailable;
      finding.explanation =
          part.label + " has " + TextOf(group.measures) + ", as " + subject.label + " requires";
    } else if (group.verdict == GroupVerdict::kUnknown) {
      finding.availability = group.is_there ? Availability::kOnMakersWord : Availability::kMissing;
      finding.explanation = "the robot's description does not say whether " + part.label + " has " +
                            TextOf(With(group.measures, Measure::Verdict::kUnknown)) + ", as " +
                            subject.label + " requires";
      if (group.is_there) Warn(finding.explanation + ": taken on the maker's word");
    } else {
      const auto unmet = With(group.measures, Measure::Verdict::kInsufficient);
      std::vector<std::string> shorts;
      for (const Measure& measure : unmet) shorts.push_back(ShortText(measure));
      finding.availability = Availability::kInsufficient;
      finding.explanation = subject.label + " requires " + WithArticle(part_label) + " with " +
                            TextOf(unmet) + "; " + part.label + " has " + Listed(shorts);
    }
    return explained;
  }

  std::vector<StepRequirement> StepRequirements() {
    std::vector<StepRequirement> requirements;
    std::vector<std::size_t> groups;
    for (const Needs::StepGroup& step : needs_.step_groups) {
      const auto known = std::find(groups.begin(), groups.end(), step.group);
      if (known != groups.end()) {
        requirements[static_cast<std::size_t>(known - groups.begin())].steps.push_back(step.step);
        continue;
      }
      groups.push_back(step.group);
      requirements.push_back({{step.step}, Group(step.group, step.step).finding});
    }
    return requirements;
  }

  // -- components --

  void Component(std::size_t node, const std::vector<std::size_t>& above, Explained& explained) {
    Finding& finding = explained.finding;
    finding.provided_by = PartsOf(node);
    const RepairProblem::Thing& thing = assessment_.problem.things[node];
    const bool present = thing.present;
    const bool is_sound = std::all_of(
        thing.present_clauses.begin(), thing.present_clauses.end(), [&](const Clause& clause) {
          return assessment_.groups[clause.front() - needs_.nodes.size()].is_there;
        });
    if (present && is_sound) {
      finding.availability = Availability::kAvailable;
      finding.explanation = "the robot has " + Label(node);
      WarnOfAbsent(node);
      return;
    }
    if (IsThere(node)) {
      Requirements(node, above, explained);
      Groups(node, explained);
      finding.availability = Availability::kDownloadable;
      for (const std::size_t offer : assessment_.nodes[node].offers) {
        finding.downloads.push_back(options_.offers[offer]);
      }
      finding.explanation = Offered(node, finding.downloads);
      explained.missing.clear();
      return;
    }
    if (present) {
      Groups(node, explained);
      finding.availability = Availability::kInsufficient;
      finding.explanation = "the robot has " + Label(node) + ", but lacks " +
                            Names(Distinct(explained.missing)) + ", which it requires";
      return;
    }
    Requirements(node, above, explained);
    Groups(node, explained);
    explained.missing.push_back(node);
    explained.missing = Distinct(std::move(explained.missing));
    finding.availability = Availability::kMissing;
    finding.explanation = "the robot's description lists no " + Label(node);
  }

  std::string Offered(std::size_t node, const std::vector<Offer>& offers) const {
    std::vector<std::string> names;
    for (const Offer& offer : offers) {
      names.push_back(offer.document +
                      (offer.for_what.empty() ? "" : " (for " + offer.for_what + ")"));
    }
    return "the robot's description lists no " + Label(node) + "; " + Listed(names) +
           " can be downloaded";
  }

  // A part that is there is not doubted; only a warning says what it usually works with.
  void WarnOfAbsent(std::size_t node) {
    Missing absent;
    for (const Clause& clause : needs_.nodes[node].requirements) {
      const bool is_absent = std::none_of(clause.begin(), clause.end(), [&](std::size_t other) {
        return needs_.nodes[other].is_capability || !assessment_.nodes[other].parts.empty();
      });
      if (is_absent) absent.insert(absent.end(), clause.begin(), clause.end());
    }
    for (const std::size_t group : needs_.nodes[node].groups) {
      if (assessment_.groups[group].verdict != GroupVerdict::kMet) absent.push_back(ThingOf(group));
    }
    if (absent.empty()) return;
    Warn("the robot has " + Label(node) + ", which works with " + Names(absent) +
         " that its description does not list");
  }

  // -- capabilities --

  bool HasRequirements(std::size_t node) const { return !needs_.nodes[node].requirements.empty(); }

  void Capability(std::size_t node, const std::vector<std::size_t>& above, Explained& explained) {
    Finding& finding = explained.finding;
    const Assessment::Node& found = assessment_.nodes[node];
    finding.asserted = !found.claims.empty();
    for (const std::size_t claim : found.claims) {
      finding.provided_by.push_back(robot_.claims[claim].what);
    }
    if (HasRequirements(node)) {
      Requirements(node, above, explained);
    } else if (const auto special = SpecialCaseThatIsThere(node); special && !finding.asserted) {
      Depend(Node(*special, above), explained);
    }
    Groups(node, explained);
    explained.missing = Distinct(std::move(explained.missing));
    if (IsThere(node)) {
      Available(node, explained);
    } else {
      Unavailable(node, explained);
    }
  }

  std::optional<std::size_t> SpecialCaseThatIsThere(std::size_t node) const {
    for (const std::size_t special : needs_.nodes[node].special_cases) {
      if (IsThere(special)) return special;
    }
    return {};
  }

  void Available(std::size_t node, Explained& explained) {
    Finding& finding = explained.finding;
    finding.availability = Availability::kAvailable;
    if (!explained.missing.empty()) {
      finding.availability = Availability::kOnMakersWord;
      finding.explanation = Label(node) +
                            " is there on the maker's word only: the robot's description claims "
                            "it, but lists no " +
                            Names(explained.missing);
      Warn(finding.explanation);
    } else if (HasRequirements(node)) {
      finding.explanation = "everything that " + Label(node) + " depends on is there";
    } else if (finding.asserted) {
      finding.explanation = "the robot's description claims " + Label(node) +
                            ", and nothing is known that it depends on";
    } else if (!finding.dependencies.empty()) {
      finding.explanation = finding.dependencies.front().what.label + ", a special case of " +
                            Label(node) + ", is there";
    }
    explained.missing.clear();
  }

  void Unavailable(std::size_t node, Explained& explained) {
    Finding& finding = explained.finding;
    if (explained.missing.empty()) explained.missing = {node};
    const bool only_numbers =
        std::all_of(explained.missing.begin(), explained.missing.end(), [&](std::size_t thing) {
          return thing >= needs_.nodes.size() &&
                 assessment_.groups[thing - needs_.nodes.size()].verdict ==
                     GroupVerdict::kInsufficient;
        });
    finding.availability = only_numbers ? Availability::kInsufficient : Availability::kMissing;
    finding.explanation = explained.missing == Missing{node}
                              ? "the robot's description does not claim " + Label(node) +
                                    ", and nothing is known from which it would follow"
                              : Label(node) + " lacks " + Names(explained.missing);
  }

  // -- the whole --

  // In the report a union is the member that was taken.
  std::vector<Need> StepNeeds(const std::vector<std::size_t>& taken) const {
    std::vector<Need> needs;
    for (const Needs::StepNeed& step : needs_.steps) {
      Need need = step.need;
      if (need.capability.iri.empty()) {
        if (step.wanted.empty()) continue;
        const auto wanted = std::find(needs_.wanted.begin(), needs_.wanted.end(), step.wanted);
        if (wanted == needs_.wanted.end()) continue;
        const auto index = static_cast<std::size_t>(wanted - needs_.wanted.begin());
        need.capability = needs_.nodes[taken[index]].what;
      }
      needs.push_back(std::move(need));
    }
    return needs;
  }

  // A missing capability all of whose missing things are those of other missing capabilities that
  // it rests on comes with them.
  void MarkDerivable(const std::vector<std::size_t>& nodes, std::vector<Explained>& found) const {
    std::vector<std::size_t> derivable;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Missing& missing = found[i].missing;
      if (!IsLacking(found[i].finding) || missing.empty()) continue;
      if (std::find(missing.begin(), missing.end(), nodes[i]) != missing.end()) continue;
      std::set<std::size_t> covered;
      for (std::size_t other = 0; other < found.size(); ++other) {
        if (other == i || !IsLacking(found[other].finding)) continue;
        if (!found[i].rests_on.contains(nodes[other])) continue;
        if (found[other].rests_on.contains(nodes[i])) continue;
        covered.insert(found[other].missing.begin(), found[other].missing.end());
      }
      const bool all = std::all_of(missing.begin(), missing.end(),
                                   [&](std::size_t thing) { return covered.contains(thing); });
      if (all) derivable.push_back(i);
    }
    for (const std::size_t i : derivable) {
      found[i].finding.availability = Availability::kDerivable;
      found[i].finding.explanation =
          Label(nodes[i]) + " is missing, and comes with the other missing things";
    }
  }
  static bool IsLacking(const Finding& finding) {
    return finding.availability == Availability::kMissing ||
           finding.availability == Availability::kInsufficient;
  }

  const Needs& needs_;
  const RobotProfile& robot_;
  const MatchOptions& options_;
  const Assessment& assessment_;
  std::vector<std::string> warnings_;
  std::size_t findings_ = 0;
};

}  // namespace

void Explain(const Needs& needs, const RobotProfile& robot, const MatchOptions& options,
             const Assessment& assessment, MatchReport& report) {
  Explainer(needs, robot, options, assessment).Run(report);
}

}  // namespace lares::recipes
