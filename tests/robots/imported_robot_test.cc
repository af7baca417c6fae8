// A robot from its URDF, as the knowledge service takes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "tests/lares_data.h"
#include "tests/robots/robot_texts.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ImportedRobotTest : public KnowledgeFixture {
 protected:
  void PutUrdf(const std::string& id, const std::string& urdf,
               const std::vector<std::string>& has = {}) {
    const urdf::Imported robot = urdf::Import(urdf, id + ".urdf");
    urdf::SrdlOptions options;
    options.id = id;
    for (const std::string& name : has) {
      const recipes::Resource component = knowledge_->ResolveComponent(name);
      options.stated.push_back({component.iri, component.label});
    }
    Put(store::DocumentKind::kRobot, id,
        urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options));
  }
  std::vector<std::string> Lacks(const std::string& robot) {
    std::vector<std::string> labels;
    for (const auto& one : knowledge_->MakePlan({"FindBottle", robot, "", 0, false, {}})
                               .result.match.smallest_repair) {
      labels.push_back(one.label);
    }
    return labels;
  }
};

TEST_F(ImportedRobotTest, FindBottleIsRefusedForABarePr2AndAcceptedOnceStated) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  LARES_REQUIRE_DATA(file, "roboearth/urdf/pr2.urdf");
  PutFile(store::DocumentKind::kRecipe, recipe, true);
  PutUrdf("pr2", ReadFile(file));
  EXPECT_THAT(Lacks("pr2"),
              ElementsAre("object recognition component", "object recognition model"));
  PutUrdf("pr2", ReadFile(file), {"ObjectRecognitionComponent", "ObjectRecognitionModel"});
  const auto answer = knowledge_->MakePlan({"FindBottle", "pr2", "", 0, false, {}});
  ASSERT_TRUE(answer.result.plan);
  bool found = false;
  for (const auto& state : answer.result.plan->states) {
    for (const auto& input : state.inputs) {
      if (input.name != "camera_pose") continue;
      found = true;
      double x = 0, y = 0, z = 0;
      ASSERT_EQ(std::sscanf(input.value.c_str(), "%lf %lf %lf", &x, &y, &z), 3) << input.value;
      EXPECT_NEAR(z, 1.464, 0.01) << input.value;  // the Kinect on the head
    }
  }
  EXPECT_TRUE(found);
}

TEST_F(ImportedRobotTest, CapabilitiesFollowFromTheParts) {
  PutUrdf("cart", Cart(), {"NavigationComponent", "LocalizationComponent", "OccupancyGridMap"});
  std::vector<std::string> there;
  std::string recognition;
  for (const auto& finding : knowledge_->Capabilities("cart", false).capabilities) {
    if (finding.availability == recipes::Availability::kAvailable) {
      there.push_back(finding.what.label);
    }
    if (finding.what.label == "object recognition capability") recognition = finding.explanation;
  }
  EXPECT_THAT(there, ::testing::IsSupersetOf({"base motion capability", "navigation capability"}));
  EXPECT_THAT(recognition, HasSubstr("object recognition component"));
}

TEST_F(ImportedRobotTest, OnlyComponentsCanBeStated) {
  try {
    knowledge_->ResolveComponent("ObjectRecognitionComponentt");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kNotFound);
    EXPECT_THAT(error.candidates(), ::testing::Contains("ObjectRecognitionComponent"));
  }
  try {
    knowledge_->ResolveComponent("Cup");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
  }
}

}  // namespace
}  // namespace lares::testing
