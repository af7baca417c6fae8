// The axioms by which robot descriptions work: parts, chains and compositions.
#include <gtest/gtest.h>

#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TermOf;
using lares::testing::TripleOf;

constexpr char kAxioms[] =
    "lares:subComponent owl:inverseOf lares:superComponent . "
    "lares:superComponent a owl:TransitiveProperty . "
    "lares:predecessorInKinematicChain a owl:TransitiveProperty ; "
    "  rdfs:subPropertyOf lares:superComponent ; owl:inverseOf lares:successorInKinematicChain . "
    "lares:successorInKinematicChain a owl:TransitiveProperty ; "
    "  rdfs:subPropertyOf lares:subComponent . "
    "lares:succeedingLink a owl:TransitiveProperty ; "
    "  rdfs:subPropertyOf lares:successorInKinematicChain . "
    "lares:succeedingJoint a owl:TransitiveProperty ; "
    "  rdfs:subPropertyOf lares:successorInKinematicChain . "
    "lares:precedingLink a owl:TransitiveProperty ; "
    "  rdfs:subPropertyOf lares:predecessorInKinematicChain . "
    "lares:baseLinkOfComposition rdfs:subPropertyOf lares:precedingLink . "
    "lares:endLinkOfComposition rdfs:subPropertyOf lares:succeedingLink . "
    "lares:dependsOn a owl:TransitiveProperty . "
    "lares:dependsOnComponent rdfs:subPropertyOf lares:dependsOn . ";

class SrdlTest : public ::testing::Test {
 protected:
  rdf::View Robot(const std::string& text) {
    const rdf::View catalogue =
        rdf::View(dictionary_)
            .With(Materialise(rdf::View(dictionary_), {GraphOf(kAxioms, *dictionary_, "srdl")}));
    return catalogue.With(Materialise(catalogue, {GraphOf(text, *dictionary_, "robot")}));
  }
  bool IsPart(const rdf::View& view, const std::string& whole, const std::string& part) {
    return view.Contains(TripleOf(whole + " lares:subComponent " + part, *dictionary_));
  }

  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
};

TEST_F(SrdlTest, PartsOfPartsAreParts) {
  const rdf::View view = Robot(
      ":robot lares:subComponent :tower . :tower lares:subComponent :head . "
      ":camera lares:superComponent :head .");
  EXPECT_TRUE(IsPart(view, ":robot", ":camera"));
  EXPECT_FALSE(IsPart(view, ":camera", ":robot"));
}

TEST_F(SrdlTest, TheKinematicChainIsPartOfTheRobot) {
  const rdf::View view = Robot(
      ":robot lares:succeedingLink :base_link . :base_link lares:succeedingJoint :joint . "
      ":joint lares:succeedingLink :camera_link .");
  EXPECT_TRUE(IsPart(view, ":robot", ":camera_link"));
  EXPECT_FALSE(view.Contains(TripleOf(":robot lares:succeedingLink :camera_link", *dictionary_)));
}

TEST_F(SrdlTest, AnArmThatHangsOnTheBaseLinkIsPartOfTheRobot) {
  const rdf::View view = Robot(
      ":robot lares:succeedingLink :base_link . "
      ":arm lares:baseLinkOfComposition :base_link ; lares:endLinkOfComposition :grip . "
      ":spare lares:baseLinkOfComposition :elsewhere .");
  EXPECT_TRUE(IsPart(view, ":robot", ":arm"));
  EXPECT_TRUE(IsPart(view, ":arm", ":grip"));
  EXPECT_TRUE(IsPart(view, ":robot", ":grip"));
  EXPECT_FALSE(IsPart(view, ":robot", ":spare"));
}

TEST_F(SrdlTest, PartsInACircleAreNoContradiction) {
  const rdf::View view = Robot(
      ":robot lares:succeedingLink :base_link ; lares:baseLinkOfComposition :base_link . "
      ":base_link lares:succeedingJoint :joint .");
  EXPECT_TRUE(IsPart(view, ":base_link", ":robot"));
  EXPECT_TRUE(IsPart(view, ":robot", ":robot"));
  EXPECT_FALSE(IsPart(view, ":joint", ":robot"));
  for (const auto& layer : view.layers()) EXPECT_EQ(layer->clash_count(), 0U);
}

TEST_F(SrdlTest, ALongChainClosesBothWays) {
  std::string text;
  constexpr int kLinks = 120;
  for (int i = 0; i < kLinks; ++i) {
    const std::string link = ":link" + std::to_string(i);
    text += link + " lares:succeedingJoint :joint" + std::to_string(i) + " . :joint" +
            std::to_string(i) + " lares:succeedingLink :link" + std::to_string(i + 1) + " . ";
  }
  const rdf::View view = Robot(text);
  const std::size_t parts = 2 * kLinks + 1;
  for (const char* property : {"lares:subComponent", "lares:predecessorInKinematicChain"}) {
    EXPECT_EQ(view.Estimate({{}, TermOf(property, *dictionary_), {}}), parts * (parts - 1) / 2);
  }
}

TEST_F(SrdlTest, NeedsOfNeedsAreNeeds) {
  const rdf::View view = Robot(
      ":grasp lares:dependsOn :gripper_motion . :gripper_motion lares:dependsOnComponent :hand .");
  EXPECT_TRUE(view.Contains(TripleOf(":grasp lares:dependsOn :hand", *dictionary_)));
}

}  // namespace
}  // namespace lares::owl
