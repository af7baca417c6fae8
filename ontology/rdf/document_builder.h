// Collects what a parser finds into a Document.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// Checks and normalises terms, keeps each distinct one once, and counts. Errors have no place: the
// parser that called knows it.
class DocumentBuilder {
 public:
  DocumentBuilder(Format format, const ReadOptions& options);

  // Index of `term` in the document; language lower-cased, xsd:string dropped. Throws kInvalid for
  // a malformed term, kTooLarge for one beyond max_term_bytes.
  std::uint32_t Intern(TermView term);
  // Throws kTooLarge beyond max_statements.
  void Add(const Statement& statement);

  Document& document() { return document_; }
  // Collects owl:imports. The builder is spent afterwards.
  Document Finish();

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t index_plus_one = 0;  // 0: free
  };

  std::uint32_t Append(const TermView& term, std::uint32_t hash);
  void Grow();

  const ReadOptions& options_;
  Document document_;
  std::vector<Slot> slots_;  // open addressing; the size is a power of two, at most half full
  std::string language_;     // scratch
};

}  // namespace lares::rdf
