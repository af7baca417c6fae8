// What the commands that ask in SPARQL have in common: where the query comes from, what it is asked
// about, and how its terms are shown to people.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "server/cli/command.h"

namespace lares::cli {

struct QueryOptions {
  std::string file;  // "-": standard input
  std::string text;
  std::string recipe, robot, environment;
  int version = 0;
};

// FILE, -q, --recipe, --robot, --environment, --version.
void AddQueryOptions(CLI::App& command, QueryOptions& query);
// The query's text; "" when neither is given. Throws CLI::ValidationError when both are.
std::string ReadQuery(const QueryOptions& query);
// ?recipe=, … of what is given.
std::multimap<std::string, std::string> AboutParameters(const QueryOptions& query);

// Shortens IRIs by the prefixes that need no declaration and those that a query declares.
class TermPrinter {
 public:
  explicit TermPrinter(const std::string& query = "");

  // A term of SPARQL's JSON results on one line: lares:Cup, "two words"@en, 5, _:b1.
  std::string Print(const Json& term) const;
  // ?a = lares:Cup, ?b = 5
  std::string PrintRow(const Json& row) const;

 private:
  std::string Shorten(const std::string& iri) const;

  std::map<std::string, std::string> prefix_by_namespace_;
};

}  // namespace lares::cli
