// How JSON's numbers and JSON itself become lexical forms.
#pragma once

#include <string>
#include <string_view>

#include "ontology/rdf/jsonld_value.h"

namespace lares::rdf::jsonld {

struct Numeral {
  std::string lexical;
  bool is_double = false;
};

// JSON-LD 1.1 API, 8.6 (data round tripping): whole numbers below 10^21 as xsd:integer, all others,
// and any when `as_double`, as canonical xsd:double.
Numeral ToNumeral(const std::string& json_number, bool as_double);

// The canonical form of RFC 8785: members sorted by UTF-16, numbers as ECMAScript prints them.
std::string Canonical(const Value& value);

}  // namespace lares::rdf::jsonld
