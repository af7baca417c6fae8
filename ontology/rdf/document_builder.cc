#include "ontology/rdf/document_builder.h"

#include <algorithm>
#include <functional>

#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kFirstSlots = 1024;
constexpr std::string_view kXsdString = "http://www.w3.org/2001/XMLSchema#string";
constexpr std::string_view kOwlImports = "http://www.w3.org/2002/07/owl#imports";

std::uint32_t HashOf(const TermView& term) {
  const std::hash<std::string_view> hash;
  std::size_t sum = hash(term.value) + static_cast<std::size_t>(term.kind);
  if (!term.datatype.empty()) sum ^= hash(term.datatype) * 3;
  if (!term.language.empty()) sum ^= hash(term.language) * 5;
  return static_cast<std::uint32_t>(sum ^ (sum >> 32));
}

bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

DocumentBuilder::DocumentBuilder(Format format, const ReadOptions& options)
    : options_(options), slots_(kFirstSlots) {
  document_.format = format;
  document_.base_iri = options.base_iri;
}

std::uint32_t DocumentBuilder::Intern(TermView term) {
  if (term.datatype == kXsdString) term.datatype = {};
  if (!term.language.empty()) {
    term.datatype = {};
    if (std::any_of(term.language.begin(), term.language.end(), IsUpper)) {
      language_.assign(term.language);
      for (char& c : language_) c = IsUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
      term.language = language_;
    }
  }
  const std::uint32_t hash = HashOf(term);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
    const Slot& slot = slots_[at];
    if (slot.index_plus_one == 0) break;
    if (slot.hash == hash && document_.terms[slot.index_plus_one - 1].view() == term) {
      return slot.index_plus_one - 1;
    }
  }
  return Append(term, hash);
}

std::uint32_t DocumentBuilder::Append(const TermView& term, std::uint32_t hash) {
  if (std::max(term.value.size(), term.datatype.size()) > options_.max_term_bytes) {
    throw Error(Code::kTooLarge,
                "a term is longer than " + std::to_string(options_.max_term_bytes) + " bytes");
  }
  if (const auto fault = FaultOf(term)) throw Error(Code::kInvalid, *fault);
  document_.terms.push_back(
      {term.kind, std::string(term.value), std::string(term.datatype), std::string(term.language)});
  const auto index = static_cast<std::uint32_t>(document_.terms.size() - 1);
  if (document_.terms.size() * 2 > slots_.size()) Grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash & mask;
  while (slots_[at].index_plus_one != 0) at = (at + 1) & mask;
  slots_[at] = {hash, index + 1};
  return index;
}

void DocumentBuilder::Grow() {
  std::vector<Slot> larger(slots_.size() * 2);
  const std::size_t mask = larger.size() - 1;
  for (const Slot& slot : slots_) {
    if (slot.index_plus_one == 0) continue;
    std::size_t at = slot.hash & mask;
    while (larger[at].index_plus_one != 0) at = (at + 1) & mask;
    larger[at] = slot;
  }
  slots_ = std::move(larger);
}

void DocumentBuilder::Add(const Statement& statement) {
  if (document_.statements.size() >= options_.max_statements) {
    throw Error(Code::kTooLarge, "the document has more than " +
                                     std::to_string(options_.max_statements) + " statements");
  }
  document_.statements.push_back(statement);
}

Document DocumentBuilder::Finish() {
  for (const Statement& statement : document_.statements) {
    const Term& predicate = document_.terms[statement.predicate];
    const Term& object = document_.terms[statement.object];
    if (predicate.value != kOwlImports || object.kind != TermKind::kIri) continue;
    auto& imports = document_.imports;
    if (std::find(imports.begin(), imports.end(), object.value) == imports.end()) {
      imports.push_back(object.value);
    }
  }
  return std::move(document_);
}

}  // namespace lares::rdf
