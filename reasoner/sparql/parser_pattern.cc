#include <utility>

#include "reasoner/sparql/parser.h"
#include "reasoner/sparql/variables.h"

namespace lares::sparql {

using syntax::Path;
using syntax::Pattern;
using Kind = syntax::Pattern::Kind;

Pattern Parser::ParseGroup() {
  const Depth depth(*this);
  Expect("{");
  EndBasicPattern();
  Pattern group;
  if (tokens_.Peek().IsWord("SELECT")) {
    CountStep();
    Pattern child;
    child.kind = Kind::kSelect;
    child.select = std::make_shared<const syntax::Selection>(ParseSubSelect());
    group.children.push_back(std::move(child));
  } else {
    group = ParseGroupBody();
  }
  Expect("}");
  EndBasicPattern();
  return group;
}

Pattern Parser::ParseGroupBody() {
  Pattern group;
  for (;;) {
    const Token& token = tokens_.Peek();
    if (token.Is("}") || token.kind == Token::Kind::kEnd) return group;
    if (AcceptWord("FILTER")) {
      CountStep();
      Pattern filter;
      filter.kind = Kind::kFilter;
      filter.expression = ParseConstraint();
      group.children.push_back(std::move(filter));
      Accept(".");
      continue;
    }
    if (StartsTerm() || token.Is("(") || token.Is("[")) {
      ParseTriplesInto(group);
      continue;
    }
    EndBasicPattern();
    CountStep();
    if (token.IsWord("OPTIONAL") || token.IsWord("MINUS")) {
      Pattern child;
      child.kind = tokens_.Take().IsWord("OPTIONAL") ? Kind::kOptional : Kind::kMinus;
      child.children.push_back(ParseGroup());
      group.children.push_back(std::move(child));
    } else if (token.IsWord("GRAPH")) {
      ParseGraph(group);
    } else if (token.IsWord("SERVICE")) {
      ParseService(group);
    } else if (token.IsWord("BIND")) {
      ParseBind(group);
    } else if (AcceptWord("VALUES")) {
      group.children.push_back(ParseValues());
    } else if (token.Is("{")) {
      ParseGroupOrUnion(group);
    } else {
      FailHere("a pattern or '}'");
    }
    EndBasicPattern();
    Accept(".");
  }
}

// Labels of blank nodes hold within one basic graph pattern.
void Parser::EndBasicPattern() {
  for (auto& [label, node] : labels_) closed_labels_.insert(label);
  labels_.clear();
}

// Triples with '.' between, as many as there are.
void Parser::ParseTriplesInto(Pattern& group) {
  do {
    if (!StartsTerm() && !tokens_.Peek().Is("(") && !tokens_.Peek().Is("[")) return;
    ParseTriplesSameSubject(group);
  } while (Accept("."));
  if (StartsTerm() || tokens_.Peek().Is("(") || tokens_.Peek().Is("[")) FailHere("'.'");
}

void Parser::ParseTriplesSameSubject(Pattern& group) {
  const Token& token = tokens_.Peek();
  if (token.Is("(") || token.Is("[")) {
    const Node subject = ParseTriplesNode(group);
    if (!StartsVerb()) return;
    ParsePropertyList(group, subject);
    return;
  }
  const Node subject = ParseTermOrVariable(true);
  ParsePropertyList(group, subject);
}

bool Parser::StartsVerb() const {
  const Token& next = tokens_.Peek();
  return next.kind == Token::Kind::kVariable || next.kind == Token::Kind::kIri ||
         next.kind == Token::Kind::kName || next.Is("^") || next.Is("!") || next.Is("(") ||
         (next.kind == Token::Kind::kWord && next.text == "a");
}

void Parser::ParsePropertyList(Pattern& group, Node subject) {
  for (;;) {
    const Path verb = ParseVerb();
    ParseObjectList(group, subject, verb);
    bool has_semicolon = false;
    while (Accept(";")) has_semicolon = true;
    if (!has_semicolon || !StartsVerb()) return;
  }
}

void Parser::ParseObjectList(Pattern& group, Node subject, const Path& path) {
  do {
    AddTriple(group, subject, path, ParseGraphNode(group));
  } while (Accept(","));
}

Parser::Node Parser::ParseGraphNode(Pattern& group) {
  if (tokens_.Peek().Is("(") || tokens_.Peek().Is("[")) return ParseTriplesNode(group);
  return ParseTermOrVariable(true);
}

Parser::Node Parser::ParseTriplesNode(Pattern& group) {
  const Depth depth(*this);
  if (Accept("(")) return ParseCollection(group);
  Expect("[");
  const Node node = FreshBlank();
  ParsePropertyList(group, node);
  Expect("]");
  return node;
}

// After '('.
Parser::Node Parser::ParseCollection(Pattern& group) {
  Path first, rest;
  first.iri = Rdf("first");
  rest.iri = Rdf("rest");
  const Node head = FreshBlank();
  for (Node cell = head;;) {
    AddTriple(group, cell, first, ParseGraphNode(group));
    if (Accept(")")) {
      AddTriple(group, cell, rest, Rdf("nil"));
      return head;
    }
    const Node next = FreshBlank();
    AddTriple(group, cell, rest, next);
    cell = next;
  }
}

Parser::Node Parser::FreshBlank() {
  if (in_template_) return {Node::Kind::kBlank, query_.blanks++};
  return Variable(HiddenSlot("_"));
}

Parser::Node Parser::ParseBlank() {
  const Token token = tokens_.Take();
  if (token.kind != Token::Kind::kBlank) return FreshBlank();
  if (!in_template_ && closed_labels_.count(token.text) != 0) {
    tokens_.Fail("the blank node _:" + std::string(token.text) +
                     " is used in another basic graph pattern already",
                 token.begin);
  }
  const auto known = labels_.find(token.text);
  if (known != labels_.end()) return known->second;
  const Node node = FreshBlank();
  labels_.emplace(std::string(token.text), node);
  return node;
}

// 18.2.2.3 and 18.2.2.4: what a path can say by triples, it says by triples.
void Parser::AddTriple(Pattern& group, Node subject, const Path& path, Node object) {
  CountStep();
  Pattern child;
  switch (path.kind) {
    case Path::Kind::kIri:
      if (group.children.empty() || group.children.back().kind != Kind::kTriples) {
        child.kind = Kind::kTriples;
        group.children.push_back(std::move(child));
      }
      group.children.back().triples.push_back({subject, path.iri, object});
      return;
    case Path::Kind::kInverse:
      AddTriple(group, object, path.parts[0], subject);
      return;
    case Path::Kind::kSequence:
      for (std::size_t i = 0; i < path.parts.size(); ++i) {
        const bool is_last = i + 1 == path.parts.size();
        const Node next = is_last ? object : FreshBlank();
        AddTriple(group, subject, path.parts[i], next);
        subject = next;
      }
      return;
    case Path::Kind::kAlternative:
      child.kind = Kind::kUnion;
      for (const Path& part : path.parts) {
        child.children.emplace_back();
        AddTriple(child.children.back(), subject, part, object);
      }
      break;
    default:
      child.kind = Kind::kPath;
      child.ends = {subject, {}, object};
      child.path = path;
  }
  group.children.push_back(std::move(child));
}

void Parser::ParseGroupOrUnion(Pattern& group) {
  Pattern first = ParseGroup();
  if (!tokens_.Peek().IsWord("UNION")) {
    group.children.push_back(std::move(first));
    return;
  }
  Pattern both;
  both.kind = Kind::kUnion;
  both.children.push_back(std::move(first));
  while (AcceptWord("UNION")) {
    CountStep();
    both.children.push_back(ParseGroup());
  }
  group.children.push_back(std::move(both));
}

void Parser::ParseGraph(Pattern& group) {
  ExpectWord("GRAPH");
  query_.uses_graphs = true;
  Pattern graph;
  graph.kind = Kind::kGraph;
  graph.node = tokens_.Peek().kind == Token::Kind::kVariable ? Variable(ParseVariable())
                                                             : AddIri(ParseIri());
  graph.children.push_back(ParseGroup());
  group.children.push_back(std::move(graph));
}

void Parser::ParseService(Pattern& group) {
  ExpectWord("SERVICE");
  Pattern service;
  service.kind = Kind::kService;
  service.is_silent = AcceptWord("SILENT");
  service.node = tokens_.Peek().kind == Token::Kind::kVariable ? Variable(ParseVariable())
                                                               : AddIri(ParseIri());
  service.children.push_back(ParseGroup());
  group.children.push_back(std::move(service));
}

void Parser::ParseBind(Pattern& group) {
  ExpectWord("BIND");
  Expect("(");
  Pattern bind;
  bind.kind = Kind::kBind;
  bind.expression = ParseExpression();
  ExpectWord("AS");
  const std::size_t at = tokens_.Peek().begin;
  bind.slot = ParseVariable();
  Expect(")");
  std::set<Slot> visible;
  CollectVisible(group, visible);
  if (visible.count(bind.slot) != 0) {
    tokens_.Fail("?" + query_.columns[bind.slot].name + " is bound before this BIND already", at);
  }
  group.children.push_back(std::move(bind));
}

// After VALUES.
Pattern Parser::ParseValues() {
  Pattern values;
  values.kind = Kind::kValues;
  const bool is_single = tokens_.Peek().kind == Token::Kind::kVariable;
  if (is_single) {
    values.slots.push_back(ParseVariable());
  } else if (!Accept("()")) {
    Expect("(");
    while (!Accept(")")) values.slots.push_back(ParseVariable());
  }
  Expect("{");
  const auto cell = [&]() -> Node {
    if (AcceptWord("UNDEF")) return {};
    if (tokens_.Peek().Is("()")) FailHere("a term");
    return ParseTermOrVariable(false);
  };
  while (!Accept("}")) {
    const std::size_t at = tokens_.Peek().begin;
    std::vector<Node> row;
    if (is_single) {
      row.push_back(cell());
    } else if (!Accept("()")) {
      Expect("(");
      while (!Accept(")")) row.push_back(cell());
    }
    if (row.size() != values.slots.size()) {
      tokens_.Fail("a row of VALUES has " + std::to_string(row.size()) + " terms for " +
                       std::to_string(values.slots.size()) + " variables",
                   at);
    }
    values.rows.push_back(std::move(row));
  }
  return values;
}

void Parser::ParseTemplate() {
  Expect("{");
  in_template_ = true;
  Pattern group;
  ParseTriplesInto(group);
  Expect("}");
  in_template_ = false;
  labels_.clear();
  for (const Pattern& child : group.children) {
    query_.construct.insert(query_.construct.end(), child.triples.begin(), child.triples.end());
  }
}

}  // namespace lares::sparql
