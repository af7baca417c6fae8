// What the parts of one evaluation share.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reasoner/sparql/limits.h"
#include "reasoner/sparql/regex.h"
#include "reasoner/sparql/source.h"
#include "reasoner/sparql/syntax.h"
#include "reasoner/sparql/terms.h"
#include "reasoner/sparql/value.h"

namespace lares::sparql {

class Operator;

// One solution in the making: a term for each column of the query, kAnyTerm where it is unbound.
using Row = std::vector<TermId>;

// A graph that GRAPH may name.
struct Named {
  TermId iri{};
  Source* source = nullptr;
};

// Not thread-safe: one evaluation, one thread.
struct Context {
  Context(const syntax::Query& asked, const Dataset& of, const Limits& limits,
          std::stop_token stop);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Value& Constant(const syntax::Node& term) const { return constant_values[term.index]; }
  // The term of a node in a row; kAnyTerm for an unbound variable.
  TermId At(const syntax::Node& node, const Row& row) const {
    return node.is_variable() ? row[node.index] : constants[node.index];
  }
  Value ValueAt(TermId id) const {
    return id == rdf::kAnyTerm ? Value{} : ValueOf(terms.Get(id), id);
  }
  // The compiled expression, or null when it is not valid; kept for the evaluation.
  const Regex* RegexOf(std::string_view pattern, std::string_view flags);
  std::string FreshBlankLabel();

  const syntax::Query& query;
  const Dataset& dataset;
  Account account;
  Guard guard;
  Terms terms;
  std::vector<TermId> constants;  // of query.terms
  std::vector<Value> constant_values;
  std::vector<std::unique_ptr<Source>> sources;
  Source* default_graph = nullptr;
  std::vector<Named> named;
  // What EXISTS takes from the row that it is asked for; empty columns elsewhere.
  Row base_row;
  std::unordered_map<const syntax::Pattern*, std::unique_ptr<Operator>> exists;
  std::map<std::pair<std::string, std::string>, std::optional<Regex>> regexes;
  std::map<std::string, std::string, std::less<>> blanks;  // of BNODE("…"), within one solution
  std::mt19937_64 random;
  std::string now;
  std::size_t next_blank = 0;
  bool counts_rows = false;  // each operator counts what it gives

 private:
  void OpenGraphs();
};

}  // namespace lares::sparql
