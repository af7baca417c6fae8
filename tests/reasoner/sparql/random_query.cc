#include "tests/reasoner/sparql/random_query.h"

#include <set>

namespace lares::sparql::testing {
namespace {

constexpr char kPrologue[] =
    "PREFIX : <http://example.org/>\n"
    "PREFIX xsd: <http://www.w3.org/2001/XMLSchema#>\n";

}  // namespace

std::string QueryAuthor::Variable() { return OneOf({"?a", "?b", "?c", "?d"}); }

std::string QueryAuthor::Resource() { return OneOf({":r0", ":r1", ":r2", ":r3", ":r4"}); }

std::string QueryAuthor::Literal() {
  return OneOf({"1", "2", "-3", "2.5", "0.5", "1e1", "true", "false", "\"cup\"", "\"Cup\"",
                "\"cupboard\"", "\"cup\"@en", "\"tasse\"@fr", "\"\"", "\"01\"^^xsd:integer",
                "\"7\"^^xsd:int"});
}

std::string QueryAuthor::Data() {
  const auto node = [&] { return Below(5) == 0 ? OneOf({"_:x", "_:y"}) : Resource(); };
  std::set<std::string> statements;
  for (unsigned i = 0, count = 16 + Below(20); i < count; ++i) {
    const std::string subject = node();
    switch (Below(4)) {
      case 0:
        statements.insert(subject + " :n " + std::to_string(static_cast<int>(Below(7)) - 2));
        break;
      case 1:
        statements.insert(subject + " :v " + Literal());
        break;
      case 2:
        statements.insert(subject + " :p " + node());
        break;
      default:
        statements.insert(subject + " :q " + node());
    }
  }
  std::string text = kPrologue;
  for (const std::string& statement : statements) text += statement + " .\n";
  return text;
}

std::string QueryAuthor::TriplePattern() {
  const std::string subject = Below(8) == 0 ? Resource() : Variable();
  const std::string predicate = Below(12) == 0 ? Variable() : OneOf({":p", ":q", ":n", ":v"});
  const bool is_literal = predicate == ":n" || predicate == ":v";
  std::string object = Variable();
  if (Below(is_literal ? 12 : 6) == 0) object = is_literal ? Literal() : Resource();
  return subject + " " + predicate + " " + object + " . ";
}

std::string QueryAuthor::Number(int depth) {
  if (depth > 1 || Below(2) == 0)
    return Below(2) == 0 ? Variable() : OneOf({"1", "2", "0.5", "-1"});
  const std::string left = Number(depth + 1);
  return "(" + left + OneOf({" + ", " - ", " * "}) + Number(depth + 1) + ")";
}

std::string QueryAuthor::Condition(int depth) {
  switch (Below(depth > 1 ? 6 : 9)) {
    case 0:
      return Number(0) + OneOf({" < ", " > ", " <= ", " >= ", " = ", " != "}) + Number(0);
    case 1:
      return "bound(" + Variable() + ")";
    case 2:
      return "regex(str(" + Variable() + "), " + OneOf({"\"^c\"", "\"UP\", \"i\"", "\"[0-9]$\""}) +
             ")";
    case 3:
      return OneOf({"isIRI(", "isBlank(", "isLiteral("}) + Variable() + ")";
    case 4:
      return Variable() + OneOf({" = ", " != "}) + (Below(2) == 0 ? Resource() : Variable());
    case 5:
      return "lang(" + Variable() + ") = \"en\"";
    case 6:
      return "!(" + Condition(depth + 1) + ")";
    case 7:
      return "(" + Condition(depth + 1) + " && " + Condition(depth + 1) + ")";
    default:
      return "(" + Condition(depth + 1) + " || " + Condition(depth + 1) + ")";
  }
}

std::string QueryAuthor::Group(int depth) {
  std::string text;
  for (unsigned i = 0, count = 1 + Below(2); i < count; ++i) text += TriplePattern();
  if (depth < 2 && Below(3) == 0) text += "OPTIONAL { " + Group(depth + 1) + "} ";
  if (depth < 2 && Below(4) == 0) {
    text += "{ " + Group(depth + 1) + "} UNION { " + Group(depth + 1) + "} ";
  }
  if (Below(3) == 0) text += "FILTER(" + Condition(0) + ") ";
  return text;
}

std::string QueryAuthor::OrderedQuery() {
  has_order_ = true;
  std::string text = kPrologue;
  text += Below(3) == 0 ? "SELECT DISTINCT ?n ?m" : "SELECT ?n ?m";
  text += " WHERE { ?a :n ?n . ?b :n ?m . " + Group(1) + "} ORDER BY ";
  text += OneOf({"?n ?m", "DESC(?n) ?m", "DESC(?m) DESC(?n)", "(?n + ?m) ?n", "?m DESC(?n)"});
  return text;
}

std::string QueryAuthor::Query() {
  has_order_ = has_limit_ = false;
  std::string text;
  if (Below(4) == 0) {
    text = OrderedQuery();
  } else {
    text = kPrologue + OneOf({"SELECT ", "SELECT ", "SELECT DISTINCT "});
    text += OneOf({"*", "?a ?b ?c ?d", "?a", "?b ?c"});
    text += " WHERE { " + Group(0) + "}";
  }
  has_limit_ = Below(4) == 0;
  if (has_limit_) {
    text += " LIMIT " + std::to_string(Below(6));
    if (Below(2) == 0) text += " OFFSET " + std::to_string(Below(4));
  }
  return text;
}

}  // namespace lares::sparql::testing
