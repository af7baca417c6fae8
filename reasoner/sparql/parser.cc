#include "reasoner/sparql/parser.h"

#include <charconv>
#include <utility>

#include "reasoner/sparql/query.h"
#include "reasoner/sparql/variables.h"

namespace lares::sparql {

using syntax::Assignment;
using syntax::Expression;
using syntax::Op;
using syntax::Selection;

namespace {

std::string Resolved(std::string_view text, const ParseOptions& options) {
  if (text.size() > options.max_bytes) {
    throw Error(Code::kTooLarge, "the query has " + std::to_string(text.size()) +
                                     " bytes; at most " + std::to_string(options.max_bytes) +
                                     " are read");
  }
  const bool has_escapes = text.find("\\u") != text.npos || text.find("\\U") != text.npos;
  return has_escapes ? ResolveCodepoints(text, options.source) : std::string(text);
}

}  // namespace

Parser::Depth::Depth(Parser& parser) : parser_(parser) {
  if (parser.depth_ >= parser.options_.max_depth) {
    throw Error(Code::kTooLarge,
                "the query nests deeper than " + std::to_string(parser.options_.max_depth),
                parser.tokens_.PlaceOf(parser.tokens_.Peek().begin));
  }
  ++parser.depth_;
}

Parser::Parser(std::string_view text, const ParseOptions& options)
    : options_(options), resolved_(Resolved(text, options)), tokens_(resolved_, options.source) {
  query_.base_iri = options.base_iri;
  scopes_.emplace_back();
}

bool Parser::Accept(std::string_view punctuation) {
  if (!tokens_.Peek().Is(punctuation)) return false;
  tokens_.Take();
  return true;
}

bool Parser::AcceptWord(std::string_view upper) {
  if (!tokens_.Peek().IsWord(upper)) return false;
  tokens_.Take();
  return true;
}

void Parser::Expect(std::string_view punctuation) {
  if (!Accept(punctuation)) FailHere("'" + std::string(punctuation) + "'");
}

void Parser::ExpectWord(std::string_view upper) {
  if (!AcceptWord(upper)) FailHere(std::string(upper));
}

void Parser::FailHere(const std::string& expected) {
  const Token& token = tokens_.Peek();
  const std::string found =
      token.kind == Token::Kind::kEnd
          ? "the end of the query"
          : "'" +
                resolved_.substr(token.begin, std::min<std::size_t>(token.end - token.begin, 40)) +
                "'";
  tokens_.Fail("expected " + expected + ", found " + found, token.begin);
}

void Parser::CountStep() {
  if (++steps_ > options_.max_steps) {
    throw Error(
        Code::kTooLarge,
        "the query has more than " + std::to_string(options_.max_steps) + " patterns and operators",
        tokens_.PlaceOf(tokens_.Peek().begin));
  }
}

syntax::Query Parser::Parse() {
  ParsePrologue();
  const Token& token = tokens_.Peek();
  if (token.IsWord("SELECT")) {
    ParseSelectQuery();
  } else if (token.IsWord("CONSTRUCT")) {
    ParseConstructQuery();
  } else if (token.IsWord("DESCRIBE")) {
    ParseDescribeQuery();
  } else if (token.IsWord("ASK")) {
    ParseAskQuery();
  } else {
    for (const std::string_view update :
         {"INSERT", "DELETE", "LOAD", "CLEAR", "DROP", "CREATE", "ADD", "MOVE", "COPY", "WITH"}) {
      if (!token.IsWord(update)) continue;
      throw Error(Code::kUnsupported, "this is a SPARQL update; only queries are answered",
                  tokens_.PlaceOf(token.begin))
          .WithHint("knowledge changes by documents: put or delete one");
    }
    FailHere("SELECT, ASK, CONSTRUCT or DESCRIBE");
  }
  if (tokens_.Peek().kind != Token::Kind::kEnd) FailHere("the end of the query");
  return std::move(query_);
}

void Parser::ParsePrologue() {
  for (;;) {
    if (AcceptWord("BASE")) {
      if (tokens_.Peek().kind != Token::Kind::kIri) FailHere("an IRI");
      query_.base_iri = ResolveReference(tokens_.Take());
    } else if (AcceptWord("PREFIX")) {
      const Token name = tokens_.Take();
      if (name.kind != Token::Kind::kName || name.text.find(':') + 1 != name.text.size()) {
        tokens_.Fail("expected a prefix with ':'", name.begin);
      }
      if (tokens_.Peek().kind != Token::Kind::kIri) FailHere("an IRI");
      const std::string prefix(name.text.substr(0, name.text.size() - 1));
      query_.prefixes[prefix] = ResolveReference(tokens_.Take());
    } else {
      return;
    }
  }
}

void Parser::ParseSelectQuery() {
  query_.form = Form::kSelect;
  const std::size_t at = tokens_.Peek().begin;
  bool is_star = false;
  Selection& select = query_.select;
  ParseSelectClause(select, is_star);
  ParseDatasetClauses();
  ParseWhere(select);
  ParseModifiers(select);
  if (AcceptWord("VALUES")) select.values = ParseValues();
  FinishSelect(select, is_star, at);
  for (const Assignment& column : select.projection) {
    query_.variables.push_back(query_.columns[column.slot].name);
  }
}

Selection Parser::ParseSubSelect() {
  const Depth depth(*this);
  scopes_.emplace_back();
  const std::size_t at = tokens_.Peek().begin;
  bool is_star = false;
  Selection select;
  ParseSelectClause(select, is_star);
  ParseWhere(select);
  ParseModifiers(select);
  if (AcceptWord("VALUES")) select.values = ParseValues();
  FinishSelect(select, is_star, at);
  scopes_.pop_back();
  for (const Assignment& column : select.projection) {
    select.outside.emplace_back(column.slot, SlotOf(query_.columns[column.slot].name));
  }
  return select;
}

void Parser::ParseSelectClause(Selection& select, bool& is_star) {
  ExpectWord("SELECT");
  select.is_distinct = AcceptWord("DISTINCT");
  select.is_reduced = !select.is_distinct && AcceptWord("REDUCED");
  if (Accept("*")) {
    is_star = true;
    return;
  }
  std::set<Slot> named;
  scopes_.back().may_aggregate = true;
  for (;;) {
    const std::size_t at = tokens_.Peek().begin;
    Assignment column;
    if (tokens_.Peek().kind == Token::Kind::kVariable) {
      column.slot = ParseVariable();
      if (!named.insert(column.slot).second) continue;
    } else if (Accept("(")) {
      column.expression = ParseExpression();
      ExpectWord("AS");
      column.slot = ParseVariable();
      Expect(")");
      if (!named.insert(column.slot).second) tokens_.Fail("a variable is selected twice", at);
    } else {
      break;
    }
    select.projection.push_back(std::move(column));
  }
  scopes_.back().may_aggregate = false;
  if (select.projection.empty()) FailHere("what to select: variables, (expression AS ?name) or *");
}

void Parser::ParseDatasetClauses() {
  while (AcceptWord("FROM")) {
    const bool is_named = AcceptWord("NAMED");
    (is_named ? query_.from_named : query_.from).push_back(ParseIri());
  }
}

void Parser::ParseWhere(Selection& select) {
  AcceptWord("WHERE");
  select.where = ParseGroup();
}

void Parser::ParseConstructQuery() {
  query_.form = Form::kConstruct;
  const std::size_t at = tokens_.Peek().begin;
  ExpectWord("CONSTRUCT");
  if (tokens_.Peek().Is("{")) {
    ParseTemplate();
    ParseDatasetClauses();
    ParseWhere(query_.select);
  } else {
    ParseDatasetClauses();
    ExpectWord("WHERE");
    Expect("{");
    syntax::Pattern& where = query_.select.where;
    if (!tokens_.Peek().Is("}")) ParseTriplesInto(where);
    Expect("}");
    for (const syntax::Pattern& child : where.children) {
      if (child.kind == syntax::Pattern::Kind::kPath) {
        tokens_.Fail("CONSTRUCT WHERE takes plain triples only", at);
      }
      query_.construct.insert(query_.construct.end(), child.triples.begin(), child.triples.end());
    }
    // A blank node of the pattern is matched, and a new one made for each solution.
    std::map<Slot, std::uint32_t> blanks;
    for (syntax::TriplePattern& triple : query_.construct) {
      for (Node* node : {&triple.subject, &triple.object}) {
        if (!node->is_variable() || !query_.columns[node->index].is_hidden) continue;
        const auto [entry, is_new] = blanks.emplace(node->index, query_.blanks);
        if (is_new) ++query_.blanks;
        *node = {Node::Kind::kBlank, entry->second};
      }
    }
  }
  ParseModifiers(query_.select);
  if (AcceptWord("VALUES")) query_.select.values = ParseValues();
  FinishSelect(query_.select, true, at);
}

void Parser::ParseDescribeQuery() {
  query_.form = Form::kDescribe;
  const std::size_t at = tokens_.Peek().begin;
  ExpectWord("DESCRIBE");
  const bool is_star = Accept("*");
  while (!is_star) {
    const Token::Kind kind = tokens_.Peek().kind;
    if (kind == Token::Kind::kVariable) {
      query_.describe.push_back(Variable(ParseVariable()));
    } else if (kind == Token::Kind::kIri || kind == Token::Kind::kName) {
      query_.describe.push_back(AddIri(ParseIri()));
    } else {
      break;
    }
  }
  if (!is_star && query_.describe.empty()) FailHere("an IRI, a variable or *");
  ParseDatasetClauses();
  if (tokens_.Peek().IsWord("WHERE") || tokens_.Peek().Is("{")) ParseWhere(query_.select);
  ParseModifiers(query_.select);
  if (AcceptWord("VALUES")) query_.select.values = ParseValues();
  FinishSelect(query_.select, true, at);
  if (!is_star) return;
  for (const Assignment& column : query_.select.projection) {
    query_.describe.push_back(Variable(column.slot));
  }
}

void Parser::ParseAskQuery() {
  query_.form = Form::kAsk;
  const std::size_t at = tokens_.Peek().begin;
  ExpectWord("ASK");
  ParseDatasetClauses();
  ParseWhere(query_.select);
  ParseModifiers(query_.select);
  if (AcceptWord("VALUES")) query_.select.values = ParseValues();
  FinishSelect(query_.select, true, at);
}

void Parser::ParseModifiers(Selection& select) {
  scopes_.back().may_aggregate = true;
  ParseGroupBy(select);
  ParseHaving(select);
  ParseOrderBy(select);
  scopes_.back().may_aggregate = false;
  ParseLimits(select);
}

void Parser::ParseGroupBy(Selection& select) {
  if (!AcceptWord("GROUP")) return;
  ExpectWord("BY");
  scopes_.back().may_aggregate = false;
  select.is_grouped = true;
  for (;;) {
    const Token& token = tokens_.Peek();
    Assignment key;
    if (token.kind == Token::Kind::kVariable) {
      key.slot = ParseVariable();
    } else if (Accept("(")) {
      key.expression = ParseExpression();
      key.slot = AcceptWord("AS") ? ParseVariable() : HiddenSlot("group");
      Expect(")");
    } else if (token.kind == Token::Kind::kIri || token.kind == Token::Kind::kName) {
      const std::size_t at = token.begin;
      key.expression = ParseFunctionCall(ParseIri(), at);
      key.slot = HiddenSlot("group");
    } else if (token.kind == Token::Kind::kWord && !token.IsWord("HAVING") &&
               !token.IsWord("ORDER") && !token.IsWord("LIMIT") && !token.IsWord("OFFSET") &&
               !token.IsWord("VALUES")) {
      key.expression = ParseBuiltIn();
      if (!key.expression) FailHere("what to group by");
      key.slot = HiddenSlot("group");
    } else {
      break;
    }
    select.group_by.push_back(std::move(key));
  }
  if (select.group_by.empty()) FailHere("what to group by");
  scopes_.back().may_aggregate = true;
}

void Parser::ParseHaving(Selection& select) {
  if (!AcceptWord("HAVING")) return;
  do {
    select.having.push_back(ParseConstraint());
  } while (tokens_.Peek().Is("(") || tokens_.Peek().kind == Token::Kind::kIri ||
           tokens_.Peek().kind == Token::Kind::kName ||
           (tokens_.Peek().kind == Token::Kind::kWord && !tokens_.Peek().IsWord("ORDER") &&
            !tokens_.Peek().IsWord("LIMIT") && !tokens_.Peek().IsWord("OFFSET") &&
            !tokens_.Peek().IsWord("VALUES")));
}

void Parser::ParseOrderBy(Selection& select) {
  if (!AcceptWord("ORDER")) return;
  ExpectWord("BY");
  for (;;) {
    const Token& token = tokens_.Peek();
    syntax::OrderKey key;
    if (token.IsWord("ASC") || token.IsWord("DESC")) {
      key.is_descending = tokens_.Take().IsWord("DESC");
      key.expression = ParseBracketed();
    } else if (token.kind == Token::Kind::kVariable) {
      key.expression.op = Op::kVariable;
      key.expression.node = Variable(ParseVariable());
    } else if (token.Is("(") || token.kind == Token::Kind::kIri ||
               token.kind == Token::Kind::kName ||
               (token.kind == Token::Kind::kWord && !token.IsWord("LIMIT") &&
                !token.IsWord("OFFSET") && !token.IsWord("VALUES"))) {
      key.expression = ParseConstraint();
    } else {
      break;
    }
    CountStep();
    select.order_by.push_back(std::move(key));
  }
  if (select.order_by.empty()) FailHere("what to order by");
}

std::uint64_t Parser::ParseCount() {
  const Token token = tokens_.Take();
  std::uint64_t count = 0;
  const char* end = token.text.data() + token.text.size();
  if (token.kind != Token::Kind::kInteger ||
      std::from_chars(token.text.data(), end, count).ec != std::errc()) {
    tokens_.Fail("expected a number of rows", token.begin);
  }
  return count;
}

void Parser::ParseLimits(Selection& select) {
  bool has_offset = false;
  for (;;) {
    if (!select.limit && AcceptWord("LIMIT")) {
      select.limit = ParseCount();
    } else if (!has_offset && AcceptWord("OFFSET")) {
      select.offset = ParseCount();
      has_offset = true;
    } else {
      return;
    }
  }
}

void Parser::FinishSelect(Selection& select, bool is_star, std::size_t at) {
  select.aggregates = std::move(scopes_.back().aggregates);
  select.is_grouped = select.is_grouped || !select.aggregates.empty() || !select.having.empty();
  std::set<Slot> visible;
  CollectVisible(select.where, visible);
  if (is_star && query_.form == Form::kSelect && select.is_grouped) {
    tokens_.Fail("SELECT * does not go with GROUP BY", at);
  }
  if (is_star) {
    if (select.values) CollectVisible(*select.values, visible);
    for (const Slot slot : visible) {
      if (!query_.columns[slot].is_hidden) select.projection.push_back({slot, std::nullopt});
    }
    return;
  }
  for (const Assignment& column : select.projection) {
    if (column.expression && visible.count(column.slot) != 0) {
      tokens_.Fail("?" + query_.columns[column.slot].name + " is bound by the pattern already", at);
    }
  }
  if (select.is_grouped) CheckGrouping(select, at);
}

void Parser::CheckGrouping(const Selection& select, std::size_t at) {
  std::set<Slot> known;
  for (const Assignment& key : select.group_by) known.insert(key.slot);
  for (const syntax::Aggregate& aggregate : select.aggregates) known.insert(aggregate.slot);
  for (const Assignment& column : select.projection) {
    if (column.expression) {
      CheckUngrouped(*column.expression, known, at);
      known.insert(column.slot);
    } else if (known.count(column.slot) == 0) {
      tokens_.Fail("?" + query_.columns[column.slot].name +
                       " is neither grouped by nor the value of an aggregate",
                   at);
    }
  }
}

void Parser::CheckUngrouped(const Expression& expression, const std::set<Slot>& known,
                            std::size_t at) {
  if (expression.op == Op::kVariable && known.count(expression.node.index) == 0) {
    tokens_.Fail("?" + query_.columns[expression.node.index].name +
                     " is used outside an aggregate and is not grouped by",
                 at);
  }
  for (const Expression& argument : expression.arguments) CheckUngrouped(argument, known, at);
}

Form Query::form() const { return syntax_->form; }
const std::vector<std::string>& Query::variables() const { return syntax_->variables; }
const std::map<std::string, std::string>& Query::prefixes() const { return syntax_->prefixes; }
bool Query::is_ordered() const { return !syntax_->select.order_by.empty(); }

Query Parse(std::string_view text, const ParseOptions& options) {
  return Query(std::make_shared<const syntax::Query>(Parser(text, options).Parse()));
}

}  // namespace lares::sparql
