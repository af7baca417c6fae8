// SPARQL 1.1 Query (W3C Recommendation 21 March 2013) over snapshots of triples.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/document.h"
#include "ontology/triples/view.h"

namespace lares::sparql {

namespace syntax {
struct Query;
}

struct ParseOptions {
  std::string source;    // file name or id for error places
  std::string base_iri;  // for relative IRIs where the query states no BASE
  // Prefixes that the query may use without declaring them: prefix without ':' → IRI.
  std::map<std::string, std::string> prefixes;
  std::size_t max_bytes = 1u << 20;  // of the text
  int max_depth = 100;               // nesting of groups, expressions, lists and paths together
  std::size_t max_steps = 2000;      // triple patterns, filters and other parts of patterns
};

enum class Form { kSelect, kAsk, kConstruct, kDescribe };

// A parsed query: an immutable value, cheap to copy, usable by any number of threads and over any
// dataset.
class Query {
 public:
  explicit Query(std::shared_ptr<const syntax::Query> syntax) : syntax_(std::move(syntax)) {}

  Form form() const;
  // Of SELECT, in order, without '?'; SELECT * is resolved. Empty for other forms.
  const std::vector<std::string>& variables() const;
  // As declared in the query: prefix without ':' → IRI.
  const std::map<std::string, std::string>& prefixes() const;
  // Whether the query says in which order its rows come.
  bool is_ordered() const;
  const syntax::Query& syntax() const { return *syntax_; }

 private:
  std::shared_ptr<const syntax::Query> syntax_;
};

// Throws kInvalid with line and column (columns count characters) for what is no query, kTooLarge
// for a limit of the options, kUnsupported for an update. Thread-safe.
Query Parse(std::string_view text, const ParseOptions& options = {});

// The asserted triples of one graph. `triples` are sorted and distinct, their ids of the dataset's
// dictionary; whoever builds the dataset keeps them alive, by `pin` or by its View.
struct NamedGraph {
  std::string iri;
  std::span<const rdf::Triple> triples;
  std::shared_ptr<const void> pin;
};

// What a query is asked of. Without FROM and FROM NAMED the default graph is the whole view,
// asserted and inferred, and every named graph is visible. FROM makes the default graph the union
// of the named graphs that it lists; FROM NAMED leaves only those that it lists.
struct Dataset {
  rdf::View default_graph;
  std::vector<NamedGraph> named;  // distinct IRIs
};

// Every graph of every layer, under the IRI that `iri_of_name` gives for its name.
Dataset DatasetOf(const rdf::View& view,
                  const std::function<std::string(std::string_view)>& iri_of_name);
// The IRI of a document's graph: its name with '/' for ':' after
// https://w3id.org/lares/documents/.
std::string DocumentGraphIri(std::string_view name);

struct Limits {
  std::chrono::milliseconds timeout{10'000};  // then kTimeout
  std::size_t max_rows = 1'000'000;  // of the answer (triples for CONSTRUCT); then kTooLarge
  std::size_t max_memory_bytes = 256u
                                 << 20;  // tables, indexes and terms of one query; then kTooLarge
};

// What an evaluation took.
struct Statistics {
  std::size_t rows = 0;
  std::size_t triples_visited = 0;
  std::size_t peak_memory_bytes = 0;
  std::chrono::microseconds elapsed{0};
};

// One solution: a term for each of Query::variables(), or nothing where it is unbound. Valid during
// the call that it is given to.
using Cells = std::span<const std::optional<rdf::TermView>>;
// Returns false to have no more rows.
using RowVisitor = std::function<bool(Cells)>;

// What follows throws kTimeout (time is up, or a stop is requested), kTooLarge, kNotFound (FROM
// names a graph that the dataset does not have), kUnsupported (SERVICE), and what the visitor
// throws. Nothing is interned in the dataset's dictionary: terms that a query makes live as long as
// its evaluation. Each needs the query's form; kInternal otherwise. Thread-safe.

// Rows in order as they are found: only ORDER BY, GROUP BY, DISTINCT and joins without an index
// keep rows, and those count as memory.
Statistics Select(const Query& query, const Dataset& dataset, const Limits& limits,
                  std::stop_token stop, const RowVisitor& visit);
bool Ask(const Query& query, const Dataset& dataset, const Limits& limits, std::stop_token stop);
// CONSTRUCT and DESCRIBE (concise bounded descriptions in the default graph). The document carries
// the query's prefixes.
rdf::Document Construct(const Query& query, const Dataset& dataset, const Limits& limits,
                        std::stop_token stop);

// An answer of any form, collected.
struct Answer {
  Form form = Form::kSelect;
  std::vector<std::string> variables;
  std::vector<std::vector<std::optional<rdf::Term>>> rows;  // of SELECT
  bool yes = false;                                         // of ASK
  rdf::Document graph;                                      // of CONSTRUCT and DESCRIBE
  Statistics statistics;
};

Answer Evaluate(const Query& query, const Dataset& dataset, const Limits& limits = {},
                std::stop_token stop = {});

enum class ExplainFormat { kText, kJson };

// The plan: operators in the order in which they run, with estimated rows. With `limits` the query
// is run as well and each operator says how many rows it really gave.
std::string Explain(const Query& query, const Dataset& dataset, ExplainFormat format,
                    const std::optional<Limits>& limits = std::nullopt, std::stop_token stop = {});

}  // namespace lares::sparql
