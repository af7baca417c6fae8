// Proofs: right by the tables, least by brute force, and quick where there is much to choose from.
#include "reasoner/owl/prover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/derivations.h"
#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/proof_checker.h"
#include "tests/reasoner/random_ontology.h"

namespace lares::owl {
namespace {

using lares::testing::Author;
using lares::testing::CheckProof;
using lares::testing::GraphOf;
using lares::testing::ToText;
using lares::testing::TripleOf;

rdf::View Over(const rdf::View& below, const std::string& text, const std::string& name) {
  return below.With(Materialise(below, {GraphOf(text, below.dictionary(), name)}));
}

rdf::View Closed(const std::string& text) {
  return Over(rdf::View(std::make_shared<rdf::Dictionary>()), text, "test");
}

std::vector<rdf::Triple> InferredOf(const rdf::View& view) {
  std::vector<rdf::Triple> inferred = view.Match({});
  std::erase_if(inferred, [&](const rdf::Triple& triple) { return view.IsAsserted(triple); });
  return inferred;
}

constexpr unsigned kUnreached = 1'000'000;

// The least cost of a proof of each triple, by trying all steps until nothing gets cheaper.
std::map<rdf::Triple, unsigned> LeastCosts(const rdf::View& view) {
  std::map<rdf::Triple, unsigned> costs;
  std::vector<std::pair<rdf::Triple, std::set<rdf::Triple>>> steps;
  Derivations derivations(view);
  for (const rdf::Triple& triple : view.Match({})) {
    costs[triple] = view.IsAsserted(triple) ? 0 : kUnreached;
    derivations.ForEach(
        {triple.subject, triple.predicate, triple.object}, {}, [&](const Step& step) {
          steps.emplace_back(triple,
                             std::set<rdf::Triple>(step.premises.begin(), step.premises.end()));
          return true;
        });
  }
  for (bool again = true; again;) {
    again = false;
    for (const auto& [conclusion, premises] : steps) {
      unsigned cost = 1;
      for (const rdf::Triple& premise : premises) {
        const auto known = costs.find(premise);  // what is not stored costs what others know
        cost += known == costs.end() ? kUnreached : known->second;
      }
      if (cost >= std::min(kUnreached, costs[conclusion])) continue;
      costs[conclusion] = cost;
      again = true;
    }
  }
  return costs;
}

// Each inferred triple has a proof that the checker accepts, and none is cheaper.
void ExpectProofs(const std::string& text) {
  SCOPED_TRACE(text);
  const rdf::View view = Closed(text);
  const auto least = LeastCosts(view);
  Prover prover(view);
  for (const rdf::Triple& triple : InferredOf(view)) {
    SCOPED_TRACE(ToText(triple, view.dictionary()));
    std::optional<Proof> proof;
    ProofOptions options;
    options.max_work = 50'000;
    try {
      proof = prover.Why(triple, options);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
      continue;
    }
    ASSERT_TRUE(proof.has_value());
    EXPECT_EQ(proof->conclusion().triple, triple);
    EXPECT_EQ(CheckProof(*proof, view), "");
    EXPECT_LE(proof->steps(), proof->cost);
    if (least.at(triple) >= kUnreached) continue;  // rests on what no view shows
    const auto tells_of_literal = [&](const ProofNode& node) {
      return view.dictionary().Kind(node.triple.subject) == rdf::TermKind::kLiteral;
    };
    if (std::none_of(proof->nodes.begin(), proof->nodes.end(), tells_of_literal)) {
      EXPECT_EQ(proof->cost, least.at(triple));
    } else {
      EXPECT_LE(proof->cost, least.at(triple));  // what no view shows may be a shorter way
    }
  }
}

TEST(ProverTest, EveryInferredTripleHasAProofThatTheCheckerAcceptsAndNoneIsCheaper) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Author author(seed);
    ExpectProofs(author.Text(6 + static_cast<int>(author.Below(20))));
  }
}

TEST(ProverTest, WhatRestsOnValuesHasProofsToo) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Author author(seed, true, true);
    ExpectProofs(author.Text(6 + static_cast<int>(author.Below(20))));
  }
}

void ExpectContradictionsHaveProofs(bool values) {
  int contradictions = 0;
  for (unsigned seed = 500; seed <= 600; ++seed) {
    Author author(seed, true, values);
    const std::string text = author.Text(18);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const rdf::View view = Closed(text);
    std::optional<Proof> proof;
    try {
      proof = Prover(view).WhyContradiction();
    } catch (const Error& error) {
      ADD_FAILURE() << view.layers()[0]->clashes()[0].rule << ": " << error.what();
      continue;
    }
    ASSERT_EQ(proof.has_value(), !view.layers()[0]->clashes().empty());
    if (!proof) continue;
    ++contradictions;
    ASSERT_TRUE(proof->conclusion().is_contradiction());
    EXPECT_EQ(CheckProof(*proof, view), "") << ToText(*proof, view);
  }
  EXPECT_GT(contradictions, 20);
}

TEST(ProverTest, ContradictionsHaveProofs) { ExpectContradictionsHaveProofs(false); }
TEST(ProverTest, ContradictionsOfValuesHaveProofs) { ExpectContradictionsHaveProofs(true); }

TEST(ProverTest, ProofsOverLayersNameTheDocumentsOfEach) {
  rdf::View view(std::make_shared<rdf::Dictionary>());
  view = Over(view, ":Cup rdfs:subClassOf :Container .", "catalogue");
  view = Over(view, ":cup1 a :Cup .", "environment");
  view = Over(view, ":cup1 a :Cup .", "recipe");
  const rdf::Triple goal = TripleOf(":cup1 a :Container", view.dictionary());
  const auto proof = Prover(view).Why(goal);
  ASSERT_TRUE(proof);
  EXPECT_EQ(CheckProof(*proof, view), "");
  EXPECT_EQ(proof->conclusion().rule, "cax-sco");
  ASSERT_EQ(proof->nodes.size(), 3U);
  EXPECT_EQ(proof->nodes[0].graphs, std::vector<std::string>{"catalogue"});
  EXPECT_EQ(proof->nodes[1].graphs, (std::vector<std::string>{"environment", "recipe"}));
}

TEST(ProverTest, WhatIsAssertedIsALeaf) {
  const rdf::View view = Closed(":x a :C . :x a :D . :D rdfs:subClassOf :C .");
  const auto proof = Prover(view).Why(TripleOf(":x a :C", view.dictionary()));
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->nodes.size(), 1U);
  EXPECT_EQ(proof->cost, 0U);
  EXPECT_EQ(CheckProof(*proof, view), "");
}

TEST(ProverTest, WhatDoesNotHoldHasNoProof) {
  const rdf::View view = Closed(":x a :C .");
  EXPECT_FALSE(Prover(view).Why(TripleOf(":x a :D", view.dictionary())));
  EXPECT_FALSE(Prover(view).WhyContradiction());
}

TEST(ProverTest, WhatIsTrueOfEverythingIsOneStep) {
  const rdf::View view = Closed(":x a :C . :C a owl:Class . :p a owl:ObjectProperty .");
  for (const char* triple :
       {":x owl:sameAs :x", ":C rdfs:subClassOf :C", ":C rdfs:subClassOf owl:Thing",
        "owl:Nothing rdfs:subClassOf :C", ":p rdfs:subPropertyOf :p"}) {
    const auto proof = Prover(view).Why(TripleOf(triple, view.dictionary()));
    ASSERT_TRUE(proof) << triple;
    EXPECT_EQ(CheckProof(*proof, view), "") << triple;
  }
}

std::set<std::string> RulesOf(const Proof& proof) {
  std::set<std::string> rules;
  for (const ProofNode& node : proof.nodes) {
    if (!node.is_asserted()) rules.insert(node.rule);
  }
  return rules;
}

void ExpectRules(const std::string& text, const std::string& goal,
                 const std::set<std::string>& rules) {
  const rdf::View view = Closed(text);
  const auto proof = Prover(view).Why(TripleOf(goal, view.dictionary()));
  ASSERT_TRUE(proof) << goal;
  EXPECT_EQ(CheckProof(*proof, view), "") << ToText(*proof, view);
  EXPECT_EQ(RulesOf(*proof), rules) << ToText(*proof, view);
}

TEST(ProverTest, WhatIsTheSameAsALiteralIsOfItsDatatypes) {
  ExpectRules(":i owl:sameAs 1 .", ":i a xsd:byte", {"eq-sym", "dt-type2", "eq-rep-s"});
  ExpectRules(":p a owl:FunctionalProperty . :x :p 1 , :i .", ":i a xsd:byte",
              {"prp-fp", "dt-type2", "eq-rep-s"});
}

TEST(ProverTest, WhatADatatypeIsPartOfIsSaidOfTheSameThing) {
  ExpectRules(":i owl:sameAs 1 . xsd:byte rdfs:subClassOf :C .", ":i a :C",
              {"eq-sym", "dt-type2", "eq-rep-s", "cax-sco"});
  ExpectRules(
      ":R owl:onProperty :p ; owl:someValuesFrom :C . xsd:byte rdfs:subClassOf :C . :x :p 1 .",
      ":x a :R", {"dt-type2", "cax-sco", "cls-svf1"});
}

TEST(ProverTest, APropertyOfALiteralIsAPremise) {
  ExpectRules(":p a owl:SymmetricProperty ; rdfs:range :C . :x :p 1 .", ":x a :C",
              {"prp-symp", "prp-rng"});
  ExpectRules(":p owl:inverseOf :q . :x :p 1 . :y :p 1 . :q a owl:FunctionalProperty .",
              ":x owl:sameAs :y", {"prp-inv1", "prp-fp"});
}

TEST(ProverTest, LiteralsOfOneValueAreTheSame) {
  const std::string one = "\"1\"^^xsd:int", other = "\"01\"^^xsd:integer";
  ExpectRules(":p a owl:InverseFunctionalProperty . :x :p " + one + " . :y :p " + other + " .",
              ":x owl:sameAs :y", {"dt-eq", "eq-rep-o", "prp-ifp"});
  ExpectRules(":C owl:hasKey ( :p ) . :x a :C ; :p " + one + " . :y a :C ; :p " + other + " .",
              ":x owl:sameAs :y", {"dt-eq", "eq-rep-o", "prp-key"});
  ExpectRules(":i owl:sameAs " + one + " . :j owl:sameAs " + other + " .", ":i owl:sameAs :j",
              {"dt-eq", "eq-sym", "eq-trans"});
  ExpectRules(":x :p " + one + " . :y :p " + other + " .", ":x :p " + other, {"dt-eq", "eq-rep-o"});
}

TEST(ProverTest, ALiteralMayBeWhatIsAskedAbout) {
  const rdf::View view = Closed(
      "xsd:byte rdfs:subClassOf :C . :D rdfs:subClassOf :E . :x a :D ; "
      ":p 1 . :p rdfs:range :D .");
  const rdf::TermId one = TripleOf(":x :p 1", view.dictionary()).object;
  for (const char* type : {"C", "D", "E"}) {
    rdf::Triple goal = TripleOf(std::string(":x a :") + type, view.dictionary());
    goal.subject = one;
    const auto proof = Prover(view).Why(goal);
    ASSERT_TRUE(proof) << type;
    EXPECT_EQ(CheckProof(*proof, view), "") << ToText(*proof, view);
    EXPECT_GE(proof->steps(), 1U);
  }
}

// Down to what documents say.
void ExpectContradiction(const std::string& text, const std::set<std::string>& rules) {
  const rdf::View view = Closed(text);
  const auto proof = Prover(view).WhyContradiction();
  ASSERT_TRUE(proof) << text;
  EXPECT_TRUE(proof->conclusion().is_contradiction());
  EXPECT_EQ(CheckProof(*proof, view), "") << ToText(*proof, view);
  EXPECT_EQ(RulesOf(*proof), rules) << ToText(*proof, view);
}

TEST(ProverTest, TwoThingsThatAreTheSameAndDifferentAreAContradiction) {
  ExpectContradiction(":x owl:sameAs :y ; owl:differentFrom :y .", {"eq-diff1"});
  ExpectContradiction(":x owl:sameAs :y . :y owl:differentFrom :x .", {"eq-sym", "eq-diff1"});
  ExpectContradiction(":p a owl:FunctionalProperty . :x :p :y , :z . :y owl:differentFrom :z .",
                      {"prp-fp", "eq-diff1"});
}

TEST(ProverTest, TwoValuesThatAreTheSameAreAContradiction) {
  ExpectContradiction(":p a owl:FunctionalProperty . :x :p 1 , 2 .",
                      {"prp-fp", "dt-diff", "eq-diff1"});
  ExpectContradiction(":x owl:sameAs 1 , \"text\" .", {"eq-rep-s", "dt-diff", "eq-diff1"});
}

TEST(ProverTest, MembersOfAllDifferentThatAreTheSameAreAContradiction) {
  for (const auto& [members, rule] :
       {std::pair("owl:members", "eq-diff2"), std::pair("owl:distinctMembers", "eq-diff3")}) {
    const std::string all = std::string("_:d a owl:AllDifferent ; ") + members + " ( :a :b :c ) . ";
    ExpectContradiction(all + ":a owl:sameAs :c .", {rule});
    ExpectContradiction(all + ":p a owl:FunctionalProperty . :x :p :b , :c .", {"prp-fp", rule});
    // With x in the place of c the list says that a and x are different.
    ExpectContradiction(all + ":a owl:sameAs :x . :c owl:sameAs :x .", {"eq-rep-o", rule});
  }
}

TEST(ProverTest, ALiteralOutsideADatatypeIsAContradiction) {
  ExpectContradiction(":p rdfs:range xsd:integer . :x :p \"text\" .", {"prp-rng", "dt-not-type"});
  ExpectContradiction(":p rdfs:range xsd:byte . :x :p 300 .", {"prp-rng", "dt-not-type"});
  ExpectContradiction(":x a xsd:byte ; owl:sameAs 300 .", {"eq-rep-s", "dt-not-type"});
  ExpectContradiction(":p rdfs:range xsd:integer . :x :p \"x\"^^xsd:integer .",
                      {"prp-rng", "dt-not-type"});
}

TEST(ProverTest, AContradictionMayBeOfALiteral) {
  ExpectContradiction(":C owl:disjointWith :D . :p rdfs:range :C , :D . :x :p 1 .",
                      {"prp-rng", "cax-dw"});
  ExpectContradiction(
      "_:n owl:sourceIndividual :x ; owl:assertionProperty :p ; owl:targetValue "
      "\"01\"^^xsd:integer . :x :p 1 .",
      {"dt-eq", "eq-rep-o", "prp-npa2"});
}

std::string Chain(const std::string& property, int links) {
  std::string text;
  for (int i = 0; i < links; ++i) {
    text += ":x" + std::to_string(i) + " " + property + " :x" + std::to_string(i + 1) + " .\n";
  }
  return text;
}

void ExpectCost(const rdf::View& view, const std::string& goal, unsigned cost) {
  const auto proof = Prover(view).Why(TripleOf(goal, view.dictionary()));
  ASSERT_TRUE(proof) << goal;
  EXPECT_EQ(CheckProof(*proof, view), "") << goal;
  EXPECT_EQ(proof->cost, cost) << goal;
}

TEST(ProverTest, AChainOfFiveHundredLinks) {
  ExpectCost(Closed(":p a owl:TransitiveProperty .\n" + Chain(":p", 500)), ":x0 :p :x500", 499);
}

TEST(ProverTest, AChainOfFiveHundredLinksOfASubproperty) {
  ExpectCost(
      Closed(":p a owl:TransitiveProperty . :q rdfs:subPropertyOf :p .\n" + Chain(":q", 500)),
      ":x0 :p :x500", 999);
}

TEST(ProverTest, AChainOfThreeHundredClasses) {
  ExpectCost(Closed(":i a :x0 .\n" + Chain("rdfs:subClassOf", 300)), ":i a :x300", 300);
}

TEST(ProverTest, AThousandNamesOfOneThing) {
  std::string star, row = Chain("owl:sameAs", 200);
  for (int i = 0; i < 300; ++i) star += ":hub owl:sameAs :y" + std::to_string(i) + " .\n";
  ExpectCost(Closed(star), ":y7 owl:sameAs :y9", 1);
  ExpectCost(Closed(row), ":x0 owl:sameAs :x200", 199);
  ExpectCost(Closed(row), ":x200 owl:sameAs :x0", 200);
  ExpectCost(Closed(row + ":x0 a :C ."), ":x200 a :C", 200);
}

TEST(ProverTest, ShowsSharedPartsOnce) {
  const rdf::View view = Closed(
      ":x :p :y . :q owl:inverseOf :p . :r rdfs:subPropertyOf :s . :y :r :z . "
      ":s owl:propertyChainAxiom ( :q :p ) . :p owl:equivalentProperty :t . "
      ":u owl:propertyChainAxiom ( :t :q :t :q ) .");
  const auto proof = Prover(view).Why(TripleOf(":x :u :x", view.dictionary()));
  ASSERT_TRUE(proof);
  EXPECT_EQ(CheckProof(*proof, view), "");
  EXPECT_EQ(proof->cost, 3U);
  EXPECT_EQ(proof->steps(), 3U);
}

TEST(ProverTest, GivesUpAfterTheWorkItIsAllowed) {
  const rdf::View view = Closed(":p a owl:TransitiveProperty .\n" + Chain(":p", 100));
  ProofOptions options;
  options.max_work = 3;
  Prover prover(view);
  const rdf::Triple goal = TripleOf(":x200 a :y", view.dictionary());
  EXPECT_FALSE(prover.Why(goal, options));
  const rdf::View other = Closed(
      ":x :p :y . :p rdfs:domain :A . :A rdfs:subClassOf :B . :B rdfs:subClassOf :C . "
      ":z :p :y . :A rdfs:subClassOf :D . :D rdfs:subClassOf :C .");
  try {
    Prover(other).Why(TripleOf(":x a :C", other.dictionary()), options);
    FAIL() << "no limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kTooLarge);
  }
}

// Each way to spoil a proof is noticed.
TEST(ProofCheckerTest, RefusesWhatIsSpoiled) {
  const rdf::View view =
      Closed(":x :p :y . :p rdfs:domain :A . :A rdfs:subClassOf :B . :z a :A . :q rdfs:range :A .");
  const auto good = Prover(view).Why(TripleOf(":x a :B", view.dictionary()));
  ASSERT_TRUE(good);
  ASSERT_EQ(CheckProof(*good, view), "");
  const std::vector<std::function<void(Proof&)>> spoilings = {
      [](Proof& p) { p.nodes.back().rule = "cax-eqc1"; },
      [](Proof& p) { p.nodes.back().rule = "no-such"; },
      [](Proof& p) { p.nodes.back().table = 9; },
      [](Proof& p) { p.nodes.back().premises.pop_back(); },
      [](Proof& p) { p.nodes.back().premises.push_back(0); },
      [](Proof& p) { p.nodes.back().premises[0] = p.nodes.size() - 1; },
      [](Proof& p) { p.nodes.back().graphs = {"test"}; },
      [](Proof& p) { p.nodes.front().graphs = {"other"}; },
      [](Proof& p) { p.nodes.front().graphs.clear(); },
      [](Proof& p) { p.nodes.back().rule.clear(); },
      [](Proof& p) { p.nodes.push_back(p.nodes.front()); },
      [](Proof& p) { p.nodes.back().premises.clear(); },
      [&](Proof& p) { p.nodes.back().triple = TripleOf(":z a :B", view.dictionary()); },
      [&](Proof& p) { p.nodes.front().triple = TripleOf(":q rdfs:range :A", view.dictionary()); },
      [](Proof& p) { p.nodes.clear(); },
  };
  for (std::size_t i = 0; i < spoilings.size(); ++i) {
    Proof spoiled = *good;
    spoilings[i](spoiled);
    EXPECT_NE(CheckProof(spoiled, view), "") << "spoiling " << i;
  }
}

}  // namespace
}  // namespace lares::owl
