// What C++ computes from a map is a graph of its own, and goes with the map.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using ::testing::ElementsAre;

// A thing of `kind` at x, y, z with its extent.
std::string Thing(const std::string& name, const std::string& kind, double x, double z,
                  double depth, double height) {
  const std::string pose = ":pose_" + name;
  std::string text = ":" + name + " a lares:" + kind + " ; lares:describedInMap :map ; " +
                     "lares:depthOfObject " + std::to_string(depth) + " ; lares:widthOfObject " +
                     std::to_string(depth) + " ; lares:heightOfObject " + std::to_string(height) +
                     " .\n:seen_" + name +
                     " a lares:SemanticMapPerception ; lares:objectActedOn :" + name +
                     " ; lares:eventOccursAt " + pose + " .\n" + pose + " a lares:RotationMatrix3D";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      double value = row == column ? 1 : 0;
      if (column == 3 && row == 0) value = x;
      if (column == 3 && row == 2) value = z;
      text +=
          " ; lares:m" + std::to_string(row) + std::to_string(column) + " " + std::to_string(value);
    }
  }
  return text + " .\n";
}

class DerivedTest : public KnowledgeFixture {
 protected:
  std::string Map(double cup_x) {
    return std::string(kPrefixes) + ":map a lares:SemanticEnvironmentMap .\n" +
           Thing("table", "Table", 0, 0.4, 1, 0.8) + Thing("cup", "Cup", cup_x, 0.85, 0.1, 0.1);
  }
  rdf::Triple CupOnTable(const rdf::View& view) {
    rdf::Dictionary& terms = view.dictionary();
    return {terms.InternIri("http://example.org/test#cup"),
            terms.InternIri("https://w3id.org/lares#on"),
            terms.InternIri("http://example.org/test#table")};
  }
};

TEST_F(DerivedTest, WhatStandsOnWhatFollowsFromPosesAndSaysWhereItComesFrom) {
  PutMap("flat", Map(0.2));
  const rdf::View view = knowledge_->ViewFor({"", "", "flat", 0});
  EXPECT_THAT(view.GraphsOf(CupOnTable(view)), ElementsAre("derived:environment:flat"));
  rdf::Dictionary& terms = view.dictionary();
  EXPECT_TRUE(
      view.Contains({terms.InternIri("https://w3id.org/lares/documents/derived/environment/flat"),
                     terms.InternIri("http://www.w3.org/ns/prov#wasDerivedFrom"),
                     terms.InternIri("https://w3id.org/lares/documents/environment/flat")}));
  rdf::Triple supports = CupOnTable(view);
  std::swap(supports.subject, supports.object);
  supports.predicate = terms.InternIri("https://w3id.org/lares#supports");
  EXPECT_TRUE(view.Contains(supports)) << "rules go on from what was computed";
}

TEST_F(DerivedTest, ItStaysInItsEnvironmentAndItsVersion) {
  PutMap("flat", Map(0.2));
  PutMap("flat", Map(5));
  PutMap("other", Map(5));
  const auto holds = [&](const std::string& environment, int version) {
    const rdf::View view = knowledge_->ViewFor({"", "", environment, version});
    return view.Contains(CupOnTable(view));
  };
  EXPECT_TRUE(holds("flat", 1));
  EXPECT_FALSE(holds("flat", 2)) << "the cup was moved";
  EXPECT_FALSE(holds("other", 0));
  EXPECT_FALSE(knowledge_->Catalogue().Contains(CupOnTable(knowledge_->Catalogue())));
}

TEST_F(DerivedTest, WithoutItsSourceItIsGone) {
  PutMap("flat", Map(0.2));
  store::NewVersion version;
  version.environment = "flat";
  version.layers.push_back({"notes", "notes.txt", "text/plain", PutBlob("x"), {}});
  version.removed_layers = {"semantic"};
  knowledge_->PutVersion(version);
  const rdf::View view = knowledge_->ViewFor({"", "", "flat", 0});
  EXPECT_FALSE(view.Contains(CupOnTable(view)));
  EXPECT_EQ(view.layers().size(), knowledge_->Catalogue().layers().size());
}

TEST_F(DerivedTest, MapObjectsAreThoseOfTheDocument) {
  PutMap("flat", Map(0.2));
  EXPECT_EQ(knowledge_->MapObjects("flat", 1).size(), 2U);
}

}  // namespace
}  // namespace lares::testing
