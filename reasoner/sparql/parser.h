// Recursive descent over the grammar of SPARQL 1.1 Query, section 19.8.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoner/sparql/syntax.h"
#include "reasoner/sparql/tokens.h"

namespace lares::sparql {

// Parses one text once. Files: parser.cc (queries and modifiers), parser_terms.cc,
// parser_pattern.cc, parser_path.cc, parser_expression.cc.
class Parser {
 public:
  Parser(std::string_view text, const ParseOptions& options);
  syntax::Query Parse();

 private:
  using Node = syntax::Node;
  using Slot = syntax::Slot;

  // Which variables a SELECT knows, and what its expressions may have.
  struct Scope {
    std::map<std::string, Slot, std::less<>> slots;
    std::vector<syntax::Aggregate> aggregates;
    bool may_aggregate = false;  // here in the text
    bool in_aggregate = false;
  };

  // Counts one level for as long as it lives.
  class Depth {
   public:
    explicit Depth(Parser& parser);
    ~Depth() { --parser_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    Parser& parser_;
  };

  // Tokens.
  bool Accept(std::string_view punctuation);
  bool AcceptWord(std::string_view upper);
  void Expect(std::string_view punctuation);
  void ExpectWord(std::string_view upper);
  [[noreturn]] void FailHere(const std::string& expected);
  void CountStep();

  // Queries.
  void ParsePrologue();
  void ParseSelectQuery();
  void ParseConstructQuery();
  void ParseDescribeQuery();
  void ParseAskQuery();
  void ParseDatasetClauses();
  void ParseWhere(syntax::Selection& select);
  void ParseSelectClause(syntax::Selection& select, bool& is_star);
  void ParseModifiers(syntax::Selection& select);
  void ParseGroupBy(syntax::Selection& select);
  void ParseHaving(syntax::Selection& select);
  void ParseOrderBy(syntax::Selection& select);
  void ParseLimits(syntax::Selection& select);
  std::uint64_t ParseCount();
  void FinishSelect(syntax::Selection& select, bool is_star, std::size_t at);
  void CheckGrouping(const syntax::Selection& select, std::size_t at);
  void CheckUngrouped(const syntax::Expression& expression, const std::set<Slot>& known,
                      std::size_t at);
  syntax::Selection ParseSubSelect();

  // Terms.
  Node ParseTermOrVariable(bool allow_variable);
  bool StartsTerm() const;
  bool StartsVerb() const;
  Node ParseLiteral();
  Node ParseNumber(std::string_view sign);
  Node AddTerm(rdf::Term term);
  Node AddIri(std::string iri) { return AddTerm(rdf::Term::Iri(iri)); }
  std::string ParseIri();
  std::string ResolveName(const Token& token);
  std::string ResolveReference(const Token& token);
  Slot ParseVariable();
  Slot SlotOf(std::string_view name);
  Slot HiddenSlot(std::string name);
  Node Variable(Slot slot) const { return {Node::Kind::kVariable, slot}; }
  Node Rdf(std::string_view local);

  // Patterns.
  syntax::Pattern ParseGroup();
  syntax::Pattern ParseGroupBody();
  void ParseTriplesInto(syntax::Pattern& group);
  void ParseTriplesSameSubject(syntax::Pattern& group);
  Node ParseTriplesNode(syntax::Pattern& group);
  Node ParseCollection(syntax::Pattern& group);
  void ParsePropertyList(syntax::Pattern& group, Node subject);
  void ParseObjectList(syntax::Pattern& group, Node subject, const syntax::Path& path);
  Node ParseGraphNode(syntax::Pattern& group);
  Node ParseBlank();
  Node FreshBlank();
  void AddTriple(syntax::Pattern& group, Node subject, const syntax::Path& path, Node object);
  void ParseGroupOrUnion(syntax::Pattern& group);
  void ParseGraph(syntax::Pattern& group);
  void ParseService(syntax::Pattern& group);
  void ParseBind(syntax::Pattern& group);
  syntax::Pattern ParseValues();
  void ParseTemplate();
  void EndBasicPattern();

  // Paths.
  syntax::Path ParseVerb();
  syntax::Path ParsePath();
  syntax::Path ParseSequence();
  syntax::Path ParseElement();
  syntax::Path ParsePrimary();
  syntax::Path ParseNegated();
  void ParseNegatedOne(syntax::Path& path);

  // Expressions.
  syntax::Expression ParseExpression();
  syntax::Expression ParseAnd();
  syntax::Expression ParseRelational();
  syntax::Expression ParseAdditive();
  syntax::Expression ParseMultiplicative();
  syntax::Expression ParseUnary();
  syntax::Expression ParsePrimaryExpression();
  syntax::Expression ParseBracketed();
  syntax::Expression ParseConstraint();
  std::vector<syntax::Expression> ParseExpressionList();
  syntax::Expression ParseFunctionCall(std::string iri, std::size_t at);
  std::optional<syntax::Expression> ParseBuiltIn();
  syntax::Expression ParseExists(syntax::Op op);
  syntax::Expression ParseAggregate(syntax::Aggregate::Kind kind);
  syntax::Expression TermExpression(Node node) const;
  syntax::Expression Combine(syntax::Op op, syntax::Expression left, syntax::Expression right);

  ParseOptions options_;
  std::string resolved_;  // the text, when escapes had to be resolved
  Tokens tokens_;
  syntax::Query query_;
  std::vector<Scope> scopes_;
  std::unordered_map<std::string, std::uint32_t> term_index_;
  int depth_ = 0;
  std::size_t steps_ = 0;
  bool in_template_ = false;
  // Blank node labels: those of the basic graph pattern at hand, and those of earlier ones.
  std::map<std::string, Node, std::less<>> labels_;
  std::set<std::string, std::less<>> closed_labels_;
};

}  // namespace lares::sparql
