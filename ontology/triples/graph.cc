#include "ontology/triples/graph.h"

#include "ontology/triples/sorting.h"

namespace lares::rdf {
namespace {

// The document's name as the first part of a blank node label: letters and digits stay, anything
// else becomes _ and two hexadecimal digits. It has no '.', so "name.label" is read back one way.
std::string BlankPrefix(std::string_view name) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string prefix;
  for (const char c : name) {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) {
      prefix += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      prefix += '_';
      prefix += kHex[byte >> 4];
      prefix += kHex[byte & 15];
    }
  }
  return prefix + ".";
}

// Interns each term of a document when it is first used.
class TermMap {
 public:
  TermMap(const Document& document, std::string_view name, const AliasTable& aliases,
          Dictionary& dictionary, std::map<TermId, TermId>& as_written)
      : document_(document),
        blank_prefix_(BlankPrefix(name)),
        aliases_(aliases),
        dictionary_(dictionary),
        as_written_(as_written),
        ids_(document.terms.size()) {}

  TermId At(std::uint32_t index) {
    TermId& id = ids_.at(index);
    if (id == kAnyTerm) id = Intern(document_.terms[index]);
    return id;
  }

 private:
  TermId Intern(const Term& term) {
    switch (term.kind) {
      case TermKind::kBlank:
        return dictionary_.Intern({TermKind::kBlank, blank_prefix_ + term.value, {}, {}});
      case TermKind::kIri:
        return InternIri(term);
      case TermKind::kLiteral:
        break;
    }
    return dictionary_.Intern(term.view());
  }

  TermId InternIri(const Term& term) {
    if (aliases_.aliases().empty()) return dictionary_.Intern(term.view());
    const std::string canonical = aliases_.Canonical(term.value);
    const TermId id = dictionary_.InternIri(canonical);
    if (canonical != term.value) as_written_.emplace(id, dictionary_.Intern(term.view()));
    return id;
  }

  const Document& document_;
  std::string blank_prefix_;
  const AliasTable& aliases_;
  Dictionary& dictionary_;
  std::map<TermId, TermId>& as_written_;
  std::vector<TermId> ids_;
};

}  // namespace

Graph MakeGraph(const Document& document, std::string_view name, const AliasTable& aliases,
                Dictionary& dictionary) {
  Graph graph;
  graph.name = name;
  graph.triples.reserve(document.statements.size());
  TermMap terms(document, name, aliases, dictionary, graph.as_written);
  for (const Statement& statement : document.statements) {
    graph.triples.push_back(
        {terms.At(statement.subject), terms.At(statement.predicate), terms.At(statement.object)});
  }
  SortAndDeduplicate(graph.triples);
  return graph;
}

}  // namespace lares::rdf
