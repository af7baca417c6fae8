#include "reasoner/owl/proof_search.h"

namespace lares::owl {

Proof ProofSearch::OneStep(const rdf::Triple& triple, const Reason& reason) const {
  return {{{triple, std::string(reason.rule), TableOf(reason.rule), {}, {}}}, 1};
}

Proof ProofSearch::Write(const Goal& goal) {
  Proof proof;
  proof.cost = Lower(goal);
  Writer writer{&proof, {}};
  WriteGoal(goal, writer);
  return WithoutSpare(std::move(proof));
}

// A path may have been written in part before it turns out that the rest is there already.
Proof ProofSearch::WithoutSpare(Proof proof) {
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

std::size_t ProofSearch::Add(ProofNode node, Writer& writer) {
  const std::size_t index = writer.proof->nodes.size();
  writer.index.emplace(Goal{node.triple, 0}, index);
  writer.proof->nodes.push_back(std::move(node));
  return index;
}

std::size_t ProofSearch::WriteGoal(const Goal& goal, Writer& writer) {
  const auto found = writer.index.find({goal.triple, 0});
  if (found != writer.index.end()) return found->second;
  const Known& known = Recall(goal);
  if (known.cost.lower == 0) {
    return Add({goal.triple, "", 0, {}, view_.GraphsOf(goal.triple)}, writer);
  }
  if (!known.computed.empty()) {
    return Add({goal.triple, std::string(known.computed), TableOf(known.computed), {}, {}}, writer);
  }
  if (known.rule == nullptr) return WritePath(goal, writer);
  ProofNode node{goal.triple, known.rule->name, known.rule->table, {}, {}};
  for (const Goal& premise : known.premises) node.premises.push_back(WriteGoal(premise, writer));
  return Add(std::move(node), writer);
}

// From the end of the path to its beginning.
std::size_t ProofSearch::WritePath(const Goal& goal, Writer& writer) {
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

std::string ProofSearch::RuleOfStep(rdf::TermId p, bool is_backwards, bool is_final) const {
  const Vocabulary& words = derivations_.words();
  if (p == words.same_as) return is_final ? "eq-sym" : is_backwards ? "eq-rep-s" : "eq-trans";
  if (p == words.sub_class_of) return "scm-sco";
  return p == words.sub_property_of ? "scm-spo" : "prp-trp";
}

Proof ProofSearch::WriteClash(const rdf::Clash& clash, unsigned cost) {
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

int ProofSearch::TableOf(std::string_view rule) const {
  const auto row = table_of_.find(rule);
  if (row != table_of_.end()) return row->second;
  for (const AxiomRow& axiom : AxiomTable()) {
    if (rule == axiom.name) return axiom.table;
  }
  return rule == "eq-ref" ? 4 : rule.starts_with("dt-") ? 8 : 9;
}

}  // namespace lares::owl
