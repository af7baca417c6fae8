#include "ontology/rdf/merge.h"

#include <optional>
#include <set>
#include <string>

#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/owl_syntax/words.h"

namespace lares::rdf {
namespace {

class Merger {
 public:
  explicit Merger(const std::vector<Document>& documents)
      : documents_(documents), builder_(documents[0].format, kNoLimits) {}

  Document Merge();

 private:
  void FindHeaders();
  void Add(const Document& document, std::size_t number);
  // True for a statement that goes, or is said of the merged ontology instead.
  bool IsHeader(const Document& document, const Statement& s, const std::vector<std::uint32_t>& map,
                std::uint32_t graph);

  inline static const ReadOptions kNoLimits{.max_bytes = SIZE_MAX,
                                            .max_statements = SIZE_MAX,
                                            .max_term_bytes = SIZE_MAX,
                                            .max_depth = INT32_MAX,
                                            .max_entity_bytes = SIZE_MAX};

  const std::vector<Document>& documents_;
  DocumentBuilder builder_;
  std::set<std::string> merged_;                  // IRIs of all ontologies and of their versions
  std::vector<std::set<std::uint32_t>> headers_;  // by document: its terms that are ontologies
  std::size_t current_ = 0;
  std::optional<std::uint32_t> ontology_;  // the first one, as a merged term
};

void Merger::FindHeaders() {
  for (const Document& document : documents_) {
    std::set<std::uint32_t> headers;
    for (const Statement& s : document.statements) {
      const Word predicate = WordOf(document.terms[s.predicate].value);
      const Term& object = document.terms[s.object];
      if (predicate == Word::kRdfType && WordOf(object.value) == Word::kOwlOntology) {
        headers.insert(s.subject);
        if (document.terms[s.subject].kind == TermKind::kIri) {
          merged_.insert(document.terms[s.subject].value);
        }
      } else if (predicate == Word::kOwlVersionIRI) {
        merged_.insert(object.value);
      }
    }
    headers_.push_back(std::move(headers));
  }
}

bool Merger::IsHeader(const Document& document, const Statement& s,
                      const std::vector<std::uint32_t>& map, std::uint32_t graph) {
  if (headers_[current_].count(s.subject) == 0) return false;
  const bool is_first = map[s.subject] == *ontology_;
  const Term& object = document.terms[s.object];
  switch (WordOf(document.terms[s.predicate].value)) {
    case Word::kRdfType:
      return WordOf(object.value) == Word::kOwlOntology && !is_first;
    case Word::kOwlVersionIRI:
      return !is_first;
    case Word::kOwlImports:
      if (merged_.count(object.value) == 0) {
        builder_.Add({*ontology_, map[s.predicate], map[s.object], graph});
      }
      return true;
    default:
      if (is_first || document.terms[s.subject].kind == TermKind::kIri) return false;
      builder_.Add({*ontology_, map[s.predicate], map[s.object], graph});
      return true;
  }
}

void Merger::Add(const Document& document, std::size_t number) {
  current_ = number;
  std::vector<std::uint32_t> map;
  map.reserve(document.terms.size());
  for (const Term& term : document.terms) {
    if (term.kind == TermKind::kBlank) {
      const std::string label = "d" + std::to_string(number) + "-" + term.value;
      map.push_back(builder_.Intern({TermKind::kBlank, label, {}, {}}));
    } else {
      map.push_back(builder_.Intern(term.view()));
    }
  }
  // The header first: what follows depends on it.
  if (!ontology_ && !headers_[number].empty()) ontology_ = map[*headers_[number].begin()];
  for (const Statement& s : document.statements) {
    const std::uint32_t graph = s.graph == Statement::kDefaultGraph ? s.graph : map[s.graph];
    if (IsHeader(document, s, map, graph)) continue;
    builder_.Add({map[s.subject], map[s.predicate], map[s.object], graph});
  }
  Document& merged = builder_.document();
  merged.prefixes.insert(document.prefixes.begin(), document.prefixes.end());
  merged.remarks.insert(merged.remarks.end(), document.remarks.begin(), document.remarks.end());
}

Document Merger::Merge() {
  FindHeaders();
  for (std::size_t i = 0; i < documents_.size(); ++i) Add(documents_[i], i);
  return builder_.Finish();
}

}  // namespace

Document MergeOntologies(const std::vector<Document>& documents) {
  if (documents.empty()) return {};
  if (documents.size() == 1) return documents[0];
  return Merger(documents).Merge();
}

}  // namespace lares::rdf
