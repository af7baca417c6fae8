// What the literals of the tests mean, by table 8 of W3C OWL 2 Profiles and XML Schema.
#pragma once

#include <optional>
#include <string>

#include "ontology/rdf/term.h"

namespace lares::testing {

// Strings (without a language), integers and decimals; nothing for a literal of another datatype
// and for one whose text its datatype does not allow. Written out here by hand: shares nothing with
// the engine's reading of literals.
struct LiteralValue {
  bool is_number = false;
  std::string canonical;  // a string's text; a number as [-]digits[.digits] with no needless zero

  friend bool operator==(const LiteralValue&, const LiteralValue&) = default;
};
std::optional<LiteralValue> MeaningOf(const rdf::TermView& literal);

// Whether the value is one of the datatype's.
bool IsOneOf(const LiteralValue& value, std::string_view datatype);
// Whether the datatype is among those that MeaningOf knows.
bool IsKnownDatatype(std::string_view datatype);

}  // namespace lares::testing
