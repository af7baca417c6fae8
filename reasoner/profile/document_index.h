// A document by subject and by OWL's own words.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/document.h"

namespace lares::profile {

// Terms and statements are named by their index in the document, which outlives the index.
class DocumentIndex {
 public:
  explicit DocumentIndex(const rdf::Document& document);

  const rdf::Document& document() const { return document_; }
  const rdf::Term& Term(std::uint32_t term) const { return document_.terms[term]; }
  const rdf::Statement& Statement(std::uint32_t index) const { return document_.statements[index]; }
  bool IsIri(std::uint32_t term) const { return Term(term).kind == rdf::TermKind::kIri; }
  bool IsBlank(std::uint32_t term) const { return Term(term).kind == rdf::TermKind::kBlank; }
  bool IsLiteral(std::uint32_t term) const { return Term(term).kind == rdf::TermKind::kLiteral; }

  // "owl:Class" for a term of the namespaces of RDF, RDFS, OWL and XSD; "" for others.
  std::string_view Word(std::uint32_t term) const { return words_[term]; }
  // The statements about `subject`, in the document's order.
  std::span<const std::uint32_t> About(std::uint32_t subject) const;
  // Those with the predicate `word`.
  std::vector<std::uint32_t> About(std::uint32_t subject, std::string_view word) const;
  // The object of the first of them.
  std::optional<std::uint32_t> Object(std::uint32_t subject, std::string_view word) const;
  bool HasType(std::uint32_t subject, std::string_view word) const;

  // The members of the list `head`; none when it is no well-formed list.
  std::optional<std::vector<std::uint32_t>> List(std::uint32_t head) const;

 private:
  const rdf::Document& document_;
  std::vector<std::string> words_;
  std::vector<std::uint32_t> by_subject_;  // statements
  std::vector<std::uint32_t> begins_;      // into by_subject_, for each term
};

// Whether the word is one of the vocabularies' own: "owl:subClassOf" is not.
bool IsKnownWord(std::string_view word);
const std::vector<std::string>& KnownWords();
// Datatypes of OWL 2 RL (OWL 2 Profiles, 4.2.1), rdf:langString for rdf:PlainLiteral.
bool IsRlDatatype(std::string_view word);
// The datatypes of OWL 2.
bool IsDatatypeWord(std::string_view word);

}  // namespace lares::profile
