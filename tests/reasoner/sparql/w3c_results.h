// Expected answers of the W3C's SPARQL tests, in any of their formats, and their comparison.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ontology/rdf/document.h"
#include "reasoner/sparql/query.h"

namespace lares::sparql::testing {

struct Expected {
  std::vector<std::string> variables;
  std::vector<std::map<std::string, rdf::Term>> rows;
  std::optional<bool> yes;
  std::optional<rdf::Document> graph;
  bool is_csv = false;      // terms are plain text
  bool is_ordered = false;  // the file numbers its rows
};

// .srx, .srj, .csv, .tsv, and .ttl or .rdf with a result set (or a graph, for the form that has
// one). Throws Error for what cannot be read.
Expected ReadExpected(const std::filesystem::path& file, const std::string& base_iri, Form form);

enum class Likeness { kSame, kSameByValue, kDifferent };

// Rows as bags (in order when `in_order`), blank nodes renamed; kSameByValue: only when numbers are
// compared by their values.
Likeness Compare(const Expected& expected, const Answer& answer, bool in_order);

std::string ToText(const Expected& expected);
std::string ToText(const Answer& answer);

}  // namespace lares::sparql::testing
