// Task packages: what the knowledge chooses, and the grid it cuts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/hash.h"
#include "mapping/grid/read_grid.h"
#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace env = environment::testing;

std::string SizedRobot(const std::string& name, const std::string& size) {
  return BaseOnlyRobot(name) + ":" + name + " " + size + " .\n";
}

// A class param in the first step, as templates give it.
recipes::Plan PlanFor(const std::string& type, const std::string& value) {
  recipes::Plan plan;
  recipes::State state;
  state.id = state.label = "look";
  recipes::Parameter parameter;
  parameter.name = "object_class";
  parameter.type = type;
  parameter.value = value;
  state.inputs.push_back(parameter);
  plan.states.push_back(state);
  return plan;
}

class PackageTest : public KnowledgeFixture {
 protected:
  void SetUp() override {
    KnowledgeFixture::SetUp();
    Put(store::DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 2));
    Put(store::DocumentKind::kRobot, "small",
        SizedRobot("small", "lares:footprintRadius_m 0.6 ; lares:bodyHeight_m 1.4"));
    Put(store::DocumentKind::kRobot, "plain", BaseOnlyRobot("plain"));
    Put(store::DocumentKind::kRobot, "seer",
        BaseOnlyRobot("seer") +
            ":seer lares:subComponent :seer_eye . :seer_eye a lares:ORBbasedObjectRecognition .\n");
  }
  void PutModel(const std::string& id, const std::string& of) {
    server::PutRequest request;
    request.kind = store::DocumentKind::kObjectModel;
    request.id = id;
    request.file_name = id + ".ttl";
    request.bytes = std::string(kPrefixes) + ":" + id + " a lares:ObjectRecognitionModel ; " +
                    "lares:providesModelFor lares:" + of + " .\n";
    request.files.push_back({"face.png", "image/png", PutBlob("picture of " + id)});
    knowledge_->Put(request);
  }
  void PutPlace(const std::vector<std::pair<std::string, std::string>>& layers) {
    store::NewVersion version;
    version.environment = "place";
    for (const auto& [name, bytes] : layers) {
      version.layers.push_back(
          {name, name + (name == "grid" ? ".tar" : ".bt"), "", PutBlob(bytes), {}});
    }
    knowledge_->PutVersion(version);
  }
  server::TaskPackage Package(const std::string& robot, recipes::Plan plan) {
    server::PlanRequest request;
    request.task = "walk";
    request.robot = robot;
    return knowledge_->MakePackage(request, plan);
  }
  server::TaskPackage PackageAt(const std::string& robot) {
    recipes::Plan plan;
    plan.environment = "place";
    plan.environment_version = 1;
    return Package(robot, plan);
  }
};

const char kGridTarYaml[] =
    "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

std::string GridTar() {
  return env::MakeTar(
      {{"m.yaml", kGridTarYaml}, {"m.pgm", "P5\n4 1\n255\n" + std::string("\x00\xFE\xFE\xCD", 4)}});
}

TEST_F(PackageTest, ModelsOfTheClassAndItsSubclassesAreChosenWithTheReason) {
  PutModel("mug_model", "Cup");
  PutModel("bed_model", "Bed");
  const auto same = Package("small", PlanFor("class", "https://w3id.org/lares#Cup"));
  ASSERT_EQ(same.models.size(), 1U);
  EXPECT_EQ(same.models[0].document.id, "mug_model");
  ASSERT_EQ(same.models[0].files.size(), 1U);
  EXPECT_EQ(same.models[0].files[0].blob.sha256, Sha256Hex("picture of mug_model"));
  EXPECT_THAT(same.reasons, Contains(HasSubstr("the step 'look' needs it (object_class)")));
  const auto wider = Package("small", PlanFor("class", "https://w3id.org/lares#DrinkingVessel"));
  ASSERT_EQ(wider.models.size(), 1U);
  EXPECT_THAT(wider.reasons, Contains(HasSubstr("which is a kind of")));
}

TEST_F(PackageTest, WhatNoModelIsStoredForIsSaid) {
  PutModel("bed_model", "Bed");
  const auto package = Package("small", PlanFor("class", "https://w3id.org/lares#Cup"));
  EXPECT_THAT(package.models, IsEmpty());
  EXPECT_THAT(package.reasons, Contains(HasSubstr("no object model is stored for")));
}

TEST_F(PackageTest, APlaceWantsTheModelsOfWhatIsTypicalThere) {
  PutModel("mug_model", "Cup");
  PutModel("bed_model", "Bed");
  const auto package = Package("seer", PlanFor("class", "https://w3id.org/lares#Kitchen"));
  ASSERT_EQ(package.models.size(), 1U);
  EXPECT_EQ(package.models[0].document.id, "mug_model");
  EXPECT_EQ(package.models[0].files.size(), 1U);
  EXPECT_THAT(package.reasons, Contains(HasSubstr("is typical of")));
  const auto blind = Package("small", PlanFor("class", "https://w3id.org/lares#Kitchen"));
  EXPECT_THAT(blind.models, IsEmpty());
  EXPECT_THAT(blind.reasons, Contains(HasSubstr("has no object recognition component")));
}

TEST_F(PackageTest, OutputsOfStepsAndPartsOfTheRobotWantNoModel) {
  PutModel("mug_model", "Cup");
  recipes::Plan plan = PlanFor("designator", "https://w3id.org/lares#Cup");
  plan.states[0].inputs[0].source = recipes::Parameter::Source::kRobot;
  EXPECT_THAT(Package("small", plan).models, IsEmpty());
  plan.states[0].inputs[0].source = recipes::Parameter::Source::kStep;
  EXPECT_THAT(Package("small", plan).models, IsEmpty());
}

TEST_F(PackageTest, AnOctomapThatKnowsNothingAtTheseHeightsGivesWayToTheGridLayer) {
  // Voxels of 0.5 m: one is occupied, at 0–0.5 m in x, y and z, below the first layer looked at.
  PutPlace({{"octomap", env::OneVoxelBt()}, {"grid", GridTar()}});
  const auto package = PackageAt("small");
  ASSERT_NE(package.grid, nullptr) << package.no_grid;
  EXPECT_EQ(package.grid->layer, "grid");  // nothing is known of the octomap's layers from 0.5 m
  EXPECT_THAT(package.reasons, Contains(HasSubstr("nothing is known between 0.05 and 1.4 m")));
}

TEST_F(PackageTest, GridLayerIsInflatedForTheBody) {
  PutPlace({{"grid", GridTar()}});
  const auto small = PackageAt("small");
  ASSERT_NE(small.grid, nullptr);
  EXPECT_EQ(small.grid->pgm, "P5\n4 1\n255\n" + std::string("\x00\x00\xFE\xCD", 4));
  EXPECT_THAT(small.grid->yaml, HasSubstr("image: map.pgm\n"));
  EXPECT_THAT(small.grid->yaml, HasSubstr("origin: [-1, 2, 0]\n"));
  EXPECT_EQ(small.grid->pgm_sha256, Sha256Hex(small.grid->pgm));
  EXPECT_THAT(small.reasons, Contains(HasSubstr("inflated by 0.6 m")));
  const auto plain = PackageAt("plain");
  EXPECT_EQ(plain.grid->pgm, "P5\n4 1\n255\n" + std::string("\x00\xFE\xFE\xCD", 4));
  EXPECT_THAT(plain.reasons, Contains(HasSubstr("not inflated")));
  EXPECT_EQ(small.layers.size(), 1U);
}

TEST_F(PackageTest, SameLayerAndBodyShareOneGrid) {
  PutPlace({{"grid", GridTar()}});
  Put(store::DocumentKind::kRobot, "twin",
      SizedRobot("twin", "lares:footprintRadius_m 0.6 ; lares:bodyHeight_m 1.4"));
  EXPECT_EQ(PackageAt("small").grid, PackageAt("twin").grid);
  EXPECT_EQ(PackageAt("small").grid, knowledge_->MakeRobotGrid("twin", "place", 0));
  EXPECT_NE(PackageAt("small").grid, PackageAt("plain").grid);
  PutPlace({{"grid", env::MakeTar({{"m.yaml", kGridTarYaml},
                                   {"m.pgm", "P5\n1 1\n255\n" + std::string("\xFE")}})}});
  EXPECT_NE(PackageAt("small").grid, knowledge_->MakeRobotGrid("small", "place", 2));
}

TEST_F(PackageTest, WithoutGridOrEnvironmentThePackageSaysWhy) {
  PutPlace({{"trajectory", "0 0 0 0 0 0 0 1\n"}});
  const auto package = PackageAt("small");
  EXPECT_EQ(package.grid, nullptr);
  EXPECT_THAT(package.no_grid, HasSubstr("neither an octomap nor a grid layer"));
  EXPECT_THROW(knowledge_->MakeRobotGrid("small", "place", 1), Error);
  const auto nowhere = Package("small", {});
  EXPECT_EQ(nowhere.grid, nullptr);
  EXPECT_THAT(nowhere.no_grid, HasSubstr("no environment"));
  EXPECT_EQ(nowhere.environment, "");
}

TEST_F(PackageTest, AnOctomapThatIsNoneMakesNoGridAndHarmsNothing) {
  PutPlace({{"octomap", "# Octomap OcTree binary file\nid OcTree\nsize 5\nres 0.1\ndata\n"}});
  const auto package = PackageAt("small");
  EXPECT_EQ(package.grid, nullptr);
  EXPECT_THAT(package.no_grid, HasSubstr("octomap.bt"));
}

TEST_F(PackageTest, CorridorIsCutForTheBodyOfScout) {
  LARES_REQUIRE_DATA(file, "octomap/geb079.bt");
  PutFile(store::DocumentKind::kRobot,
          std::filesystem::path(LARES_SOURCE_DIR) / "robots/models/scout.ttl");
  PutPlace({{"octomap", ReadFile(file)}});
  const auto grid = knowledge_->MakeRobotGrid("scout", "place", 1);
  EXPECT_EQ(grid->layer, "octomap");
  EXPECT_NEAR(grid->heights_m->at(0), 0.08, 1e-9);
  EXPECT_NEAR(grid->heights_m->at(1), 1.2, 1e-9);
  EXPECT_EQ(grid->radius_m, 0.29);
  EXPECT_GT(grid->cells.free, 3'000U);
}

}  // namespace
}  // namespace lares::testing
