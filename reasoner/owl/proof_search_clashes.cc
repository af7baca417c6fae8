#include <algorithm>

#include "ontology/rdf/literal_value.h"
#include "reasoner/owl/proof_search.h"

namespace lares::owl {
namespace {

constexpr std::size_t kMaxClashes = 64;  // looked at for a proof of one

}  // namespace

std::optional<Proof> ProofSearch::WhyContradiction(const ProofOptions& options) {
  Start(options);
  const std::vector<rdf::Clash> clashes = Clashes();
  if (clashes.empty()) return std::nullopt;
  for (unsigned bound = 0; bound < kUnprovable;) {
    unsigned next = kUnprovable;
    for (const rdf::Clash& clash : clashes) {
      std::vector<Goal> goals;
      for (const rdf::Triple& premise : clash.premises) goals.push_back(GoalFor(premise, 0));
      unsigned cost = 0;
      if (SolveAll(goals, bound, &cost)) return WriteClash(clash, cost);
      next = std::min(next, cost);
    }
    bound = std::max(next, bound + 1);
  }
  throw Error(Code::kInternal, "no rule concludes what a contradiction rests on");
}

// What the layers list speaks of representatives where terms are the same; steps must fit word by
// word, so the same rules are asked again.
std::vector<rdf::Clash> ProofSearch::Clashes() {
  std::vector<rdf::Clash> listed, found;
  std::set<std::string, std::less<>> rules;
  for (const auto& layer : view_.layers()) {
    for (const rdf::Clash& clash : layer->clashes()) {
      listed.push_back(clash);
      rules.insert(clash.rule);
    }
  }
  if (listed.empty()) return {};
  std::vector<rdf::Clash> of_values;
  if (with_computed_) {
    for (const rdf::Clash& clash : listed) AddClashesOfValues(clash, &of_values);
  }
  Derivations::Options options;
  options.stop = options_.stop;
  options.wanted = [&](const Rule& rule) { return rules.contains(rule.name); };
  options.usable = [this](const rdf::Triple&) {
    Work();
    return true;
  };
  derivations_.ForEachClash(options, [&](const Step& step) {
    found.push_back({step.rule.name, {step.premises.begin(), step.premises.end()}});
    return found.size() < kMaxClashes;
  });
  if (found.empty() && !with_computed_) throw NoRule();
  found.insert(found.end(), of_values.begin(), of_values.end());
  return found.empty() ? listed : found;
}

// What table 8 says of literals is no row of the rules: eq-diff1 by dt-diff, and dt-not-type.
void ProofSearch::AddClashesOfValues(const rdf::Clash& clash, std::vector<rdf::Clash>* found) {
  const rdf::Dictionary& dictionary = view_.dictionary();
  const Vocabulary& words = derivations_.words();
  for (const auto& [s, p, o] : clash.premises) {
    if (clash.rule == "eq-diff1" && clash.premises.size() == 1 && p == words.same_as) {
      refused_.insert({dictionary.SameValue(s), dictionary.SameValue(o)});
      refused_.insert({dictionary.SameValue(o), dictionary.SameValue(s)});
      found->push_back({clash.rule, {{s, p, o}, {s, different_from_, o}}});
    }
    if (clash.rule != "dt-not-type" || p != words.type) continue;
    for (const rdf::TermId datatype : NamesOf(o)) {
      if (!rdf::IsSupportedDatatype(dictionary.Get(datatype).value)) continue;
      for (const rdf::TermId literal : NamesOf(s)) {
        if (dictionary.Kind(literal) != rdf::TermKind::kLiteral) continue;
        if (!IsOutsideDatatype(dictionary.Get(literal), dictionary.Get(datatype).value)) continue;
        found->push_back({clash.rule, {{literal, p, datatype}}});
      }
    }
  }
}

std::vector<rdf::TermId> ProofSearch::NamesOf(rdf::TermId term) const {
  if (view_.equality() == nullptr) return {term};
  const auto members = view_.equality()->Members(view_.equality()->Representative(term));
  if (members.empty()) return {term};
  return {members.begin(), members.end()};
}

}  // namespace lares::owl
