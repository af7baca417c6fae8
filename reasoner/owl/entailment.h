// Whether one graph follows from another.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "ontology/triples/view.h"

namespace lares::owl {

struct Entailment {
  bool follows = false;
  // The triple that no reading of the blank nodes could satisfy, where it does not follow.
  std::optional<rdf::Triple> missing;
  // What it took beyond triples that the view holds: rules answered on demand, "blank nodes"
  // (simple entailment, RDF 1.1 Semantics, section 5).
  std::set<std::string> used;
};

// Whether `conclusion` follows from `view`, which must be closed. Blank nodes of `conclusion` are
// read as "something". Throws kTooLarge after 1 000 000 attempts to read them.
Entailment Entails(const rdf::View& view, const rdf::Graph& conclusion);

}  // namespace lares::owl
