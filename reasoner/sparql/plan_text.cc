// Parts of a query as text, for people who look at plans.
#include "base/text.h"
#include "reasoner/sparql/plan.h"

namespace lares::sparql {

using syntax::Expression;
using syntax::Op;
using syntax::Path;

namespace {

std::string Shortened(const std::string& iri, const syntax::Query& query) {
  for (const auto& [prefix, base] : query.prefixes) {
    if (iri.size() > base.size() && iri.starts_with(base)) {
      return prefix + ":" + iri.substr(base.size());
    }
  }
  return "<" + iri + ">";
}

std::string List(const std::vector<syntax::Node>& nodes, std::string_view before,
                 const syntax::Query& query, std::string text) {
  for (const syntax::Node& node : nodes) {
    if (!text.empty()) text += "|";
    text += std::string(before) + TextOf(node, query);
  }
  return text;
}

std::string_view Name(Op op) {
  switch (op) {
    case Op::kOr:
      return "||";
    case Op::kAnd:
      return "&&";
    case Op::kNot:
      return "!";
    case Op::kEqual:
      return "=";
    case Op::kNotEqual:
      return "!=";
    case Op::kLess:
      return "<";
    case Op::kGreater:
      return ">";
    case Op::kLessEqual:
      return "<=";
    case Op::kGreaterEqual:
      return ">=";
    case Op::kIn:
      return "in";
    case Op::kNotIn:
      return "not in";
    case Op::kAdd:
      return "+";
    case Op::kSubtract:
    case Op::kNegate:
      return "-";
    case Op::kMultiply:
      return "*";
    case Op::kDivide:
      return "/";
    case Op::kExists:
      return "exists";
    case Op::kNotExists:
      return "not exists";
    case Op::kRegex:
      return "regex";
    case Op::kBound:
      return "bound";
    default:
      return "call";
  }
}

}  // namespace

std::string TextOf(const syntax::Node& node, const syntax::Query& query) {
  switch (node.kind) {
    case syntax::Node::Kind::kVariable: {
      const syntax::Column& column = query.columns[node.index];
      return column.is_hidden ? "_:" + std::to_string(node.index) : "?" + column.name;
    }
    case syntax::Node::Kind::kTerm: {
      const rdf::Term& term = query.terms[node.index];
      return term.kind == rdf::TermKind::kIri ? Shortened(term.value, query)
                                              : rdf::ToNTriples(term.view());
    }
    default:
      return "_";
  }
}

std::string TextOf(const syntax::TriplePattern& triple, const syntax::Query& query) {
  return TextOf(triple.subject, query) + " " + TextOf(triple.predicate, query) + " " +
         TextOf(triple.object, query);
}

std::string TextOf(const Path& path, const syntax::Query& query) {
  const auto joined = [&](std::string_view between) {
    std::vector<std::string> parts;
    for (const Path& part : path.parts) parts.push_back(TextOf(part, query));
    return "(" + Join(parts, between) + ")";
  };
  switch (path.kind) {
    case Path::Kind::kIri:
      return TextOf(path.iri, query);
    case Path::Kind::kInverse:
      return "^" + TextOf(path.parts[0], query);
    case Path::Kind::kSequence:
      return joined("/");
    case Path::Kind::kAlternative:
      return joined("|");
    case Path::Kind::kZeroOrMore:
      return TextOf(path.parts[0], query) + "*";
    case Path::Kind::kOneOrMore:
      return TextOf(path.parts[0], query) + "+";
    case Path::Kind::kZeroOrOne:
      return TextOf(path.parts[0], query) + "?";
    case Path::Kind::kNegated:
      return "!(" + List(path.not_backward, "^", query, List(path.not_forward, "", query, "")) +
             ")";
  }
  return "";
}

std::string TextOf(const Expression& expression, const syntax::Query& query) {
  if (expression.op == Op::kVariable || expression.op == Op::kTerm) {
    return TextOf(expression.node, query);
  }
  std::vector<std::string> parts;
  for (const Expression& argument : expression.arguments) parts.push_back(TextOf(argument, query));
  const std::string name(Name(expression.op));
  if (expression.op == Op::kCast)
    return TextOf(expression.node, query) + "(" + Join(parts, ", ") + ")";
  if (parts.size() == 2 && expression.op >= Op::kOr && expression.op <= Op::kDivide) {
    return "(" + parts[0] + " " + name + " " + parts[1] + ")";
  }
  return name + "(" + Join(parts, ", ") + ")";
}

}  // namespace lares::sparql
