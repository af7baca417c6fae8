#include "ontology/rdf/inline_blanks.h"

#include <string>

#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

constexpr std::string_view kFirst = "http://www.w3.org/1999/02/22-rdf-syntax-ns#first";
constexpr std::string_view kRest = "http://www.w3.org/1999/02/22-rdf-syntax-ns#rest";
constexpr std::string_view kNil = "http://www.w3.org/1999/02/22-rdf-syntax-ns#nil";

// What the statements say of one blank node.
struct Usage {
  int uses = 0;  // as object
  const Statement* use = nullptr;
  bool names_graph = false;
  bool has_one_graph = true;  // all statements about it are in the graph of the first
  const Statement* about = nullptr;
  int statements = 0;
  int firsts = 0;
  int rests = 0;
  std::uint32_t rest = 0;
};

std::vector<Usage> CountUsage(const Document& document) {
  std::vector<Usage> usage(document.terms.size());
  for (const Statement& s : document.statements) {
    Usage& object = usage[s.object];
    ++object.uses;
    object.use = &s;
    if (s.graph != Statement::kDefaultGraph) usage[s.graph].names_graph = true;
    Usage& subject = usage[s.subject];
    if (subject.about == nullptr) subject.about = &s;
    if (subject.about->graph != s.graph) subject.has_one_graph = false;
    ++subject.statements;
    const std::string& predicate = document.terms[s.predicate].value;
    if (predicate == kFirst) ++subject.firsts;
    if (predicate == kRest) {
      ++subject.rests;
      subject.rest = s.object;
    }
  }
  return usage;
}

// Of each circle of blank nodes that refer to each other, one keeps its label.
void BreakCircles(const std::vector<Usage>& usage, std::vector<bool>& is_inline) {
  enum class Mark : std::uint8_t { kNew, kOnPath, kDone };
  std::vector<Mark> marks(usage.size(), Mark::kNew);
  std::vector<std::uint32_t> path;
  for (std::uint32_t start = 0; start < usage.size(); ++start) {
    std::uint32_t node = start;
    while (is_inline[node] && marks[node] == Mark::kNew) {
      marks[node] = Mark::kOnPath;
      path.push_back(node);
      node = usage[node].use->subject;
    }
    if (is_inline[node] && marks[node] == Mark::kOnPath) is_inline[node] = false;
    for (const std::uint32_t passed : path) marks[passed] = Mark::kDone;
    path.clear();
  }
}

bool IsCell(const Usage& usage) {
  return usage.statements == 2 && usage.firsts == 1 && usage.rests == 1;
}

// From the last cell of each list to its head.
void MarkLists(const Document& document, const std::vector<Usage>& usage, InlineBlanks& found) {
  for (std::uint32_t tail = 0; tail < usage.size(); ++tail) {
    if (!found.is_inline[tail] || !IsCell(usage[tail])) continue;
    const Term& rest = document.terms[usage[tail].rest];
    if (rest.kind != TermKind::kIri || rest.value != kNil) continue;
    std::uint32_t cell = tail;
    while (found.is_inline[cell] && IsCell(usage[cell]) && !found.is_list[cell]) {
      found.is_list[cell] = true;
      const Statement& use = *usage[cell].use;
      if (document.terms[use.predicate].value != kRest) break;
      cell = use.subject;
    }
  }
}

}  // namespace

InlineBlanks FindInlineBlanks(const Document& document) {
  const std::vector<Usage> usage = CountUsage(document);
  InlineBlanks found;
  found.is_inline.resize(usage.size());
  found.is_unnamed.resize(usage.size());
  found.is_list.resize(usage.size());
  for (std::size_t i = 0; i < usage.size(); ++i) {
    const Usage& node = usage[i];
    if (document.terms[i].kind != TermKind::kBlank || node.names_graph || !node.has_one_graph) {
      continue;
    }
    found.is_unnamed[i] = node.uses == 0 && node.statements > 0;
    found.is_inline[i] =
        node.uses == 1 && (node.about == nullptr || node.about->graph == node.use->graph);
  }
  BreakCircles(usage, found.is_inline);
  MarkLists(document, usage, found);
  return found;
}

}  // namespace lares::rdf
