// A document's triples as ids: what a layer is made of.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/aliases.h"
#include "ontology/rdf/document.h"
#include "ontology/triples/dictionary.h"

namespace lares::rdf {

struct Triple {
  TermId subject{};
  TermId predicate{};
  TermId object{};

  friend auto operator<=>(const Triple&, const Triple&) = default;
};

// What one document asserts, under canonical names.
struct Graph {
  std::string name;             // id of the document; unique among the graphs of a view
  std::vector<Triple> triples;  // sorted, distinct
  // canonical IRI → the IRI as this document wrote it, for the terms that an alias changed; the
  // first spelling when it used several.
  std::map<TermId, TermId> as_written;
};

// Interns the terms that statements use: IRIs by their canonical name, blank nodes made unique by
// `name`, literals as they are (datatype IRIs have no aliases). Linear in the document. Named
// graphs inside the document (TriG, N-Quads) are merged into this one graph.
Graph MakeGraph(const Document& document, std::string_view name, const AliasTable& aliases,
                Dictionary& dictionary);

}  // namespace lares::rdf
