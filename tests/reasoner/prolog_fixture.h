// Views and a pool for tests of the Prolog edge.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "reasoner/prolog/runtime.h"

namespace lares::prolog::testing {

inline rdf::Term Named(const std::string& local) { return rdf::Term::Iri("http://x/" + local); }

struct Fact {
  rdf::Term subject, predicate, object;
};

inline rdf::Triple ToTriple(rdf::Dictionary& dictionary, const Fact& fact) {
  return {dictionary.Intern(fact.subject.view()), dictionary.Intern(fact.predicate.view()),
          dictionary.Intern(fact.object.view())};
}

inline std::vector<rdf::Triple> ToTriples(rdf::Dictionary& dictionary,
                                          const std::vector<Fact>& facts) {
  std::vector<rdf::Triple> triples;
  for (const Fact& fact : facts) triples.push_back(ToTriple(dictionary, fact));
  std::sort(triples.begin(), triples.end());
  return triples;
}

// `view` and one layer more: a graph of that name, and what follows from it.
inline rdf::View With(const rdf::View& view, const std::string& name,
                      const std::vector<Fact>& asserted, const std::vector<Fact>& inferred = {}) {
  rdf::Dictionary& dictionary = view.dictionary();
  std::vector<rdf::Graph> graphs;
  graphs.push_back({name, ToTriples(dictionary, asserted), {}});
  return view.With(std::make_shared<const rdf::Layer>(
      std::move(graphs), ToTriples(dictionary, inferred), std::vector<rdf::Clash>{}));
}

inline rdf::View EmptyView() { return rdf::View(std::make_shared<rdf::Dictionary>()); }

// `count` triples n0 p m0, n1 p m1, ….
inline rdf::View Numbered(int count, const rdf::View& below = EmptyView()) {
  std::vector<Fact> facts;
  for (int i = 0; i < count; ++i) {
    facts.push_back({Named("n" + std::to_string(i)), Named("p"), Named("m" + std::to_string(i))});
  }
  return With(below, "numbered", facts);
}

inline Value A(const std::string& text) { return {Atom{text}}; }
inline Value S(const std::string& text) { return {String{text}}; }
inline Value I(std::int64_t number) { return {number}; }
inline Value C(const std::string& name, List arguments) {
  return {Compound{name, std::move(arguments)}};
}
inline Value Iri(const std::string& local) { return A("http://x/" + local); }

// Goals of tests/reasoner/prolog_test_rules.pl.
class PrologTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    LoadRuleFile(LARES_SOURCE_DIR "/tests/reasoner/prolog_test_rules.pl");
  }

  std::optional<Value> Once(const std::string& predicate, const std::vector<Value>& inputs,
                            const rdf::View& view = EmptyView(), const Limits& limits = {}) {
    return pool_.Once(view, "prolog_test_rules", predicate, inputs, limits);
  }
  std::vector<Value> All(const std::string& predicate, const std::vector<Value>& inputs,
                         const rdf::View& view = EmptyView(), const Limits& limits = {}) {
    return pool_.All(view, "prolog_test_rules", predicate, inputs, limits);
  }
  // The Error of a goal that must fail with one; kInternal "no error" when it does not.
  Error ErrorOf(const std::string& predicate, const std::vector<Value>& inputs,
                const rdf::View& view = EmptyView(), const Limits& limits = {}) {
    try {
      All(predicate, inputs, view, limits);
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << predicate << " raised no error";
    return Error(Code::kInternal, "no error");
  }

  EnginePool pool_{Options{.engines = 2, .stack_limit_bytes = 16u << 20}};
};

}  // namespace lares::prolog::testing
