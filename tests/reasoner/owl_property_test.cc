// The engine against a naive closure and against itself in layers, on random ontologies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/owl_naive.h"
#include "tests/reasoner/random_ontology.h"

namespace lares::owl {
namespace {

using lares::testing::Author;
using lares::testing::CloseNaively;
using lares::testing::ComparableTriples;
using lares::testing::GraphOf;
using lares::testing::NaiveClosure;
using lares::testing::ToText;

// Enough for a quick run; LARES_SEEDS asks for more.
unsigned Seeds() {
  const char* seeds = std::getenv("LARES_SEEDS");
  return seeds == nullptr ? 400 : static_cast<unsigned>(std::atoi(seeds));
}

Options KeepingAllClashes() {
  Options options;
  options.max_clashes = SIZE_MAX;
  return options;
}

std::set<std::string> ClashesOf(const rdf::View& view) {
  std::set<std::string> rules;
  for (const auto& layer : view.layers()) {
    for (const rdf::Clash& clash : layer->clashes()) rules.insert(clash.rule);
  }
  return rules;
}

// Once two numbers are one, which further contradictions are found is of no interest.
std::set<std::string> ComparableClashes(const std::set<std::string>& clashes) {
  return clashes.contains("eq-diff1") ? std::set<std::string>{"eq-diff1"} : clashes;
}

std::string Difference(const std::set<rdf::Triple>& found, const std::set<rdf::Triple>& expected,
                       const rdf::Dictionary& dictionary) {
  std::string text;
  for (const rdf::Triple& triple : expected) {
    if (!found.contains(triple)) text += "missing " + ToText(triple, dictionary) + "\n";
  }
  for (const rdf::Triple& triple : found) {
    if (!expected.contains(triple)) text += "wrong " + ToText(triple, dictionary) + "\n";
  }
  return text;
}

TEST(OwlPropertyTest, EngineFindsWhatTheNaiveClosureFinds) {
  for (unsigned seed = 1; seed <= Seeds(); ++seed) {
    Author author(seed, true, true);
    const std::string text = author.Text(6 + static_cast<int>(author.Below(20)));
    const auto dictionary = std::make_shared<rdf::Dictionary>();
    const rdf::Graph graph = GraphOf(text, *dictionary);
    const NaiveClosure naive =
        CloseNaively({graph.triples.begin(), graph.triples.end()}, *dictionary);
    const rdf::View view =
        rdf::View(dictionary)
            .With(Materialise(rdf::View(dictionary), {graph}, KeepingAllClashes()));
    ASSERT_EQ(Difference(ComparableTriples(view), naive.triples, *dictionary), "")
        << "seed " << seed << "\n"
        << text;
    ASSERT_EQ(ComparableClashes(ClashesOf(view)), ComparableClashes(naive.clashes))
        << "seed " << seed << "\n"
        << text;
    ASSERT_EQ(view.Match({}, rdf::Origin::kAsserted).size(), graph.triples.size());
  }
}

TEST(OwlPropertyTest, LayersHoldTogetherWhatOneLayerHolds) {
  for (unsigned seed = 1; seed <= Seeds(); ++seed) {
    Author author(1000 + seed, true, true);
    std::vector<std::string> texts(2 + author.Below(2));
    for (std::string& text : texts) text = author.Text(3 + static_cast<int>(author.Below(12)));
    const auto dictionary = std::make_shared<rdf::Dictionary>();
    std::vector<rdf::Graph> graphs;
    rdf::View layered(dictionary);
    std::string whole;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      graphs.push_back(GraphOf(texts[i], *dictionary, "g" + std::to_string(i)));
      layered = layered.With(Materialise(layered, {graphs.back()}, KeepingAllClashes()));
      whole += texts[i] + "---\n";
    }
    const rdf::View scratch =
        rdf::View(dictionary).With(Materialise(rdf::View(dictionary), graphs, KeepingAllClashes()));
    ASSERT_EQ(Difference(ComparableTriples(layered), ComparableTriples(scratch), *dictionary), "")
        << "seed " << seed << "\n"
        << whole;
    const auto answers = layered.Match({});
    std::set<rdf::Triple> once;
    for (const rdf::Triple& answer : answers) {
      EXPECT_TRUE(once.insert(answer).second) << ToText(answer, *dictionary) << "\n" << whole;
    }
    ASSERT_EQ(once.size(), answers.size()) << "answered twice";
    ASSERT_EQ(ComparableClashes(ClashesOf(layered)), ComparableClashes(ClashesOf(scratch)))
        << "seed " << seed << "\n"
        << whole;
    const auto asserted = [](const rdf::View& view) {
      const auto found = view.Match({}, rdf::Origin::kAsserted);
      return std::set<rdf::Triple>(found.begin(), found.end());
    };
    ASSERT_EQ(asserted(layered), asserted(scratch)) << "seed " << seed << "\n" << whole;
  }
}

}  // namespace
}  // namespace lares::owl
