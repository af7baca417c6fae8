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

// The same where no other triple has to hold for it, word by word: "1" a xsd:byte, but not what
// only is the same as 1. Whether `view` contains it is not asked.
std::optional<Reason> HoldsByItself(const rdf::View& view, const rdf::Triple& triple);

// dt-not-type: its value is another, or its text says none. Of literals whose datatype the rules do
// not know nothing is known.
bool IsOutsideDatatype(const rdf::TermView& literal, std::string_view datatype);

}  // namespace lares::owl
