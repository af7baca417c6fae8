// One-step derivations against the engine's own and against the naive closure.
#include "reasoner/owl/derivations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/on_demand.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/owl_naive.h"
#include "tests/reasoner/random_ontology.h"

namespace lares::owl {
namespace {

using lares::testing::Author;
using lares::testing::CloseNaively;
using lares::testing::GraphOf;
using lares::testing::ToText;
using lares::testing::TripleOf;

using Premise = std::set<rdf::Triple>;
using Found = std::set<std::pair<std::string, Premise>>;

rdf::View Closed(const std::string& text) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::Graph graph = GraphOf(text, *dictionary);
  return rdf::View(dictionary).With(Materialise(rdf::View(dictionary), {graph}));
}

rdf::View Unclosed(const std::string& text) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  std::vector<rdf::Graph> graphs = {GraphOf(text, *dictionary)};
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(std::move(graphs), rdf::Inference{}));
}

Derivations::Holds Computed(const rdf::View& view) {
  return [view](const rdf::Triple& triple) { return Holds(view, triple).has_value(); };
}

Found All(Derivations& derivations, const rdf::Triple& goal,
          const Derivations::Options& options = {}) {
  Found found;
  derivations.ForEach({goal.subject, goal.predicate, goal.object}, options, [&](const Step& step) {
    EXPECT_EQ(step.conclusion, goal);
    found.insert({step.rule.name, {step.premises.begin(), step.premises.end()}});
    return true;
  });
  return found;
}

TEST(DerivationsTest, WhatIsInferredHasStepsThatRestOnWhatHolds) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Author author(seed);
    const std::string text = author.Text(6 + static_cast<int>(author.Below(16)));
    const rdf::View view = Closed(text);
    Derivations derivations(view);
    Derivations computing(view, Computed(view));
    for (const rdf::Triple& triple : view.Match({})) {
      if (view.IsAsserted(triple) || triple.subject == triple.object) continue;
      const Found found = All(derivations, triple);
      EXPECT_FALSE(found.empty()) << "seed " << seed << ": " << ToText(triple, view.dictionary())
                                  << "\n"
                                  << text;
      for (const auto& [name, rests_on] : found) {
        for (const rdf::Triple& premise : rests_on) EXPECT_TRUE(view.Contains(premise));
        EXPECT_TRUE(CloseNaively(rests_on, view.dictionary()).triples.contains(triple))
            << "seed " << seed << ": " << name << " gave " << ToText(triple, view.dictionary());
      }
    }
  }
}

TEST(DerivationsTest, OpenGoalsConcludeNothingThatTheClosureLacks) {
  for (unsigned seed = 200; seed <= 260; ++seed) {
    Author author(seed);
    const std::string text = author.Text(14);
    const rdf::View view = Closed(text);
    Derivations derivations(view);
    std::set<rdf::TermId> predicates;
    for (const rdf::Triple& triple : view.Match({})) predicates.insert(triple.predicate);
    for (const rdf::TermId predicate : predicates) {
      derivations.ForEach({{}, predicate, {}}, {}, [&](const Step& step) {
        if (view.Contains(step.conclusion)) return true;
        // What is not stored is trivial, or has a literal where none may stand.
        const auto again =
            CloseNaively({step.premises.begin(), step.premises.end()}, view.dictionary());
        EXPECT_FALSE(again.triples.contains(step.conclusion))
            << "seed " << seed << ": " << ToText(step.conclusion, view.dictionary());
        return true;
      });
    }
  }
}

TEST(DerivationsTest, ContradictionsHaveTheRulesThatTheEngineReports) {
  for (unsigned seed = 300; seed <= 400; ++seed) {
    Author author(seed);
    const rdf::View view = Closed(author.Text(18));
    std::set<std::string> expected, found;
    bool of_values = false;  // what datatypes contradict is not in the rows
    const auto is_of_value = [&](const rdf::Triple& triple) {  // shown by no view
      return view.dictionary().Kind(triple.subject) == rdf::TermKind::kLiteral;
    };
    for (const rdf::Clash& clash : view.layers()[0]->clashes()) {
      of_values =
          of_values || std::any_of(clash.premises.begin(), clash.premises.end(), is_of_value);
      expected.insert(clash.rule);
      of_values = of_values || clash.rule.starts_with("dt-");
    }
    if (of_values) continue;
    Derivations derivations(view, Computed(view));
    derivations.ForEachClash({}, [&](const Step& step) {
      found.insert(step.rule.name);
      return true;
    });
    EXPECT_EQ(found, expected) << "seed " << seed;
  }
}

TEST(DerivationsTest, WorksOverAViewThatIsNotClosed) {
  const rdf::View view = Unclosed(":x :p :y . :p rdfs:domain :C . :C rdfs:subClassOf :D .");
  Derivations derivations(view);
  EXPECT_EQ(All(derivations, TripleOf(":x a :C", view.dictionary())).size(), 1U);
  EXPECT_TRUE(All(derivations, TripleOf(":x a :D", view.dictionary())).empty());
}

TEST(DerivationsTest, PremisesMayBeForbidden) {
  const rdf::View view =
      Closed(":x a :A . :x a :B . :A rdfs:subClassOf :C . :B rdfs:subClassOf :C .");
  Derivations derivations(view);
  const rdf::Triple goal = TripleOf(":x a :C", view.dictionary());
  EXPECT_EQ(All(derivations, goal).size(), 2U);
  Derivations::Options options;
  const rdf::Triple schema = TripleOf(":A rdfs:subClassOf :C", view.dictionary());
  options.usable = [&](const rdf::Triple& triple) { return triple != schema; };
  EXPECT_EQ(All(derivations, goal, options).size(), 1U);
  const rdf::Triple data = TripleOf(":x a :B", view.dictionary());
  options.usable = [&](const rdf::Triple& t) { return t != schema && t != data; };
  EXPECT_TRUE(All(derivations, goal, options).empty());
}

TEST(DerivationsTest, PremisesMayBeComputed) {
  const rdf::View view = Closed(":x :p :y . :R owl:someValuesFrom :Even . :R owl:onProperty :p .");
  const rdf::Triple even = TripleOf(":y a :Even", view.dictionary());
  Derivations derivations(view, [&](const rdf::Triple& triple) { return triple == even; });
  const Found found = All(derivations, TripleOf(":x a :R", view.dictionary()));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found.begin()->second.contains(even));
  Derivations without(view);
  EXPECT_TRUE(All(without, TripleOf(":x a :R", view.dictionary())).empty());
}

TEST(DerivationsTest, StopsWhenTheVisitorHasSeenEnough) {
  std::string text = ":p rdfs:range :C .\n";
  for (int i = 0; i < 500; ++i) text += ":x" + std::to_string(i) + " :p :hub .\n";
  const rdf::View view = Closed(text);
  Derivations derivations(view);
  const rdf::Triple goal = TripleOf(":hub a :C", view.dictionary());
  EXPECT_EQ(All(derivations, goal).size(), 500U);
  int visited = 0;
  EXPECT_FALSE(derivations.ForEach({goal.subject, goal.predicate, goal.object}, {},
                                   [&](const Step&) { return ++visited < 3; }));
  EXPECT_EQ(visited, 3);
}

TEST(DerivationsTest, StopsOnRequest) {
  std::string text = ":p a owl:TransitiveProperty .\n";
  for (int i = 0; i < 60; ++i) {
    text += ":x" + std::to_string(i) + " :p :x" + std::to_string((i + 1) % 60) + " .\n";
  }
  const rdf::View view = Closed(text);
  Derivations derivations(view);
  std::stop_source stop;
  stop.request_stop();
  Derivations::Options options;
  options.stop = stop.get_token();
  const rdf::Triple goal = TripleOf(":x1 :p :x7", view.dictionary());
  try {
    derivations.ForEach({{}, goal.predicate, {}}, options, [](const Step&) { return true; });
    FAIL() << "ran to the end";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kTimeout);
  }
}

}  // namespace
}  // namespace lares::owl
