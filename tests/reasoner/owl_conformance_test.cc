// The OWL 2 RL cases of the OWL 2 RDF-Based Semantics test collection (Schneider & Mainzer, 2009).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ontology/rdf/reader.h"
#include "reasoner/owl/entailment.h"
#include "reasoner/owl/materialise.h"
#include "tests/lares_data.h"
#include "tests/ontology/test_graph.h"
#include "tests/zip_entries.h"

namespace lares::owl {
namespace {

struct Case {
  std::string name;
  bool is_inconsistency = false;
  std::string premise;     // Turtle, or RDF/XML where there is none
  std::string conclusion;  // empty for an inconsistency
  rdf::Format format = rdf::Format::kTurtle;
};

struct Outcome {
  bool is_right = false;
  std::string why;
  std::set<std::string> used;
  double milliseconds = 0;
};

std::vector<Case> CasesOf(const std::map<std::string, std::string>& files) {
  std::vector<Case> cases;
  const std::string kEnd = ".metadata.properties";
  for (const auto& [path, metadata] : files) {
    if (!path.ends_with(kEnd)) continue;
    const std::string stem = path.substr(0, path.size() - kEnd.size());
    Case each;
    each.name = stem.substr(stem.rfind('/') + 1);
    each.is_inconsistency = metadata.find("INCONSISTENCY") != std::string::npos;
    const std::string role = each.is_inconsistency ? ".graph" : ".premisegraph";
    const bool has_turtle = files.contains(stem + role + ".ttl");
    each.format = has_turtle ? rdf::Format::kTurtle : rdf::Format::kRdfXml;
    const std::string ending = has_turtle ? ".ttl" : ".xml";
    each.premise = files.at(stem + role + ending);
    if (!each.is_inconsistency) each.conclusion = files.at(stem + ".conclusiongraph" + ending);
    cases.push_back(std::move(each));
  }
  return cases;
}

rdf::Graph GraphOf(const Case& each, const std::string& text, const std::string& name,
                   rdf::Dictionary& dictionary) {
  rdf::ReadOptions options;
  options.source = each.name;
  options.base_iri = "http://example.org/base";
  return rdf::MakeGraph(rdf::ReadRdf(text, each.format, options), name, rdf::AliasTable{},
                        dictionary);
}

Outcome Decide(const Case& each) {
  const auto start = std::chrono::steady_clock::now();
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::View empty(dictionary);
  const rdf::View view =
      empty.With(Materialise(empty, {GraphOf(each, each.premise, "premise", *dictionary)}));
  Outcome outcome;
  if (each.is_inconsistency) {
    outcome.is_right = view.layers().back()->clash_count() > 0;
    outcome.why = "no contradiction was found";
  } else {
    const auto answer = Entails(view, GraphOf(each, each.conclusion, "conclusion", *dictionary));
    outcome.is_right = answer.follows && view.layers().back()->clash_count() == 0;
    outcome.used = answer.used;
    outcome.why = answer.missing
                      ? "does not follow: " + testing::ToText(*answer.missing, *dictionary)
                      : "is said to be a contradiction";
  }
  outcome.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

// Every case is right; the run prints which needed more than the triples of the closure.
TEST(OwlConformanceTest, AllCasesWithinOwl2RlAreRight) {
  LARES_REQUIRE_DATA(archive, "conformance/owl2-rdfbased/testsuite-owl2-rdfbased.zip");
  const auto cases =
      CasesOf(testing::ReadArchive(archive, "testsuite-owl2-rdfbased/subsuites/owl2rl/"));
  ASSERT_EQ(cases.size(), 273U);
  std::vector<double> times;
  std::map<std::string, std::vector<std::string>> needing;
  std::size_t right = 0;
  for (const Case& each : cases) {
    const Outcome outcome = Decide(each);
    EXPECT_TRUE(outcome.is_right) << each.name << ": " << outcome.why;
    right += outcome.is_right ? 1 : 0;
    times.push_back(outcome.milliseconds);
    for (const std::string& used : outcome.used) needing[used].push_back(each.name);
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  std::printf("OWL 2 RL: %zu of %zu cases right, median %.3f ms a case\n", right, cases.size(),
              times[times.size() / 2]);
  for (const auto& [what, names] : needing) {
    std::printf("  %s is needed by %zu:", what.c_str(), names.size());
    for (const std::string& name : names) std::printf(" %s", name.c_str());
    std::printf("\n");
  }
}

}  // namespace
}  // namespace lares::owl
