// What a query says: the parser's outcome, with variables resolved to columns.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ontology/rdf/term.h"
#include "reasoner/sparql/query.h"

namespace lares::sparql::syntax {

// A column of a solution. Each variable of each scope (the query, a sub-select) has its own, and so
// have blank nodes of patterns and the values of aggregates.
using Slot = std::uint32_t;

struct Column {
  std::string name;        // without '?'
  bool is_hidden = false;  // no variable of the text: a blank node or an intermediate value
};

struct Node {
  enum class Kind : std::uint8_t { kNone, kVariable, kTerm, kBlank };
  Kind kind = Kind::kNone;
  std::uint32_t index = 0;  // a Slot; an index into Query::terms; a blank node of a template

  bool is_variable() const { return kind == Kind::kVariable; }
  friend bool operator==(const Node&, const Node&) = default;
};

struct TriplePattern {
  Node subject, predicate, object;
};

struct Path {
  enum class Kind {
    kIri,
    kInverse,
    kSequence,
    kAlternative,
    kZeroOrMore,
    kOneOrMore,
    kZeroOrOne,
    kNegated,
  };
  Kind kind = Kind::kIri;
  Node iri;                                     // of kIri
  std::vector<Path> parts;                      // of what is made of paths
  std::vector<Node> not_forward, not_backward;  // of kNegated
};

// Operators and the built-in functions, in the order of the table in functions.cc.
enum class Op {
  kVariable,
  kTerm,
  kOr,
  kAnd,
  kNot,
  kEqual,
  kNotEqual,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kIn,
  kNotIn,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kNegate,
  kPlus,
  kExists,
  kNotExists,
  kCast,
  kStr,
  kLang,
  kLangMatches,
  kDatatype,
  kBound,
  kIri,
  kBnode,
  kRand,
  kAbs,
  kCeil,
  kFloor,
  kRound,
  kConcat,
  kStrlen,
  kUcase,
  kLcase,
  kEncodeForUri,
  kContains,
  kStrstarts,
  kStrends,
  kStrbefore,
  kStrafter,
  kYear,
  kMonth,
  kDay,
  kHours,
  kMinutes,
  kSeconds,
  kTimezone,
  kTz,
  kNow,
  kUuid,
  kStruuid,
  kMd5,
  kSha1,
  kSha256,
  kSha384,
  kSha512,
  kCoalesce,
  kIf,
  kStrlang,
  kStrdt,
  kSameTerm,
  kIsIri,
  kIsBlank,
  kIsLiteral,
  kIsNumeric,
  kRegex,
  kSubstr,
  kReplace,
};

struct Pattern;

struct Expression {
  Op op = Op::kTerm;
  Node node;  // of kVariable, kTerm; the function's IRI of kCast
  std::vector<Expression> arguments;
  std::shared_ptr<const Pattern> pattern;  // of kExists, kNotExists
};

struct Aggregate {
  enum class Kind { kCount, kSum, kMin, kMax, kAvg, kSample, kGroupConcat };
  Kind kind = Kind::kCount;
  bool is_distinct = false;
  std::optional<Expression> argument;  // nothing: COUNT(*)
  std::string separator = " ";
  Slot slot = 0;  // where its value goes
};

struct Assignment {
  Slot slot = 0;
  std::optional<Expression> expression;  // nothing: the variable itself
};

struct OrderKey {
  Expression expression;
  bool is_descending = false;
};

struct Selection;

struct Pattern {
  enum class Kind {
    kGroup,     // children, joined from left to right; filters among them hold for all
    kTriples,   // triples
    kPath,      // ends.subject path ends.object
    kUnion,     // children
    kOptional,  // one child
    kMinus,     // one child
    kGraph,     // node, one child
    kService,   // node, one child
    kFilter,    // expression
    kBind,      // expression AS slot
    kValues,    // slots, rows
    kSelect,    // select
  };
  Kind kind = Kind::kGroup;
  std::vector<Pattern> children;
  std::vector<TriplePattern> triples;
  TriplePattern ends;
  Path path;
  Node node;
  bool is_silent = false;
  Expression expression;
  Slot slot = 0;
  std::vector<Slot> slots;
  std::vector<std::vector<Node>> rows;  // kNone for UNDEF
  std::shared_ptr<const Selection> select;
};

// A SELECT with what may follow it; the other forms use of it what they have.
struct Selection {
  bool is_distinct = false;
  bool is_reduced = false;
  std::vector<Assignment> projection;
  Pattern where;
  bool is_grouped = false;
  std::vector<Assignment> group_by;
  std::vector<Aggregate> aggregates;
  std::vector<Expression> having;
  std::vector<OrderKey> order_by;
  std::optional<std::uint64_t> limit;
  std::uint64_t offset = 0;
  std::optional<Pattern> values;  // after the modifiers
  // Of a sub-select: the projected column inside → the variable's column outside.
  std::vector<std::pair<Slot, Slot>> outside;
};

struct Query {
  Form form = Form::kSelect;
  Selection select;
  std::vector<TriplePattern> construct;
  std::uint32_t blanks = 0;  // of the template
  std::vector<Node> describe;
  std::vector<std::string> from, from_named;
  std::vector<rdf::Term> terms;
  std::vector<Column> columns;
  std::vector<std::string> variables;
  std::map<std::string, std::string> prefixes;
  bool uses_graphs = false;  // has GRAPH somewhere
  std::string base_iri;
};

}  // namespace lares::sparql::syntax
