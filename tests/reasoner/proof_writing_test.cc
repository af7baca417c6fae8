// Proofs as people and programs read them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "reasoner/owl/materialise.h"
#include "reasoner/owl/prover.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TripleOf;

class ProofWritingTest : public ::testing::Test {
 protected:
  ProofWritingTest() {
    Add(":Container owl:intersectionOf ( :Thing _:r ) . _:r owl:onProperty :hasCavity . "
        "_:r owl:someValuesFrom :Cavity . :Bowl rdfs:subClassOf :Cavity . "
        ":Cup rdfs:subClassOf :Thing . :Cup rdfs:label \"Cup <of & \\\"tea\\\">\"@en .",
        "objects");
    Add(":cup1 a :Cup . :cup1 :hasCavity :hollow . :hollow a :Bowl .", "room");
    proof_ = *Prover(view_).Why(TripleOf(":cup1 a :Container", view_.dictionary()));
  }
  void Add(std::string text, const std::string& name) {
    for (std::size_t at = 0; (at = text.find("\\\"", at)) != std::string::npos;) {
      text.replace(at, 2, "'");
    }
    view_ = view_.With(Materialise(view_, {GraphOf(text, view_.dictionary(), name)}));
  }

  rdf::View view_{std::make_shared<rdf::Dictionary>()};
  Proof proof_;
};

TEST_F(ProofWritingTest, TextNumbersTheStepsFromTheConclusionDown) {
  const std::string text = ToText(proof_, view_);
  EXPECT_EQ(text.rfind("1. cup1 a Container — by cls-int1 (table 6) from ", 0), 0U) << text;
  EXPECT_NE(text.find("cup1 a (hasCavity some Cavity) — by cls-svf1"), std::string::npos) << text;
  EXPECT_NE(text.find("hollow a Bowl — stated in room\n"), std::string::npos) << text;
  EXPECT_NE(text.find("subClassOf Thing — stated in objects\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("first"), std::string::npos) << "cells of lists are noise\n" << text;
}

TEST_F(ProofWritingTest, JsonHasEveryPremise) {
  const auto json = nlohmann::json::parse(ToJson(proof_, view_));
  EXPECT_EQ(json["conclusion"], "cup1 a Container");
  EXPECT_EQ(json["steps"], proof_.steps());
  ASSERT_EQ(json["nodes"].size(), proof_.nodes.size());
  const auto& last = json["nodes"].back();
  EXPECT_EQ(last["rule"], "cls-int1");
  EXPECT_EQ(last["table"], 6);
  EXPECT_EQ(last["triple"][0], "<http://example.org/cup1>");
  for (const auto& premise : last["premises"]) EXPECT_LT(premise, last["id"]);
}

TEST_F(ProofWritingTest, SvgShowsEachStepOnceAndEscapesNames) {
  const std::string svg = ToSvg(proof_, view_);
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_NE(svg.find("Cup &lt;of &amp; "), std::string::npos);
  EXPECT_EQ(svg.find("<of"), std::string::npos);
  EXPECT_NE(svg.find("cls-int1 · table 6"), std::string::npos);
  if (const char* path = std::getenv("LARES_PROOF_SVG")) std::ofstream(path) << svg;
}

TEST_F(ProofWritingTest, DotNamesEveryNode) {
  const std::string dot = ToDot(proof_, view_);
  for (std::size_t i = 0; i < proof_.nodes.size(); ++i) {
    EXPECT_NE(dot.find("n" + std::to_string(i) + " [label="), std::string::npos);
  }
}

}  // namespace
}  // namespace lares::owl
