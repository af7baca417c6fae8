// What literals mean: the values that OWL 2's datatypes give to their lexical forms.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ontology/rdf/term.h"

namespace lares::rdf {

// A data value (OWL 2 Structural Specification, section 4; XML Schema 1.1 Part 2). Two literals
// denote the same value exactly when their DataValues are equal: "1"^^xsd:int, "01"^^xsd:integer
// and "1.0"^^xsd:decimal do; "1"^^xsd:double is another value, for value spaces of decimal, float
// and double are disjoint. Values are compared by identity: times that are equal but were written
// with other time-zone offsets differ, and so do +0 and -0 as floats.
struct DataValue {
  enum class Space : unsigned char {
    kText,  // xsd:string and what is derived from it, with a language or without; rdf:PlainLiteral
    kDecimal,
    kFloat,
    kDouble,
    kBoolean,
    kTime,  // xsd:dateTime, xsd:dateTimeStamp
    kHex,
    kBase64,
    kUri,
    kXml
  };
  Space space = Space::kText;
  // Canonical; of text with a language: the language, lower-case, '\0', the text. Text without one
  // begins with '\0'.
  std::string canonical;

  friend bool operator==(const DataValue&, const DataValue&) = default;
};

// Nothing for a literal whose datatype is not one of SupportedDatatypes() and for one that is
// ill-typed: whose lexical form is not of the datatype. Lexical forms are taken as they stand,
// white space included; floats that are too large or too small are ill-typed.
std::optional<DataValue> ValueOf(const TermView& literal);

// The datatypes that the OWL 2 RL/RDF rules know, besides xsd:float and xsd:double, by IRI.
std::span<const std::string_view> SupportedDatatypes();
bool IsSupportedDatatype(std::string_view iri);

// Whether `value` is in the value space of a supported datatype.
bool IsInDatatype(const DataValue& value, std::string_view datatype);

}  // namespace lares::rdf
