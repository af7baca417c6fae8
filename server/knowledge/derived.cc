#include "server/knowledge/derived.h"

#include <algorithm>

#include "base/aside.h"
#include "mapping/semantic/spatial_relations.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/triples/sorting.h"
#include "reasoner/owl/materialise.h"

namespace lares::server {
namespace {

constexpr std::string_view kPrefix = "derived:";
constexpr std::string_view kWasDerivedFrom = "http://www.w3.org/ns/prov#wasDerivedFrom";

// An IRI, or the "_:label" of a blank node.
rdf::TermId TermOf(const rdf::View& view, const std::string& name) {
  if (name.starts_with("_:")) {
    return view.dictionary().Intern({rdf::TermKind::kBlank, name.substr(2), {}, {}});
  }
  return view.dictionary().InternIri(name);
}

bool IsDerived(const rdf::Layer& layer) {
  return layer.graphs().size() == 1 && layer.graphs().front().name.starts_with(kPrefix);
}

}  // namespace

std::string DocumentIri(const std::string& graph_name) {
  std::string path = graph_name;
  std::replace(path.begin(), path.end(), ':', '/');
  return "https://w3id.org/lares/documents/" + path;
}

DerivedGraph SpatialRelationsOf(const rdf::View& view) {
  DerivedGraph derived;
  const std::string& source = view.layers().back()->graphs().front().name;
  derived.name = std::string(kPrefix) + source;
  derived.sources = {source};
  const rdf::TermId on = view.dictionary().InternIri(std::string(rdf::kLares) + "on");
  const rdf::TermId in = view.dictionary().InternIri(std::string(rdf::kLares) + "in");
  const semantic::RelationsFound found =
      semantic::FindSpatialRelations(semantic::ReadMapObjects(view));
  for (const semantic::SpatialRelation& relation : found.relations) {
    const bool is_on = relation.kind == semantic::SpatialRelation::Kind::kOn;
    derived.triples.push_back(
        {TermOf(view, relation.thing), is_on ? on : in, TermOf(view, relation.other)});
  }
  return derived;
}

rdf::View WithDerived(const rdf::View& view, const DerivedGraph& derived) {
  if (derived.triples.empty()) return view;
  rdf::Graph graph;
  graph.name = derived.name;
  graph.triples = derived.triples;
  rdf::Dictionary& terms = view.dictionary();
  const rdf::TermId self = terms.InternIri(DocumentIri(derived.name));
  for (const std::string& source : derived.sources) {
    graph.triples.push_back(
        {self, terms.InternIri(kWasDerivedFrom), terms.InternIri(DocumentIri(source))});
  }
  rdf::SortAndDeduplicate(graph.triples);
  return view.With(Aside([&] { return owl::Materialise(view, {std::move(graph)}); }));
}

rdf::View WithoutDerived(const rdf::View& view) {
  std::size_t count = view.layers().size();
  while (count > 0 && IsDerived(*view.layers()[count - 1])) --count;
  rdf::View documents(view.shared_dictionary());
  for (std::size_t i = 0; i < count; ++i) documents = documents.With(view.layers()[i]);
  return documents;
}

}  // namespace lares::server
