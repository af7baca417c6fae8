// The W3C's SPARQL 1.0 and 1.1 query tests, and which of their cases are known to fail.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/sparql/query.h"
#include "tests/lares_data.h"
#include "tests/reasoner/sparql/w3c_results.h"

namespace lares::sparql::testing {
namespace {

using rdf::Document;
using rdf::Statement;

constexpr std::string_view kManifest = "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
constexpr std::string_view kQuery = "http://www.w3.org/2001/sw/DataAccess/tests/test-query#";

struct Case {
  std::string name;
  std::string kind;  // "QueryEvaluationTest", …
  std::string query, result;
  std::vector<std::string> data, graphs;
};

// The archive, unpacked once.
class Unpacked {
 public:
  explicit Unpacked(const std::filesystem::path& archive) {
    std::string pattern = (std::filesystem::temp_directory_path() / "lares-sparql-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) return;
    folder_ = pattern;
    const std::string command = "tar -xzf '" + archive.string() + "' -C '" + pattern + "'";
    is_ready_ = std::system(command.c_str()) == 0;
  }
  ~Unpacked() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  bool is_ready() const { return is_ready_; }
  std::filesystem::path folder() const { return folder_ / "sparql"; }

 private:
  std::filesystem::path folder_;
  bool is_ready_ = false;
};

Document ReadFrom(const std::filesystem::path& file, const std::string& base) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  options.base_iri = base + file.filename().string();
  const std::string text = ReadFile(file);
  return rdf::ReadRdf(text, rdf::GuessFormat("", options.source, text), options);
}

class Manifest {
 public:
  Manifest(const std::filesystem::path& file, const std::string& base)
      : base_(base), document_(ReadFrom(file, base)) {
    for (const Statement& s : document_.statements) {
      const std::string& predicate = document_.terms[s.predicate].value;
      rows_[s.subject][predicate].push_back(s.object);
      if (predicate == std::string(rdf::kRdf) + "first") listed_.insert(s.object);
    }
  }

  std::vector<Case> Cases() const {
    std::vector<Case> cases;
    for (const auto& [subject, row] : rows_) {
      const auto kinds = All(subject, rdf::kRdf, "type");
      const auto actions = All(subject, kManifest, "action");
      if (kinds.empty() || actions.empty() || listed_.count(subject) == 0) continue;
      const std::string kind = document_.terms[kinds[0]].value.substr(kManifest.size());
      const std::string id = document_.terms[subject].value;
      Case test{id.substr(id.find('#') + 1), kind, "", "", {}, {}};
      const auto queries = All(actions[0], kQuery, "query");
      test.query = Local(queries.empty() ? actions[0] : queries[0]);
      for (const std::uint32_t file : All(actions[0], kQuery, "data")) {
        test.data.push_back(Local(file));
      }
      for (const std::uint32_t file : All(actions[0], kQuery, "graphData")) {
        test.graphs.push_back(Local(file));
      }
      for (const std::uint32_t file : All(subject, kManifest, "result")) test.result = Local(file);
      cases.push_back(std::move(test));
    }
    return cases;
  }

 private:
  std::vector<std::uint32_t> All(std::uint32_t subject, std::string_view space,
                                 std::string_view name) const {
    const auto row = rows_.find(subject);
    if (row == rows_.end()) return {};
    const auto value = row->second.find(std::string(space) + std::string(name));
    return value == row->second.end() ? std::vector<std::uint32_t>{} : value->second;
  }
  std::string Local(std::uint32_t term) const {
    const std::string& iri = document_.terms[term].value;
    return iri.starts_with(base_) ? iri.substr(base_.size()) : iri;
  }

  std::string base_;
  Document document_;
  std::set<std::uint32_t> listed_;  // in mf:entries
  std::map<std::uint32_t, std::map<std::string, std::vector<std::uint32_t>>> rows_;
};

// The graphs of one case.
class Graphs {
 public:
  Graphs(const std::filesystem::path& folder, std::string base)
      : folder_(folder), base_(std::move(base)) {}

  std::shared_ptr<rdf::Graph> Read(const std::vector<std::string>& files) {
    auto graph = std::make_shared<rdf::Graph>();
    for (const std::string& file : files) {
      rdf::Graph one = rdf::MakeGraph(ReadFrom(folder_ / file, base_),
                                      "g" + std::to_string(++count_), {}, *dictionary_);
      graph->triples.insert(graph->triples.end(), one.triples.begin(), one.triples.end());
    }
    std::sort(graph->triples.begin(), graph->triples.end());
    graph->triples.erase(std::unique(graph->triples.begin(), graph->triples.end()),
                         graph->triples.end());
    return graph;
  }

  Dataset Make(const Case& test, const std::vector<std::string>& from_clauses) {
    std::vector<rdf::Graph> graphs{*Read(test.data)};
    const auto layer = std::make_shared<const rdf::Layer>(
        std::move(graphs), std::vector<rdf::Triple>(), std::vector<rdf::Clash>());
    Dataset dataset{rdf::View(dictionary_).With(layer), {}};
    std::vector<std::string> names = test.graphs;
    for (const std::string& iri : from_clauses) {
      if (iri.starts_with(base_)) names.push_back(iri.substr(base_.size()));
    }
    std::map<std::string, bool> known;
    for (const std::string& name : names) {
      if (!known.emplace(name, true).second) continue;
      auto graph = Read({name});
      dataset.named.push_back({base_ + name, graph->triples, graph});
    }
    return dataset;
  }

 private:
  std::filesystem::path folder_;
  std::string base_;
  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  int count_ = 0;
};

std::vector<std::string> FromClauses(const std::string& text, const std::string& base) {
  std::vector<std::string> iris;
  for (std::size_t at = text.find("FROM"); at != std::string::npos;
       at = text.find("FROM", at + 4)) {
    const std::size_t begin = text.find('<', at);
    const std::size_t end = text.find('>', at);
    if (begin == std::string::npos || end == std::string::npos || begin > end) break;
    iris.push_back(base + text.substr(begin + 1, end - begin - 1));
  }
  return iris;
}

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
    Graphs graphs(folder, base);
    const Dataset dataset = graphs.Make(test, FromClauses(text, base));
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
  const std::string base = "https://w3c.github.io/rdf-tests/sparql/" + name + "/";
  Totals totals;
  for (const Case& test : Manifest(folder / "manifest.ttl", base).Cases()) {
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
