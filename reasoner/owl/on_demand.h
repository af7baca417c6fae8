// What is true without being stored.
#pragma once

#include <optional>
#include <string_view>

#include "ontology/triples/view.h"

namespace lares::owl {

// Why a triple holds: empty where the view contains it; otherwise the row of the tables whose
// conclusions are not stored ("eq-ref", "dt-type2", "scm-cls", …), or "dt-eq" where another literal
// of the same value is contained.
struct Reason {
  std::string_view rule;
};

// Whether `triple` follows under the OWL 2 RL/RDF rules from `view`, which must be closed:
// contained or trivial. A literal may be its subject. Its terms need not occur in the view.
std::optional<Reason> Holds(const rdf::View& view, const rdf::Triple& triple);

}  // namespace lares::owl
