#include <array>
#include <utility>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/parser.h"

namespace lares::sparql {

using syntax::Aggregate;
using syntax::Expression;
using syntax::Op;

namespace {

struct BuiltIn {
  std::string_view name;
  Op op;
  std::size_t fewest;
  std::size_t most;
};

constexpr std::size_t kAnyNumber = SIZE_MAX;

constexpr std::array<BuiltIn, 55> kBuiltIns = {{
    {"STR", Op::kStr, 1, 1},
    {"LANG", Op::kLang, 1, 1},
    {"LANGMATCHES", Op::kLangMatches, 2, 2},
    {"DATATYPE", Op::kDatatype, 1, 1},
    {"BOUND", Op::kBound, 1, 1},
    {"IRI", Op::kIri, 1, 1},
    {"URI", Op::kIri, 1, 1},
    {"BNODE", Op::kBnode, 0, 1},
    {"RAND", Op::kRand, 0, 0},
    {"ABS", Op::kAbs, 1, 1},
    {"CEIL", Op::kCeil, 1, 1},
    {"FLOOR", Op::kFloor, 1, 1},
    {"ROUND", Op::kRound, 1, 1},
    {"CONCAT", Op::kConcat, 0, kAnyNumber},
    {"STRLEN", Op::kStrlen, 1, 1},
    {"UCASE", Op::kUcase, 1, 1},
    {"LCASE", Op::kLcase, 1, 1},
    {"ENCODE_FOR_URI", Op::kEncodeForUri, 1, 1},
    {"CONTAINS", Op::kContains, 2, 2},
    {"STRSTARTS", Op::kStrstarts, 2, 2},
    {"STRENDS", Op::kStrends, 2, 2},
    {"STRBEFORE", Op::kStrbefore, 2, 2},
    {"STRAFTER", Op::kStrafter, 2, 2},
    {"YEAR", Op::kYear, 1, 1},
    {"MONTH", Op::kMonth, 1, 1},
    {"DAY", Op::kDay, 1, 1},
    {"HOURS", Op::kHours, 1, 1},
    {"MINUTES", Op::kMinutes, 1, 1},
    {"SECONDS", Op::kSeconds, 1, 1},
    {"TIMEZONE", Op::kTimezone, 1, 1},
    {"TZ", Op::kTz, 1, 1},
    {"NOW", Op::kNow, 0, 0},
    {"UUID", Op::kUuid, 0, 0},
    {"STRUUID", Op::kStruuid, 0, 0},
    {"MD5", Op::kMd5, 1, 1},
    {"SHA1", Op::kSha1, 1, 1},
    {"SHA256", Op::kSha256, 1, 1},
    {"SHA384", Op::kSha384, 1, 1},
    {"SHA512", Op::kSha512, 1, 1},
    {"COALESCE", Op::kCoalesce, 0, kAnyNumber},
    {"IF", Op::kIf, 3, 3},
    {"STRLANG", Op::kStrlang, 2, 2},
    {"STRDT", Op::kStrdt, 2, 2},
    {"SAMETERM", Op::kSameTerm, 2, 2},
    {"ISIRI", Op::kIsIri, 1, 1},
    {"ISURI", Op::kIsIri, 1, 1},
    {"ISBLANK", Op::kIsBlank, 1, 1},
    {"ISLITERAL", Op::kIsLiteral, 1, 1},
    {"ISNUMERIC", Op::kIsNumeric, 1, 1},
    {"REGEX", Op::kRegex, 2, 3},
    {"SUBSTR", Op::kSubstr, 2, 3},
    {"REPLACE", Op::kReplace, 3, 4},
    {"EXISTS", Op::kExists, 0, 0},
    {"NOT", Op::kNotExists, 0, 0},
    {"", Op::kTerm, 0, 0},
}};

struct AggregateName {
  std::string_view name;
  Aggregate::Kind kind;
};

constexpr std::array<AggregateName, 7> kAggregates = {{
    {"COUNT", Aggregate::Kind::kCount},
    {"SUM", Aggregate::Kind::kSum},
    {"MIN", Aggregate::Kind::kMin},
    {"MAX", Aggregate::Kind::kMax},
    {"AVG", Aggregate::Kind::kAvg},
    {"SAMPLE", Aggregate::Kind::kSample},
    {"GROUP_CONCAT", Aggregate::Kind::kGroupConcat},
}};

std::optional<Op> Comparison(const Token& token) {
  if (token.Is("=")) return Op::kEqual;
  if (token.Is("!=")) return Op::kNotEqual;
  if (token.Is("<")) return Op::kLess;
  if (token.Is(">")) return Op::kGreater;
  if (token.Is("<=")) return Op::kLessEqual;
  if (token.Is(">=")) return Op::kGreaterEqual;
  return std::nullopt;
}

}  // namespace

Expression Parser::TermExpression(Node node) const {
  Expression expression;
  expression.op = node.is_variable() ? Op::kVariable : Op::kTerm;
  expression.node = node;
  return expression;
}

Expression Parser::Combine(Op op, Expression left, Expression right) {
  CountStep();
  Expression both;
  both.op = op;
  both.arguments.push_back(std::move(left));
  both.arguments.push_back(std::move(right));
  return both;
}

Expression Parser::ParseExpression() {
  const Depth depth(*this);
  Expression left = ParseAnd();
  while (Accept("||")) left = Combine(Op::kOr, std::move(left), ParseAnd());
  return left;
}

Expression Parser::ParseAnd() {
  Expression left = ParseRelational();
  while (Accept("&&")) left = Combine(Op::kAnd, std::move(left), ParseRelational());
  return left;
}

Expression Parser::ParseRelational() {
  Expression left = ParseAdditive();
  if (const auto op = Comparison(tokens_.Peek())) {
    tokens_.Take();
    return Combine(*op, std::move(left), ParseAdditive());
  }
  Op op = Op::kIn;
  if (AcceptWord("NOT")) {
    op = Op::kNotIn;
    if (!tokens_.Peek().IsWord("IN")) FailHere("IN");
  }
  if (!AcceptWord("IN")) return left;
  CountStep();
  Expression in;
  in.op = op;
  in.arguments = ParseExpressionList();
  in.arguments.insert(in.arguments.begin(), std::move(left));
  return in;
}

Expression Parser::ParseAdditive() {
  Expression left = ParseMultiplicative();
  for (;;) {
    if (Accept("+")) {
      left = Combine(Op::kAdd, std::move(left), ParseMultiplicative());
    } else if (Accept("-")) {
      left = Combine(Op::kSubtract, std::move(left), ParseMultiplicative());
    } else {
      return left;
    }
  }
}

Expression Parser::ParseMultiplicative() {
  Expression left = ParseUnary();
  for (;;) {
    if (Accept("*")) {
      left = Combine(Op::kMultiply, std::move(left), ParseUnary());
    } else if (Accept("/")) {
      left = Combine(Op::kDivide, std::move(left), ParseUnary());
    } else {
      return left;
    }
  }
}

Expression Parser::ParseUnary() {
  const Depth depth(*this);
  const Token token = tokens_.Peek();
  if (Accept("!")) {
    Expression expression;
    expression.op = Op::kNot;
    expression.arguments.push_back(ParseUnary());
    return expression;
  }
  if (!token.Is("+") && !token.Is("-")) return ParsePrimaryExpression();
  tokens_.Take();
  const Token& next = tokens_.Peek();
  const bool is_number = next.kind == Token::Kind::kInteger || next.kind == Token::Kind::kDecimal ||
                         next.kind == Token::Kind::kDouble;
  if (is_number && next.begin == token.end) return TermExpression(ParseNumber(token.text));
  Expression expression;
  expression.op = token.Is("-") ? Op::kNegate : Op::kPlus;
  expression.arguments.push_back(ParsePrimaryExpression());
  return expression;
}

Expression Parser::ParseBracketed() {
  Expect("(");
  Expression expression = ParseExpression();
  Expect(")");
  return expression;
}

Expression Parser::ParsePrimaryExpression() {
  const Token& token = tokens_.Peek();
  if (token.Is("(")) return ParseBracketed();
  if (token.kind == Token::Kind::kVariable) return TermExpression(Variable(ParseVariable()));
  if (token.kind == Token::Kind::kIri || token.kind == Token::Kind::kName) {
    const std::size_t at = token.begin;
    std::string iri = ParseIri();
    if (tokens_.Peek().Is("(") || tokens_.Peek().Is("()")) {
      return ParseFunctionCall(std::move(iri), at);
    }
    return TermExpression(AddIri(std::move(iri)));
  }
  if (token.kind == Token::Kind::kWord && !token.IsWord("TRUE") && !token.IsWord("FALSE")) {
    if (auto call = ParseBuiltIn()) return std::move(*call);
    FailHere("an expression");
  }
  if (token.Is("()") || token.Is("[]")) FailHere("an expression");
  return TermExpression(ParseLiteral());
}

// What FILTER and HAVING take: in brackets, or a call.
Expression Parser::ParseConstraint() {
  const Token& token = tokens_.Peek();
  if (token.Is("(")) return ParseBracketed();
  if (token.kind == Token::Kind::kIri || token.kind == Token::Kind::kName) {
    const std::size_t at = token.begin;
    return ParseFunctionCall(ParseIri(), at);
  }
  if (auto call = ParseBuiltIn()) return std::move(*call);
  FailHere("'(' or a function");
}

std::vector<Expression> Parser::ParseExpressionList() {
  std::vector<Expression> list;
  if (Accept("()")) return list;
  Expect("(");
  do {
    list.push_back(ParseExpression());
  } while (Accept(","));
  Expect(")");
  return list;
}

Expression Parser::ParseFunctionCall(std::string iri, std::size_t at) {
  CountStep();
  if (!tokens_.Peek().Is("(") && !tokens_.Peek().Is("()")) FailHere("'('");
  Expression call;
  call.op = Op::kCast;
  call.node = AddIri(std::move(iri));
  if (tokens_.Peek().Is("(")) {
    Accept("(");
    if (AcceptWord("DISTINCT")) tokens_.Fail("only aggregates take DISTINCT", at);
    do {
      call.arguments.push_back(ParseExpression());
    } while (Accept(","));
    Expect(")");
  } else {
    Accept("()");
  }
  return call;
}

std::optional<Expression> Parser::ParseBuiltIn() {
  const Token& token = tokens_.Peek();
  if (token.kind != Token::Kind::kWord) return std::nullopt;
  for (const AggregateName& aggregate : kAggregates) {
    if (token.IsWord(aggregate.name)) return ParseAggregate(aggregate.kind);
  }
  for (const BuiltIn& function : kBuiltIns) {
    if (!token.IsWord(function.name)) continue;
    CountStep();
    const Token name = tokens_.Take();
    if (function.op == Op::kNotExists) ExpectWord("EXISTS");
    if (function.op == Op::kExists || function.op == Op::kNotExists) {
      return ParseExists(function.op);
    }
    Expression call;
    call.op = function.op;
    call.arguments = ParseExpressionList();
    const std::size_t count = call.arguments.size();
    if (count < function.fewest || count > function.most) {
      tokens_.Fail(
          std::string(function.name) + " does not take " + std::to_string(count) + " arguments",
          name.begin);
    }
    if (call.op == Op::kBound && call.arguments[0].op != Op::kVariable) {
      tokens_.Fail("BOUND takes a variable", name.begin);
    }
    return call;
  }
  return std::nullopt;
}

Expression Parser::ParseExists(Op op) {
  // The pattern inside is another one for the labels of blank nodes, and the one around goes on.
  const auto labels = labels_;
  const bool may_aggregate = std::exchange(scopes_.back().may_aggregate, false);
  Expression exists;
  exists.op = op;
  exists.pattern = std::make_shared<const syntax::Pattern>(ParseGroup());
  scopes_.back().may_aggregate = may_aggregate;
  labels_ = labels;
  for (const auto& [label, node] : labels_) closed_labels_.erase(label);
  return exists;
}

Expression Parser::ParseAggregate(Aggregate::Kind kind) {
  const Token name = tokens_.Take();
  Scope& scope = scopes_.back();
  if (!scope.may_aggregate) tokens_.Fail("an aggregate has no place here", name.begin);
  if (scope.in_aggregate) tokens_.Fail("an aggregate has no place in another", name.begin);
  CountStep();
  scope.in_aggregate = true;
  Aggregate aggregate;
  aggregate.kind = kind;
  Expect("(");
  aggregate.is_distinct = AcceptWord("DISTINCT");
  if (kind != Aggregate::Kind::kCount || !Accept("*")) aggregate.argument = ParseExpression();
  if (kind == Aggregate::Kind::kGroupConcat && Accept(";")) {
    ExpectWord("SEPARATOR");
    Expect("=");
    const Token separator = tokens_.Take();
    if (separator.kind != Token::Kind::kString) {
      tokens_.Fail("expected a separator in quotes", separator.begin);
    }
    aggregate.separator = separator.value;
  }
  Expect(")");
  aggregate.slot = HiddenSlot(std::string(name.text));
  scopes_.back().in_aggregate = false;
  const Node value = Variable(aggregate.slot);
  scopes_.back().aggregates.push_back(std::move(aggregate));
  return TermExpression(value);
}

}  // namespace lares::sparql
