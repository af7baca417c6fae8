// The engine against a naive closure and against itself in layers, on random ontologies.
#include <gtest/gtest.h>

#include <algorithm>
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
using lares::testing::GraphOf;
using lares::testing::NaiveClosure;
using lares::testing::ToText;

Options KeepingAllClashes() {
  Options options;
  options.max_clashes = SIZE_MAX;
  return options;
}

std::set<rdf::Triple> TriplesOf(const rdf::View& view) {
  const std::vector<rdf::Triple> all = view.Match({});
  return {all.begin(), all.end()};
}

std::set<std::string> ClashesOf(const rdf::View& view) {
  std::set<std::string> rules;
  for (const auto& layer : view.layers()) {
    for (const rdf::Clash& clash : layer->clashes()) rules.insert(clash.rule);
  }
  return rules;
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
  for (unsigned seed = 1; seed <= 150; ++seed) {
    Author author(seed);
    const std::string text = author.Text(6 + static_cast<int>(author.Below(20)));
    const auto dictionary = std::make_shared<rdf::Dictionary>();
    const rdf::Graph graph = GraphOf(text, *dictionary);
    const NaiveClosure naive =
        CloseNaively({graph.triples.begin(), graph.triples.end()}, *dictionary);
    const rdf::View view =
        rdf::View(dictionary)
            .With(Materialise(rdf::View(dictionary), {graph}, KeepingAllClashes()));
    ASSERT_EQ(Difference(TriplesOf(view), naive.triples, *dictionary), "")
        << "seed " << seed << "\n"
        << text;
    ASSERT_EQ(ClashesOf(view), naive.clashes) << "seed " << seed << "\n" << text;
    ASSERT_EQ(view.Match({}, rdf::Origin::kAsserted).size(), graph.triples.size());
  }
}

TEST(OwlPropertyTest, LayersHoldTogetherWhatOneLayerHolds) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    Author author(1000 + seed);
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
    ASSERT_EQ(Difference(TriplesOf(layered), TriplesOf(scratch), *dictionary), "")
        << "seed " << seed << "\n"
        << whole;
    ASSERT_EQ(layered.size(), scratch.size()) << "a triple is in two layers";
    ASSERT_EQ(ClashesOf(layered), ClashesOf(scratch)) << "seed " << seed << "\n" << whole;
    const auto asserted = [](const rdf::View& view) {
      const auto found = view.Match({}, rdf::Origin::kAsserted);
      return std::set<rdf::Triple>(found.begin(), found.end());
    };
    ASSERT_EQ(asserted(layered), asserted(scratch)) << "seed " << seed << "\n" << whole;
  }
}

// Each reported derivation rests on what was known before it, and its premises alone suffice.
TEST(OwlPropertyTest, EveryDerivationFollowsFromItsPremises) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Author author(5000 + seed);
    const auto dictionary = std::make_shared<rdf::Dictionary>();
    const rdf::Graph below = GraphOf(author.Text(8), *dictionary, "below");
    const rdf::Graph graph = GraphOf(author.Text(8), *dictionary, "above");
    const rdf::View base = rdf::View(dictionary).With(Materialise(rdf::View(dictionary), {below}));
    std::set<rdf::Triple> known = TriplesOf(base);
    known.insert(graph.triples.begin(), graph.triples.end());
    const auto held_below = static_cast<std::size_t>(
        std::count_if(graph.triples.begin(), graph.triples.end(),
                      [&](const rdf::Triple& triple) { return base.Contains(triple); }));
    std::set<rdf::Triple> conclusions;
    Options options;
    options.on_derivation = [&](const Derivation& derivation) {
      for (const rdf::Triple& premise : derivation.premises) {
        EXPECT_TRUE(known.contains(premise))
            << derivation.rule << " uses " << ToText(premise, *dictionary);
      }
      const std::set<rdf::Triple> premises(derivation.premises.begin(), derivation.premises.end());
      EXPECT_TRUE(CloseNaively(premises, *dictionary).triples.contains(derivation.conclusion))
          << derivation.rule << " gave " << ToText(derivation.conclusion, *dictionary);
      known.insert(derivation.conclusion);
      EXPECT_TRUE(conclusions.insert(derivation.conclusion).second) << "reported twice";
    };
    const auto layer = Materialise(base, {graph}, options);
    const rdf::View view = base.With(layer);
    ASSERT_EQ(Difference(TriplesOf(view), known, *dictionary), "") << "seed " << seed;
    const auto inferred = static_cast<std::size_t>(
        std::count_if(conclusions.begin(), conclusions.end(),
                      [&](const rdf::Triple& triple) { return !view.IsAsserted(triple); }));
    ASSERT_EQ(inferred + layer->asserted_size() - held_below, layer->size()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace lares::owl
