#include "reasoner/authority/ownership.h"

#include <algorithm>
#include <map>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/authority/axioms.h"

namespace lares::authority {
namespace {

std::string WithoutEnd(std::string iri) {
  while (!iri.empty() && (iri.back() == '#' || iri.back() == '/')) iri.pop_back();
  return iri;
}

std::vector<std::string> NamespacesOf(const rdf::Document& document) {
  std::vector<std::string> spaces;
  const auto add = [&](const std::string& iri) {
    std::string space = WithoutEnd(iri);
    if (space.empty() || std::count(spaces.begin(), spaces.end(), space) != 0) return;
    spaces.push_back(std::move(space));
  };
  const std::string type = std::string(rdf::kRdf) + "type";
  const std::string ontology = std::string(rdf::kOwl) + "Ontology";
  for (const rdf::Statement& statement : document.statements) {
    const rdf::Term& subject = document.terms[statement.subject];
    if (subject.kind != rdf::TermKind::kIri) continue;
    if (document.terms[statement.predicate].value == type &&
        document.terms[statement.object].value == ontology) {
      add(subject.value);
    }
  }
  add(document.base_iri);
  return spaces;
}

// Which of `spaces` an IRI lies in: followed by '#' or '/' and a name without either.
std::string SpaceOf(const std::string& iri, const std::vector<std::string>& spaces) {
  const std::size_t end = iri.find_last_of("#/");
  if (end == std::string::npos) return "";
  const std::string space = WithoutEnd(iri.substr(0, end + 1));
  return std::count(spaces.begin(), spaces.end(), space) != 0 ? space : "";
}

std::unordered_set<rdf::TermId> DeclaredIn(const rdf::Graph& graph, rdf::Dictionary& dictionary) {
  const AxiomTable table(dictionary);
  std::unordered_set<rdf::TermId> declared;
  for (const rdf::Triple& triple : graph.triples) {
    if (table.WeightOf(triple) == Weight::kNone || table.IsBuiltIn(triple.subject)) continue;
    if (dictionary.Kind(triple.subject) == rdf::TermKind::kIri) declared.insert(triple.subject);
  }
  return declared;
}

}  // namespace

Claim MakeClaim(const rdf::Document& document, const rdf::Graph& graph,
                const rdf::AliasTable& aliases, rdf::Dictionary& dictionary) {
  Claim claim{graph.name, NamespacesOf(document), {}, false};
  const std::unordered_set<rdf::TermId> declared = DeclaredIn(graph, dictionary);
  // A term may have several names in one document: one in its own namespace counts.
  std::map<rdf::TermId, std::string> spaces;
  for (const rdf::Term& term : document.terms) {
    if (term.kind != rdf::TermKind::kIri) continue;
    std::string space = SpaceOf(term.value, claim.namespaces);
    if (space.empty()) continue;
    const auto id = dictionary.FindIri(aliases.Canonical(term.value));
    if (id && declared.count(*id) != 0) spaces.emplace(*id, std::move(space));
  }
  for (const rdf::TermId term : declared) {
    const auto found = spaces.find(term);
    claim.declared.push_back({term, found == spaces.end() ? "" : found->second});
  }
  return claim;
}

Claim MakeSharedClaim(const rdf::Graph& graph, const std::string& space,
                      rdf::Dictionary& dictionary) {
  Claim claim{graph.name, {space}, {}, true};
  for (const rdf::TermId term : DeclaredIn(graph, dictionary)) {
    const bool is_inside = SpaceOf(std::string(dictionary.Get(term).value), claim.namespaces) != "";
    claim.declared.push_back({term, is_inside ? space : ""});
  }
  return claim;
}

void Owners::Add(const Claim& claim) {
  for (const std::string& space : claim.namespaces) holders_.emplace(space, claim.graph);
  for (const Claim::Name& name : claim.declared) {
    first_.emplace(name.term, claim.graph);
    const bool holds =
        claim.shares || holders_.count(name.space) == 0 || holders_.at(name.space) == claim.graph;
    if (name.space.empty() || !holds) continue;
    std::vector<std::string>& owners = by_name_[name.term];
    if (std::count(owners.begin(), owners.end(), claim.graph) == 0) owners.push_back(claim.graph);
  }
}

std::vector<std::string> Owners::OwnersOf(rdf::TermId term) const {
  if (const auto named = by_name_.find(term); named != by_name_.end()) return named->second;
  if (const auto first = first_.find(term); first != first_.end()) return {first->second};
  return {};
}

bool Owners::Owns(const std::string& graph, rdf::TermId term) const {
  const std::vector<std::string> owners = OwnersOf(term);
  return std::count(owners.begin(), owners.end(), graph) != 0;
}

}  // namespace lares::authority
