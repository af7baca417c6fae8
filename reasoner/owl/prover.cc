#include "reasoner/owl/prover.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "ontology/rdf/literal_value.h"
#include "reasoner/owl/derivations.h"
#include "reasoner/owl/flat_map.h"
#include "reasoner/owl/on_demand.h"
#include "reasoner/owl/proof_paths.h"
#include "reasoner/owl/values.h"

namespace lares::owl {
namespace {

constexpr std::size_t kWorkOfFirstSearch = 1'000'000;
constexpr std::size_t kWorkWhereLiteralsMatter = 50'000;  // of the first search
constexpr unsigned kRepeated = kUnprovable + 1;
constexpr std::size_t kMaxClashes = 64;  // looked at for a proof of one
constexpr unsigned kMaxDepth = 400;      // of proofs within proofs; paths do not count

// Two steps of the same kind in a row can be made one without another cost (x a b, b ⊑ c, c ⊑ d:
// first join the axioms, or first the individual). So what the second rests on need not be looked
// for among the conclusions of the first: a goal says which rules it is not to end in.
enum Avoid : unsigned {
  kPath = 1,
  kReplaceSubject = 2,
  kReplaceObject = 4,
  kReplacePredicate = 8,
  kSubClass = 16,
  kSubProperty = 32,
};

struct Tactic {
  unsigned kind = 0;         // goals that avoid any of this do not try the rule
  unsigned last_avoids = 0;  // what the goal of its last premise avoids
};

Tactic TacticOf(std::string_view rule) {
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

struct Goal {
  rdf::Triple triple;
  unsigned avoids = 0;

  friend bool operator==(const Goal&, const Goal&) = default;
};

struct GoalHash {
  std::size_t operator()(const Goal& goal) const {
    const auto [s, p, o] = goal.triple;
    const std::uint64_t ends =
        PairKey(static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(o));
    return MixBits(MixBits(ends) + (std::uint64_t{goal.avoids} << 32) +
                   static_cast<std::uint32_t>(p));
  }
};

struct Known {
  ProofCost cost;
  const Rule* rule = nullptr;  // of the cheapest proof, when it is known and has one
  std::vector<Goal> premises;
  std::string_view computed;  // the rule by which it holds without being stored
};

bool LiteralsMatter(const rdf::View& view) {
  if (DependsOnValues(view)) return true;
  if (view.equality() == nullptr) return false;
  return !view.equality()->ForEachClass([&](std::span<const rdf::TermId> members) {
    return std::none_of(members.begin(), members.end(), [&](rdf::TermId term) {
      return view.dictionary().Kind(term) == rdf::TermKind::kLiteral;
    });
  });
}

}  // namespace

class Prover::Search {
 public:
  // Premises that hold without being stored are looked at only when asked for: few proofs need
  // them, and they make every search slower.
  Search(rdf::View view, bool with_computed)
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

  std::optional<Proof> Why(const rdf::Triple& triple, const ProofOptions& options) {
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

  std::optional<Proof> WhyContradiction(const ProofOptions& options) {
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

 private:
  void Start(const ProofOptions& options) {
    options_ = options;
    if (path_properties_.empty()) FindPathProperties();
    work_ = 0;
    depth_ = 0;
  }

  static Error NoRule() { return Error(Code::kInternal, "no rule concludes it, but it is there"); }

  Proof OneStep(const rdf::Triple& triple, const Reason& reason) const {
    return {{{triple, std::string(reason.rule), TableOf(reason.rule), {}, {}}}, 1};
  }

  // Whether it follows; for premises of the search that computes.
  bool IsTrue(const rdf::Triple& triple) const {
    return derivations_.known().Contains(triple) ||
           (with_computed_ && (IsRefused(triple) || Holds(view_, triple).has_value()));
  }

  // An equality of two values that the engine concluded and did not believe.
  bool IsRefused(const rdf::Triple& triple) const {
    const auto [s, p, o] = triple;
    return p == derivations_.words().same_as &&
           refused_.contains({view_.dictionary().SameValue(s), view_.dictionary().SameValue(o)});
  }

  void Work() {
    if (++work_ > options_.max_work) {
      throw Error(Code::kTooLarge,
                  "no proof after looking at " + std::to_string(options_.max_work) + " triples");
    }
    if (work_ % 256 == 0 && options_.stop.stop_requested()) {
      throw Error(Code::kTimeout, "stopped while looking for a proof");
    }
  }

  // What the layers list speaks of representatives where terms are the same; steps must fit word by
  // word, so the same rules are asked again.
  std::vector<rdf::Clash> Clashes() {
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
  void AddClashesOfValues(const rdf::Clash& clash, std::vector<rdf::Clash>* found) {
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

  std::vector<rdf::TermId> NamesOf(rdf::TermId term) const {
    if (view_.equality() == nullptr) return {term};
    const auto members = view_.equality()->Members(view_.equality()->Representative(term));
    if (members.empty()) return {term};
    return {members.begin(), members.end()};
  }

  // ---- What is transitive -----------------------------------------------------------------------

  bool IsPath(rdf::TermId p) const { return path_properties_.contains(p); }

  // Before the first question: what a step along a property costs has to be known by the time that
  // there are paths of it. Until then its steps are like those of any other rule.
  void FindPathProperties() {
    const Vocabulary& words = derivations_.words();
    path_properties_ = {words.same_as, words.sub_class_of, words.sub_property_of};
    std::vector<rdf::TermId> inferred;
    for (const rdf::TermId p : view_.Subjects(words.type, transitive_property_)) {
      if (view_.IsAsserted({p, words.type, transitive_property_})) {
        path_properties_.insert(p);
      } else {
        inferred.push_back(p);
      }
    }
    std::sort(inferred.begin(), inferred.end());
    for (const rdf::TermId p : inferred) {
      try {
        work_ = depth_ = 0;
        if (Solve({{p, words.type, transitive_property_}, 0}, kMaxDepth))
          path_properties_.insert(p);
      } catch (const Error& error) {
        if (error.code() != Code::kTooLarge) throw;  // it can do without paths
      }
    }
  }

  // Rules about paths know better than the others what not to look at twice.
  Goal GoalFor(const rdf::Triple& triple, unsigned avoids) {
    return {triple, avoids != 0 && IsPath(triple.predicate) ? avoids & kPath : avoids};
  }

  // That P is transitive, when this has to be said.
  std::optional<Goal> TransitivityOf(rdf::TermId p) {
    const Vocabulary& words = derivations_.words();
    if (p == words.same_as || p == words.sub_class_of || p == words.sub_property_of) return {};
    return Goal{{p, words.type, transitive_property_}, 0};
  }

  ProofPaths& PathsTo(rdf::TermId p, rdf::TermId target) {
    auto& paths =
        paths_[PairKey(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(target))];
    if (paths) return *paths;
    unsigned step = 1;
    if (const auto transitivity = TransitivityOf(p)) step += Lower(*transitivity);
    ProofPaths::Edges edges;
    edges.at = [this, p](rdf::TermId node, const auto& add) { EdgesAt(p, node, add); };
    edges.cost = [this](const rdf::Triple& edge) { return Recall({edge, kPath}).cost; };
    edges.better_cost = [this](const rdf::Triple& edge) {
      const Goal goal{edge, kPath};
      Solve(goal, Recall(goal).cost.lower);
      return Recall(goal).cost;
    };
    paths = std::make_unique<ProofPaths>(target, step, std::move(edges));
    return *paths;
  }

  void EdgesAt(rdf::TermId p, rdf::TermId node,
               const std::function<void(const ProofPaths::Edge&)>& add) {
    AddEdges(p, node, false, add);
    if (p != derivations_.words().same_as) return;
    AddEdges(p, node, true, add);
    if (!with_computed_) return;
    for (const rdf::TermId twin : view_.dictionary().ValueTwins(node)) {
      if (twin != node) add({{twin, p, node}, false});  // dt-eq
    }
  }

  void AddEdges(rdf::TermId p, rdf::TermId node, bool backwards,
                const std::function<void(const ProofPaths::Edge&)>& add) {
    const auto& asserted = backwards ? AssertedOf(p).from : AssertedOf(p).to;
    const auto found = asserted.find(node);
    if (found != asserted.end()) {
      for (const rdf::TermId other : found->second) {
        add({backwards ? rdf::Triple{node, p, other} : rdf::Triple{other, p, node}, backwards});
      }
    }
    std::vector<rdf::Triple> derived;
    const rdf::Pattern goal = backwards ? rdf::Pattern{node, p, {}} : rdf::Pattern{{}, p, node};
    derivations_.ForEach(goal, OptionsFor(p, kPath, {}), [&](const Step& step) {
      Work();
      derived.push_back(step.conclusion);
      return true;
    });
    std::sort(derived.begin(), derived.end());
    derived.erase(std::unique(derived.begin(), derived.end()), derived.end());
    for (const rdf::Triple& triple : derived) {
      if (IsTrue(triple)) add({triple, backwards});
    }
  }

  struct Neighbours {
    std::unordered_map<rdf::TermId, std::vector<rdf::TermId>> to, from;
  };

  const Neighbours& AssertedOf(rdf::TermId p) {
    auto& kept = asserted_[p];
    if (kept) return *kept;
    kept = std::make_unique<Neighbours>();
    for (const auto& layer : view_.layers()) {
      for (const rdf::Graph& graph : layer->graphs()) {
        for (const rdf::Triple& triple : graph.triples) {
          if (triple.predicate != p) continue;
          kept->to[triple.object].push_back(triple.subject);
          kept->from[triple.subject].push_back(triple.object);
        }
      }
    }
    return *kept;
  }

  // ---- Search -----------------------------------------------------------------------------------

  Known& Recall(const Goal& goal) {
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
  unsigned Lower(const Goal& goal) { return Recall(goal).cost.lower; }

  Derivations::Options OptionsFor(rdf::TermId p, unsigned avoids, Derivations::Holds usable) {
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

  static Error TooDeep() {
    return Error(Code::kTooLarge,
                 "the proof is more than " + std::to_string(kMaxDepth) + " steps deep");
  }

  // Whether there is a proof of at most that cost; Recall(goal) knows it then, and knows a better
  // lower bound otherwise. Bounds are tried one after the other, so the first proof found is a
  // cheapest one, and a goal never comes up again in its own proof: less is left for it there than
  // it is known to cost.
  bool Solve(const Goal& goal, unsigned budget) {
    Known& known = Recall(goal);
    while (!known.cost.is_exact && known.cost.lower <= budget) {
      if (depth_ > kMaxDepth) throw TooDeep();
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
  void Try(const Goal& goal, Known& known) {
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

  std::vector<Goal> PremisesOf(const Rule& rule, std::span<const rdf::Triple> premises) {
    std::vector<Goal> goals;
    for (std::size_t i = 0; i < premises.size(); ++i) {
      const bool is_last = i + 1 == premises.size();
      goals.push_back(GoalFor(premises[i], is_last ? tactics_[rule.number].last_avoids : 0));
    }
    return goals;
  }

  // Whether all can be proved for `budget` together, each triple once; `cost` is the cost, or a
  // lower bound.
  bool SolveAll(const std::vector<Goal>& goals, unsigned budget, unsigned* cost) {
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

  // ---- Writing ----------------------------------------------------------------------------------

  struct Writer {
    Proof* proof;
    std::unordered_map<Goal, std::size_t, GoalHash> index;  // by triple alone
  };

  Proof Write(const Goal& goal) {
    Proof proof;
    proof.cost = Lower(goal);
    Writer writer{&proof, {}};
    WriteGoal(goal, writer);
    return WithoutSpare(std::move(proof));
  }

  // A path may have been written in part before it turns out that the rest is there already.
  static Proof WithoutSpare(Proof proof) {
    std::vector<bool> serves(proof.nodes.size(), false);
    serves.back() = true;
    for (std::size_t i = proof.nodes.size(); i-- > 0;) {
      if (!serves[i]) continue;
      for (const std::size_t premise : proof.nodes[i].premises) serves[premise] = true;
    }
    std::vector<std::size_t> place(proof.nodes.size());
    std::vector<ProofNode> kept;
    for (std::size_t i = 0; i < proof.nodes.size(); ++i) {
      if (!serves[i]) continue;
      place[i] = kept.size();
      for (std::size_t& premise : proof.nodes[i].premises) premise = place[premise];
      kept.push_back(std::move(proof.nodes[i]));
    }
    proof.nodes = std::move(kept);
    return proof;
  }

  std::size_t Add(ProofNode node, Writer& writer) {
    const std::size_t index = writer.proof->nodes.size();
    writer.index.emplace(Goal{node.triple, 0}, index);
    writer.proof->nodes.push_back(std::move(node));
    return index;
  }

  std::size_t WriteGoal(const Goal& goal, Writer& writer) {
    const auto found = writer.index.find({goal.triple, 0});
    if (found != writer.index.end()) return found->second;
    const Known& known = Recall(goal);
    if (known.cost.lower == 0) {
      return Add({goal.triple, "", 0, {}, view_.GraphsOf(goal.triple)}, writer);
    }
    if (!known.computed.empty()) {
      return Add({goal.triple, std::string(known.computed), TableOf(known.computed), {}, {}},
                 writer);
    }
    if (known.rule == nullptr) return WritePath(goal, writer);
    ProofNode node{goal.triple, known.rule->name, known.rule->table, {}, {}};
    for (const Goal& premise : known.premises) node.premises.push_back(WriteGoal(premise, writer));
    return Add(std::move(node), writer);
  }

  // From the end of the path to its beginning.
  std::size_t WritePath(const Goal& goal, Writer& writer) {
    const auto [source, p, target] = goal.triple;
    const ProofPaths& paths = PathsTo(p, target);
    std::vector<const ProofPaths::Link*> links;
    rdf::TermId node_on_path = source;  // there may be a circle
    do {
      const ProofPaths::Link* link = paths.LinkFrom(node_on_path);
      if (link == nullptr) {
        throw Error(Code::kTooLarge, "the way of a proof by transitivity was left unfinished");
      }
      links.push_back(link);
      node_on_path = link->next;
    } while (node_on_path != target);
    std::size_t rest = 0;
    for (auto link = links.rbegin(); link != links.rend(); ++link) {
      const ProofPaths::Edge& edge = (*link)->edge;
      const bool is_final = (*link)->next == target;
      if (is_final && !edge.is_backwards) {
        rest = WriteGoal({edge.triple, kPath}, writer);
        continue;
      }
      const rdf::TermId from = edge.is_backwards ? edge.triple.object : edge.triple.subject;
      const rdf::Triple conclusion{from, p, target};
      const auto found = writer.index.find({conclusion, 0});
      if (found != writer.index.end()) {
        rest = found->second;
        continue;
      }
      const std::string rule = RuleOfStep(p, edge.is_backwards, is_final);
      ProofNode node{conclusion, rule, TableOf(rule), {}, {}};
      if (rule == "prp-trp") node.premises.push_back(WriteGoal(*TransitivityOf(p), writer));
      node.premises.push_back(WriteGoal({edge.triple, kPath}, writer));
      if (!is_final) node.premises.push_back(rest);
      rest = Add(std::move(node), writer);
    }
    return rest;
  }

  std::string RuleOfStep(rdf::TermId p, bool is_backwards, bool is_final) const {
    const Vocabulary& words = derivations_.words();
    if (p == words.same_as) return is_final ? "eq-sym" : is_backwards ? "eq-rep-s" : "eq-trans";
    if (p == words.sub_class_of) return "scm-sco";
    return p == words.sub_property_of ? "scm-spo" : "prp-trp";
  }

  Proof WriteClash(const rdf::Clash& clash, unsigned cost) {
    Proof proof;
    proof.cost = 1 + cost;
    Writer writer{&proof, {}};
    ProofNode node{{}, clash.rule, TableOf(clash.rule), {}, {}};
    for (const rdf::Triple& premise : clash.premises) {
      node.premises.push_back(WriteGoal(GoalFor(premise, 0), writer));
    }
    proof.nodes.push_back(std::move(node));
    return WithoutSpare(std::move(proof));
  }

  int TableOf(std::string_view rule) const {
    const auto row = table_of_.find(rule);
    if (row != table_of_.end()) return row->second;
    for (const AxiomRow& axiom : AxiomTable()) {
      if (rule == axiom.name) return axiom.table;
    }
    return rule == "eq-ref" ? 4 : rule.starts_with("dt-") ? 8 : 9;
  }

  Derivations derivations_;
  const rdf::View& view_;
  bool with_computed_;
  rdf::TermId transitive_property_{}, different_from_{};
  std::set<std::pair<rdf::TermId, rdf::TermId>> refused_;  // by value
  std::set<rdf::TermId> path_properties_;                  // empty before the first question
  std::vector<Tactic> tactics_;                            // by number of the rule
  std::map<std::string, int, std::less<>> table_of_;
  std::unordered_map<Goal, Known, GoalHash> known_;
  std::unordered_map<std::uint64_t, std::unique_ptr<ProofPaths>> paths_;
  std::unordered_map<rdf::TermId, std::unique_ptr<Neighbours>> asserted_;
  ProofOptions options_;
  std::size_t work_ = 0;
  unsigned depth_ = 0;
};

Prover::Prover(rdf::View view)
    : view_(std::move(view)), plain_(std::make_unique<Search>(view_, false)) {}
Prover::~Prover() = default;

// What a search has worked out it knows when it is asked again.
template <typename Ask>
std::optional<Proof> Prover::Try(const ProofOptions& options, const Ask& ask) {
  for (const std::size_t work : {kWorkWhereLiteralsMatter, kWorkOfFirstSearch}) {
    ProofOptions first = options;
    first.max_work = std::min(first.max_work, work);
    try {
      return ask(*plain_, first);
    } catch (const Error& error) {
      if (error.code() != Code::kTooLarge && error.code() != Code::kInternal) throw;
      const bool was_stopped_early = error.code() == Code::kTooLarge && first.max_work == work;
      if (!was_stopped_early || LiteralsMatter(view_)) break;
    }
  }
  if (!computing_) computing_ = std::make_unique<Search>(view_, true);
  return ask(*computing_, options);
}

std::optional<Proof> Prover::Why(const rdf::Triple& triple, const ProofOptions& options) {
  return Try(options, [&](Search& search, const ProofOptions& limits) {
    return search.Why(triple, limits);
  });
}

std::optional<Proof> Prover::WhyContradiction(const ProofOptions& options) {
  return Try(options, [&](Search& search, const ProofOptions& limits) {
    return search.WhyContradiction(limits);
  });
}

}  // namespace lares::owl
