// The W3C's SPARQL 1.0 and 1.1 query tests, and which of their cases are known to fail.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file.h"
#include "reasoner/sparql/query.h"
#include "tests/lares_data.h"
#include "tests/reasoner/sparql/w3c_cases.h"
#include "tests/reasoner/sparql/w3c_results.h"

namespace lares::sparql::testing {
namespace {

struct Outcome {
  std::optional<std::string> failure;
  bool is_by_value = false;
};

Outcome RunSyntax(const Case& test, const std::string& text, const ParseOptions& options) {
  const bool is_negative = test.kind.starts_with("Negative");
  try {
    Parse(text, options);
    if (is_negative) return {"accepted: " + text};
    return {};
  } catch (const Error& error) {
    if (is_negative && error.code() == Code::kInvalid && error.place() && error.place()->line > 0) {
      return {};
    }
    return {error.FullMessage() + "\n" + text};
  }
}

Outcome RunEvaluation(const Case& test, const std::filesystem::path& folder,
                      const std::string& base, const std::string& text,
                      const ParseOptions& options) {
  try {
    const Query query = Parse(text, options);
    const Dataset dataset = ReadDataset(test, folder, base, text);
    const Answer answer = Evaluate(query, dataset);
    const Expected expected = ReadExpected(folder / test.result, base + test.result, query.form());
    const bool in_order = query.is_ordered() && expected.is_ordered;
    const Likeness likeness = Compare(expected, answer, in_order);
    if (likeness != Likeness::kDifferent) return {{}, likeness == Likeness::kSameByValue};
    return {"query:\n" + text + "\ngot\n" + ToText(answer) + "instead of\n" + ToText(expected)};
  } catch (const Error& error) {
    return {error.FullMessage() + "\n" + text};
  }
}

struct Totals {
  std::size_t cases = 0;
  std::size_t passed = 0;
  std::size_t by_value = 0;
};

// Case → why it fails.
using KnownFailures = std::map<std::string, std::string>;

Totals RunFolder(const std::filesystem::path& root, const std::string& name,
                 const KnownFailures& known_failures) {
  const std::filesystem::path folder = root / name;
  const std::string base = BaseOf(name);
  Totals totals;
  for (const Case& test : ReadManifest(folder, base)) {
    const bool is_evaluation =
        test.kind == "QueryEvaluationTest" || test.kind == "CSVResultFormatTest";
    const bool is_syntax =
        test.kind.starts_with("PositiveSyntaxTest") || test.kind.starts_with("NegativeSyntaxTest");
    if (!is_evaluation && !is_syntax) continue;
    ParseOptions options;
    options.source = test.query;
    options.base_iri = base + test.query;
    const std::string text = ReadFile(folder / test.query);
    const Outcome outcome = is_syntax ? RunSyntax(test, text, options)
                                      : RunEvaluation(test, folder, base, text, options);
    ++totals.cases;
    totals.passed += outcome.failure ? 0 : 1;
    totals.by_value += outcome.is_by_value ? 1 : 0;
    if (known_failures.count(name + "/" + test.name) != 0) {
      EXPECT_TRUE(outcome.failure) << test.name << " passes now: take it out of the list";
    } else {
      EXPECT_FALSE(outcome.failure) << name << "/" << test.name << "\n" << *outcome.failure;
    }
  }
  std::printf("%-36s %3zu of %3zu (numbers by value: %zu)\n", name.c_str(), totals.passed,
              totals.cases, totals.by_value);
  return totals;
}

void RunFolders(const std::string& version, const std::vector<std::string>& names,
                const KnownFailures& known_failures, std::size_t at_least) {
  LARES_REQUIRE_DATA(archive, "conformance/rdf-tests/sparql10-11.tar.gz");
  static const Unpacked unpacked(archive);
  ASSERT_TRUE(unpacked.is_ready());
  Totals sum;
  for (const std::string& name : names) {
    const Totals totals = RunFolder(unpacked.folder(), version + "/" + name, known_failures);
    sum.cases += totals.cases;
    sum.passed += totals.passed;
  }
  std::printf("%s: %zu of %zu\n", version.c_str(), sum.passed, sum.cases);
  EXPECT_GE(sum.cases, at_least);
  EXPECT_GE(static_cast<double>(sum.passed), 0.95 * static_cast<double>(sum.cases));
}

TEST(W3cSparql, Version10) {
  RunFolders("sparql10",
             {"algebra",
              "ask",
              "basic",
              "bnode-coreference",
              "boolean-effective-value",
              "bound",
              "cast",
              "construct",
              "dataset",
              "distinct",
              "expr-builtin",
              "expr-equals",
              "expr-ops",
              "graph",
              "i18n",
              "open-world",
              "optional",
              "optional-filter",
              "reduced",
              "regex",
              "solution-seq",
              "sort",
              "syntax-sparql1",
              "syntax-sparql2",
              "syntax-sparql3",
              "syntax-sparql4",
              "syntax-sparql5",
              "triple-match",
              "type-promotion"},
             {}, 482);
}

// Left out: service and syntax-fed's evaluation (no other endpoint is ever asked), entailment
// (other regimes), and what is no query.
TEST(W3cSparql, Version11) {
  RunFolders("sparql11",
             {"aggregates", "bind", "bindings", "cast", "construct", "csv-tsv-res", "exists",
              "functions", "grouping", "json-res", "negation", "project-expression",
              "property-path", "subquery", "syntax-fed", "syntax-query"},
             {}, 341);
}

}  // namespace
}  // namespace lares::sparql::testing
