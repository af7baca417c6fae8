// What C++ computes from documents enters the knowledge as graphs of its own.
#pragma once

#include <string>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::server {

// Triples that a computation found, and the graphs that it found them in. It is a layer over the
// layer of its sources, made with it and kept under its key: a source that changes or goes takes it
// along.
struct DerivedGraph {
  std::string name;                  // "derived:environment:flat"
  std::vector<std::string> sources;  // names of graphs
  std::vector<rdf::Triple> triples;
};

// Where the objects of the view's top layer, a semantic map, stand and lie: lares:on and lares:in,
// from their poses and extents (mapping/semantic/spatial_relations.h).
DerivedGraph SpatialRelationsOf(const rdf::View& view);

// The derived graph closed over `view`, with one prov:wasDerivedFrom (W3C PROV-O) for each source;
// `view` itself when it holds nothing.
rdf::View WithDerived(const rdf::View& view, const DerivedGraph& derived);

// Without the layers of derived graphs on top: what documents say.
rdf::View WithoutDerived(const rdf::View& view);

// The IRI of a graph for the outside: https://w3id.org/lares/documents/ and its name as a path.
std::string DocumentIri(const std::string& graph_name);

}  // namespace lares::server
