#include "server/knowledge/consistency.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/aside.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/proof.h"
#include "reasoner/owl/prover.h"
#include "server/knowledge/catalogue.h"

namespace lares::server {
namespace {

constexpr std::size_t kShown = 5;  // contradictions told with their proofs

std::string PremiseText(const rdf::View& view, const rdf::Triple& premise) {
  const std::vector<std::string> graphs = view.GraphsOf(premise);
  return view.Label(premise.subject) + " " + view.Label(premise.predicate) + " " +
         view.Label(premise.object) +
         (graphs.empty() ? " (follows)" : " (" + Join(graphs, ", ") + ")");
}

// `graph` less the axioms that add to terms of our namespace: those that our modules declare, and
// those that only an alias brings there.
rdf::Graph FirmPart(const rdf::View& own, authority::Owners owners, const rdf::Graph& graph) {
  rdf::Graph aliased;
  aliased.name = "aliases";
  aliased.triples = graph.triples;
  std::string space(rdf::kLares);
  space.pop_back();
  authority::Claim claim = authority::MakeSharedClaim(aliased, space, own.dictionary());
  std::erase_if(claim.declared, [](const auto& name) { return name.space.empty(); });
  owners.Add(claim);
  rdf::Graph firm = graph;
  std::set<rdf::Triple> dropped;
  for (const authority::Trespass& trespass : authority::FindTrespasses(own, graph, owners)) {
    dropped.insert(trespass.axiom);
  }
  std::erase_if(firm.triples,
                [&](const rdf::Triple& triple) { return dropped.count(triple) != 0; });
  return firm;
}

// Of the contradiction that is proved in the fewest steps. None when that takes too long to find,
// or is beyond the prover: the document is refused all the same, and the premises must do.
std::optional<owl::Proof> ProofOf(const rdf::View& view) {
  try {
    return Aside([&] { return owl::Prover(view).WhyContradiction(); });
  } catch (const Error& error) {
    if (error.code() != Code::kTooLarge && error.code() != Code::kInternal) throw;
    return std::nullopt;
  }
}

}  // namespace

std::optional<Contradiction> FindContradiction(const rdf::View& view) {
  if (view.layers().empty() || view.layers().back()->clash_count() == 0) return std::nullopt;
  const rdf::Layer& layer = *view.layers().back();
  Contradiction contradiction;
  nlohmann::json clashes = nlohmann::json::array();
  contradiction.message = Join(DescribeClashes(view), "\n");
  for (const rdf::Clash& clash : layer.clashes()) {
    if (clashes.size() == kShown) break;
    nlohmann::json premises = nlohmann::json::array();
    contradiction.message += "\n" + clash.rule + " from:";
    for (const rdf::Triple& premise : clash.premises) {
      const std::string text = PremiseText(view, premise);
      contradiction.message += "\n  " + text;
      premises.push_back({{"text", text}, {"graphs", view.GraphsOf(premise)}});
    }
    clashes.push_back({{"rule", clash.rule}, {"premises", premises}});
  }
  nlohmann::json members{{"clashes", clashes}};
  if (const auto proof = ProofOf(view)) {
    contradiction.message += "\nproof:\n" + owl::ToText(*proof, view);
    members["proof"] = nlohmann::json::parse(owl::ToJson(*proof, view));
  }
  contradiction.json = members.dump();
  return contradiction;
}

Refusal ToRefusal(const Contradiction& contradiction, const std::string& source) {
  Refusal refusal(Refusal::Kind::kContradiction, contradiction.message, {source, 0, 0});
  refusal.WithMembers(contradiction.json);
  refusal.WithHint("mend it, or send it with --quarantine to keep it aside");
  return refusal;
}

rdf::View FirmCatalogue::For(std::uint64_t generation, const rdf::View& own,
                             const authority::Owners& own_owners,
                             const std::vector<Stored>& stored) {
  const std::lock_guard lock(mutex_);
  if (view_ && generation_ == generation) return *view_;
  std::vector<rdf::Graph> graphs;
  for (const Stored& document : stored) {
    graphs.push_back(document.by_editor ? *document.graph
                                        : FirmPart(own, own_owners, *document.graph));
  }
  view_ = graphs.empty() ? own : own.With(owl::Materialise(own, std::move(graphs)));
  generation_ = generation;
  return *view_;
}

}  // namespace lares::server
