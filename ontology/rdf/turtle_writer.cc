#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/rdf/inline_blanks.h"
#include "ontology/rdf/prefix_table.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"
#include "ontology/rdf/writers.h"

namespace lares::rdf {
namespace {

constexpr int kDeepestInline = 16;  // deeper blank nodes get labels and their own place
constexpr std::string_view kType = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
constexpr std::string_view kFirst = "http://www.w3.org/1999/02/22-rdf-syntax-ns#first";
constexpr std::string_view kNil = "http://www.w3.org/1999/02/22-rdf-syntax-ns#nil";

using Group = std::vector<const Statement*>;

// The statements of one graph by subject, subjects in the order of their first statement.
struct GraphStatements {
  std::uint32_t graph = Statement::kDefaultGraph;
  std::vector<std::uint32_t> subjects;
  std::unordered_map<std::uint32_t, Group> by_subject;
};

std::vector<GraphStatements> GroupByGraph(const Document& document) {
  std::vector<GraphStatements> graphs(1);  // the default graph comes first
  std::unordered_map<std::uint32_t, std::size_t> places = {{Statement::kDefaultGraph, 0}};
  for (const Statement& statement : document.statements) {
    const auto [place, is_new] = places.emplace(statement.graph, graphs.size());
    if (is_new) graphs.push_back({statement.graph, {}, {}});
    GraphStatements& graph = graphs[place->second];
    Group& group = graph.by_subject[statement.subject];
    if (group.empty()) graph.subjects.push_back(statement.subject);
    group.push_back(&statement);
  }
  return graphs;
}

std::size_t SkipDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return at;
}

// True when Turtle reads `text` without quotes as a literal of xsd:`type`.
bool IsBare(std::string_view text, std::string_view type) {
  if (type == "boolean") return text == "true" || text == "false";
  const std::size_t begin = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t whole = SkipDigits(text, begin);
  if (type == "integer") return whole == text.size() && whole > begin;
  std::size_t at = whole;
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    at = SkipDigits(text, at + 1);
    fraction = at - whole - 1;
    if (fraction == 0) return false;
  }
  if (type == "decimal") return at == text.size() && fraction > 0;
  if (type != "double" || (whole == begin && fraction == 0)) return false;
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return false;
  ++at;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  return at < text.size() && SkipDigits(text, at) == text.size();
}

// """…""", for text of several lines.
std::string LongQuoted(std::string_view text) {
  std::string quoted = "\"\"\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        quoted += "\\\"";
        break;
      case '\\':
        quoted += "\\\\";
        break;
      case '\r':
        quoted += "\\r";
        break;
      default:
        quoted += c;
    }
  }
  return quoted + "\"\"\"";
}

bool HasOnlyLineBreaks(std::string_view text) {
  return text.find('\n') != std::string_view::npos &&
         std::none_of(text.begin(), text.end(), [](char c) {
           return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') ||
                  c == 0x7F;
         });
}

class TurtleWriter {
 public:
  explicit TurtleWriter(const Document& document)
      : document_(document),
        prefixes_(document.prefixes),
        labels_(BlankLabels(document, &IsBlankLabel)),
        blanks_(FindInlineBlanks(document)) {}

  std::string Run();

 private:
  void WriteGraph(const GraphStatements& graph);
  void WriteSubject(std::uint32_t subject, bool is_named);
  // " predicate object , object ;…" without the end.
  void WriteProperties(const Group& group, int depth);
  void WriteObject(std::uint32_t object, int depth);
  void WriteInline(std::uint32_t node, int depth);
  void WriteList(std::uint32_t cell, int depth);
  std::string TextOf(std::uint32_t index);
  std::string IriText(std::string_view iri);
  std::string LiteralText(const Term& literal);
  const Group& About(std::uint32_t subject) const;
  void Indent(int depth) { out_.append(margin_ + 4 * static_cast<std::size_t>(depth), ' '); }

  const Document& document_;
  PrefixTable prefixes_;
  std::vector<std::string> labels_;
  InlineBlanks blanks_;
  const GraphStatements* graph_ = nullptr;
  std::deque<std::uint32_t> postponed_;  // too deep to be inline
  std::size_t margin_ = 0;
  std::string out_;
};

std::string TurtleWriter::Run() {
  for (const GraphStatements& graph : GroupByGraph(document_)) WriteGraph(graph);
  const std::string declarations = prefixes_.Declarations();
  return declarations.empty() || out_.empty() ? declarations + out_ : declarations + "\n" + out_;
}

void TurtleWriter::WriteGraph(const GraphStatements& graph) {
  graph_ = &graph;
  const bool is_named = graph.graph != Statement::kDefaultGraph;
  if (is_named) out_ += TextOf(graph.graph) + " {\n";
  margin_ = is_named ? 4 : 0;
  for (const std::uint32_t subject : graph.subjects) {
    if (blanks_.is_inline[subject]) continue;
    WriteSubject(subject, !blanks_.is_unnamed[subject]);
    while (!postponed_.empty()) {
      const std::uint32_t next = postponed_.front();
      postponed_.pop_front();
      if (!About(next).empty()) WriteSubject(next, true);
    }
  }
  if (is_named) out_ += "}\n\n";
}

void TurtleWriter::WriteSubject(std::uint32_t subject, bool is_named) {
  Indent(0);
  out_ += is_named ? TextOf(subject) : "[]";
  WriteProperties(About(subject), 1);
  out_ += " .\n\n";
}

void TurtleWriter::WriteProperties(const Group& group, int depth) {
  std::vector<std::uint32_t> predicates;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> objects;
  for (const Statement* statement : group) {
    auto& list = objects[statement->predicate];
    if (list.empty()) predicates.push_back(statement->predicate);
    list.push_back(statement->object);
  }
  std::stable_partition(predicates.begin(), predicates.end(), [&](std::uint32_t predicate) {
    return document_.terms[predicate].value == kType;
  });
  for (std::size_t i = 0; i < predicates.size(); ++i) {
    if (i == 0) {
      out_ += ' ';
    } else {
      out_ += " ;\n";
      Indent(depth);
    }
    const std::string& iri = document_.terms[predicates[i]].value;
    out_ += iri == kType ? "a" : IriText(iri);
    const auto& list = objects[predicates[i]];
    for (std::size_t k = 0; k < list.size(); ++k) {
      out_ += k == 0 ? " " : " , ";
      WriteObject(list[k], depth);
    }
  }
}

void TurtleWriter::WriteObject(std::uint32_t object, int depth) {
  if (!blanks_.is_inline[object]) {
    out_ += document_.terms[object].kind == TermKind::kIri && document_.terms[object].value == kNil
                ? "()"
                : TextOf(object);
  } else if (depth > kDeepestInline) {
    out_ += TextOf(object);
    postponed_.push_back(object);
  } else if (blanks_.is_list[object]) {
    WriteList(object, depth);
  } else {
    WriteInline(object, depth);
  }
}

void TurtleWriter::WriteInline(std::uint32_t node, int depth) {
  const Group& group = About(node);
  if (group.empty()) {
    out_ += "[]";
    return;
  }
  out_ += '[';
  WriteProperties(group, depth + 1);
  out_ += " ]";
}

void TurtleWriter::WriteList(std::uint32_t cell, int depth) {
  out_ += '(';
  while (document_.terms[cell].kind == TermKind::kBlank) {
    const Group& group = About(cell);
    const bool first_comes_first = document_.terms[group[0]->predicate].value == kFirst;
    out_ += ' ';
    WriteObject(group[first_comes_first ? 0 : 1]->object, depth + 1);
    cell = group[first_comes_first ? 1 : 0]->object;
  }
  out_ += " )";
}

std::string TurtleWriter::TextOf(std::uint32_t index) {
  const Term& term = document_.terms[index];
  switch (term.kind) {
    case TermKind::kIri:
      return IriText(term.value);
    case TermKind::kBlank:
      return "_:" + labels_[index];
    case TermKind::kLiteral:
      return LiteralText(term);
  }
  return {};
}

std::string TurtleWriter::IriText(std::string_view iri) {
  std::string name = prefixes_.Shorten(iri);
  return name.empty() ? "<" + std::string(iri) + ">" : name;
}

std::string TurtleWriter::LiteralText(const Term& literal) {
  const std::string_view type = literal.datatype;
  if (type.starts_with(kXsd) && IsBare(literal.value, type.substr(kXsd.size()))) {
    return literal.value;
  }
  std::string text = HasOnlyLineBreaks(literal.value)
                         ? LongQuoted(literal.value)
                         : ToNTriples({TermKind::kLiteral, literal.value, {}, {}});
  if (!literal.language.empty()) return text + "@" + literal.language;
  return type.empty() ? text : text + "^^" + IriText(type);
}

const Group& TurtleWriter::About(std::uint32_t subject) const {
  static const Group kNothing;
  const auto group = graph_->by_subject.find(subject);
  return group == graph_->by_subject.end() ? kNothing : group->second;
}

}  // namespace

std::string WriteTurtle(const Document& document) { return TurtleWriter(document).Run(); }

}  // namespace lares::rdf
