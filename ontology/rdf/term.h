// RDF terms as values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lares::rdf {

enum class TermKind : std::uint8_t { kIri, kBlank, kLiteral };

// A term that points into storage owned by somebody else (a dictionary, a document).
struct TermView {
  TermKind kind = TermKind::kIri;
  std::string_view value;     // the IRI; the blank node's label without "_:"; the lexical form
  std::string_view datatype;  // IRI; for literals only; empty means xsd:string (or rdf:langString)
  std::string_view language;  // lower-case tag; for literals only

  friend bool operator==(const TermView&, const TermView&) = default;
};

struct Term {
  TermKind kind = TermKind::kIri;
  std::string value;
  std::string datatype;
  std::string language;

  static Term Iri(std::string_view iri) { return {TermKind::kIri, std::string(iri), {}, {}}; }
  static Term Blank(std::string_view label) {
    return {TermKind::kBlank, std::string(label), {}, {}};
  }
  static Term Literal(std::string_view lexical, std::string_view datatype = {},
                      std::string_view language = {}) {
    return {TermKind::kLiteral, std::string(lexical), std::string(datatype), std::string(language)};
  }

  TermView view() const { return {kind, value, datatype, language}; }
  friend bool operator==(const Term&, const Term&) = default;
};

// As N-Triples writes it: <iri>, _:label, "lexical"@en, "lexical"^^<datatype>.
std::string ToNTriples(const TermView& term);

}  // namespace lares::rdf
