// Versions over the real knowledge: what a semantic map says decides what is found and merged.
#include "server/knowledge/versions.h"

#include <gmock/gmock.h>

#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using store::DocumentKind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string MapOf(const std::vector<std::string>& objects, double cup_x_m = 1) {
  std::string text = std::string(kPrefixes) + ":map a lares:SemanticEnvironmentMap .\n";
  for (const std::string& kind : objects) {
    const std::string name = ":" + kind + "1";
    text += name + " a lares:" + kind + " ; lares:describedInMap :map .\n" + ":seen" + kind +
            " a lares:SemanticMapPerception ; lares:objectActedOn " + name +
            " ; lares:eventOccursAt :pose" + kind + " ; lares:startTime :timepoint_1700000000 .\n" +
            ":pose" + kind +
            " a lares:RotationMatrix3D ; lares:m00 1.0 ; lares:m01 0.0 ; lares:m02 0.0 ; "
            "lares:m03 " +
            std::to_string(kind == "Cup" ? cup_x_m : 4.5) +
            " ; lares:m10 0.0 ; lares:m11 1.0 ; lares:m12 0.0 ; lares:m13 2.0 ; lares:m20 0.0 ; "
            "lares:m21 0.0 ; lares:m22 1.0 ; lares:m23 0.8 ; lares:m30 0.0 ; lares:m31 0.0 ; "
            "lares:m32 0.0 ; lares:m33 1.0 .\n";
  }
  return text;
}

class RealVersionsTest : public KnowledgeFixture {
 protected:
  int PutBranch(const std::string& bytes, int parent) {
    store::NewVersion version;
    version.environment = "flat";
    version.parent = parent;
    store::LayerInfo layer;
    layer.name = "semantic";
    layer.file_name = "map.ttl";
    layer.media_type = "text/turtle";
    layer.blob = PutBlob(bytes);
    version.layers = {layer};
    return knowledge_->PutVersion(version).version.number;
  }
  std::vector<std::string> Find(const std::function<void(server::EnvironmentQuery&)>& narrow) {
    server::EnvironmentQuery query;
    narrow(query);
    std::vector<std::string> ids;
    for (const auto& found : knowledge_->SearchEnvironments(query)) ids.push_back(found.id);
    return ids;
  }
  std::vector<std::string> Holding(const std::string& name) {
    return Find([&](auto& query) { query.holds = {name}; });
  }
};

TEST_F(RealVersionsTest, DiffTellsNewGoneAndMoved) {
  PutMap("flat", MapOf({"Cup", "Bed"}));
  PutMap("flat", MapOf({"Cup", "Bottle"}, 1.5));
  const server::VersionDiff diff = server::DiffVersions(*knowledge_, "flat", 1, 2);
  ASSERT_EQ(diff.objects.moved.size(), 1u);
  EXPECT_NEAR(diff.objects.moved[0].distance_m, 0.5, 1e-9);
  ASSERT_EQ(diff.objects.added.size(), 1u);
  EXPECT_EQ(diff.objects.added[0].label, "Bottle1");
  ASSERT_EQ(diff.objects.gone.size(), 1u);
}

TEST_F(RealVersionsTest, EnvironmentsAreFoundByWhatTheyHoldSubclassesIncluded) {
  PutMap("flat", MapOf({"Cup", "Bed"}));
  PutMap("lab", MapOf({"Bottle"}));
  EXPECT_THAT(Holding("Cup"), ElementsAre("flat"));
  EXPECT_THAT(Holding("Furniture"), ElementsAre("flat"));
  EXPECT_THAT(Holding("Container"), ::testing::Contains("lab"));
  EXPECT_THAT(Holding("Robot"), IsEmpty());
  EXPECT_THROW(Holding("Cupp"), Error);
  EXPECT_THAT(Find([](auto& query) { query.text = "bott*"; }), ElementsAre("lab"));
}

TEST_F(RealVersionsTest, AClassThatIsPutLaterFindsWhatWasThereBefore) {
  PutMap("flat", MapOf({"Cup"}));
  Put(DocumentKind::kOntology, "mine",
      std::string(kPrefixes) +
          ":DrinkingThing a owl:Class . :CupOfMine a owl:Class ; rdfs:subClassOf :DrinkingThing .");
  EXPECT_THAT(Holding("DrinkingThing"), IsEmpty());
  PutAsEditor(DocumentKind::kOntology, "mine",
              std::string(kPrefixes) +
                  ":DrinkingThing a owl:Class . lares:Cup rdfs:subClassOf :DrinkingThing .");
  EXPECT_THAT(Holding("DrinkingThing"), ElementsAre("flat"));
}

TEST_F(RealVersionsTest, RollbackBringsBackWhatAnEnvironmentIsFoundBy) {
  PutMap("flat", MapOf({"Cup"}));
  PutMap("flat", MapOf({"Bed"}));
  EXPECT_THAT(Holding("Cup"), IsEmpty());
  const auto answer = server::RollBack(*knowledge_, "flat", 1, {"ann", "", "", "", ""});
  EXPECT_EQ(answer.version.number, 3);
  EXPECT_THAT(Holding("Cup"), ElementsAre("flat"));
  EXPECT_THAT(Holding("Bed"), IsEmpty());
}

TEST_F(RealVersionsTest, MergeTakesTheObjectsOfBothSides) {
  PutMap("flat", MapOf({"Cup"}));
  PutMap("flat", MapOf({"Cup", "Bed"}));
  EXPECT_EQ(PutBranch(MapOf({"Cup", "Bottle"}), 1), 3);
  EXPECT_THAT(Holding("Bottle"), IsEmpty());
  server::MergeRequest request;
  request.environment = "flat";
  request.theirs = 3;
  const server::MergeAnswer answer = server::MergeVersions(*knowledge_, request);
  EXPECT_EQ(answer.base, 1);
  ASSERT_TRUE(answer.merged);
  EXPECT_EQ(answer.merged->objects.size(), 3u);
  EXPECT_THAT(Holding("Bottle"), ElementsAre("flat"));
  EXPECT_TRUE(server::MergeVersions(*knowledge_, request).up_to_date);
}

TEST_F(RealVersionsTest, ObjectMovedByBothIsAConflictUntilASideIsTaken) {
  PutMap("flat", MapOf({"Cup"}, 1));
  PutMap("flat", MapOf({"Cup"}, 2));
  PutBranch(MapOf({"Cup"}, 3), 1);
  server::MergeRequest request;
  request.environment = "flat";
  request.theirs = 3;
  const server::MergeAnswer refused = server::MergeVersions(*knowledge_, request);
  ASSERT_EQ(refused.conflicts.size(), 1u);
  EXPECT_TRUE(refused.conflicts[0].predicate.ends_with("m03"));
  EXPECT_FALSE(refused.merged);
  EXPECT_EQ(store_->FindEnvironment("flat")->count, 3);
  request.otherwise = rdf::Side::kTheirs;
  const server::MergeAnswer merged = server::MergeVersions(*knowledge_, request);
  ASSERT_TRUE(merged.merged);
  EXPECT_NEAR(merged.merged->objects.at(0).map_from_object->translation_m.x(), 3, 1e-9);
}

TEST_F(RealVersionsTest, OnlyTheNewestIsMergedInto) {
  PutMap("flat", MapOf({"Cup"}));
  PutMap("flat", MapOf({"Bed"}));
  server::MergeRequest request;
  request.environment = "flat";
  request.ours = 1;
  request.theirs = 2;
  EXPECT_THROW(server::MergeVersions(*knowledge_, request), Error);
}

TEST(NearestCommonVersionTest, IsTheHighestThatBothComeFrom) {
  std::vector<store::EnvironmentVersion> log(6);
  const std::vector<std::vector<int>> parents = {{}, {1}, {1}, {2, 3}, {3}, {4}};
  for (int i = 0; i < 6; ++i) {
    log[static_cast<std::size_t>(i)].number = i + 1;
    log[static_cast<std::size_t>(i)].parents = parents[static_cast<std::size_t>(i)];
  }
  EXPECT_EQ(server::NearestCommonVersion(log, 6, 5), 3);
  EXPECT_EQ(server::NearestCommonVersion(log, 2, 3), 1);
  EXPECT_EQ(server::NearestCommonVersion(log, 6, 2), 2);
}

}  // namespace
}  // namespace lares::testing
