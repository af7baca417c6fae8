// A robot from its URDF, as the knowledge service takes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>

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
               const std::vector<std::string>& has = {}, const std::string& base_frame = "") {
    const urdf::Imported robot = urdf::Import(urdf, id + ".urdf", base_frame);
    urdf::SrdlOptions options;
    options.id = id;
    for (const std::string& name : has) {
      const recipes::Resource component = knowledge_->ResolveComponent(name);
      options.stated.push_back({component.iri, component.label});
    }
    Put(store::DocumentKind::kRobot, id,
        urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options));
  }
  std::vector<std::string> Lacks(const std::string& robot, const std::string& task = "FindBottle") {
    std::vector<std::string> labels;
    for (const auto& one :
         knowledge_->MakePlan({task, robot, "", 0, false, {}}).result.match.smallest_repair) {
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

// A cart whose root is base_link, with the camera beside the axes of all frames: base_footprint
// hangs below it and is turned, a mast stands on it.
std::string TurnedCart() {
  return Robot(
      LinkText("base_link", Shape("<box size=\"0.4 0.3 0.1\"/>")) + LinkText("base_footprint") +
      LinkText("mast") + LinkText("camera") +
      JointText("down", "fixed", "base_link", "base_footprint", Origin("0.3 0.1 -0.2", "0 0 0.5")) +
      JointText("up", "fixed", "base_link", "mast", Origin("0.1 0 0.6", "0 0 0.2")) +
      JointText("out", "fixed", "mast", "camera", Origin("0.05 0.02 0.1", "0.1 0.3 -0.4")) +
      "<gazebo reference=\"camera\"><sensor name=\"eye\" type=\"camera\"/></gazebo>"
      "<gazebo><plugin name=\"p\" filename=\"libgazebo_ros_planar_move.so\"/></gazebo>");
}

// Looks for a cup, for which the robot needs to know where its camera is.
constexpr char kLocate[] = "https://w3id.org/lares#LocateObjectTemplate";
constexpr char kLook[] =
    ":LookForACup a owl:Class ; rdfs:subClassOf lares:PurposefulAction , [ a owl:Restriction ; "
    "owl:onProperty lares:subAction ; owl:someValuesFrom :See ] .\n"
    ":See a owl:Class ; rdfs:subClassOf lares:Perceiving , [ a owl:Restriction ; "
    "owl:onProperty lares:detectedObject ; owl:someValuesFrom lares:Cup ] .\n";

std::vector<recipes::Parameter> Inputs(const recipes::Plan& plan, const std::string& name) {
  std::vector<recipes::Parameter> inputs;
  for (const auto& state : plan.states) {
    std::copy_if(state.inputs.begin(), state.inputs.end(), std::back_inserter(inputs),
                 [&](const recipes::Parameter& input) { return input.name == name; });
  }
  return inputs;
}

TEST_F(ImportedRobotTest, ThePlansCameraPoseIsThatOfTheReportInTheSameFrame) {
  Put(store::DocumentKind::kRecipe, "look", std::string(kPrefixes) + kLook);
  for (const char* wanted : {"", "base_link", "base_footprint", "mast", "camera"}) {
    PutUrdf("turned", TurnedCart(), {"ObjectRecognitionComponent", "ObjectRecognitionModel"},
            wanted);
    const auto imported = urdf::Import(TurnedCart(), "turned.urdf", wanted);
    const RigidTransform& reported = imported.body.sensors.at(0).base_from_sensor;
    const std::string frame =
        imported.model.links[static_cast<std::size_t>(imported.body.base_frame)].name;
    EXPECT_THAT(Lacks("turned", "LookForACup"), IsEmpty());
    const auto answer = knowledge_->MakePlan(
        {"LookForACup", "turned", "", 0, false, {{"http://example.org/test#See", kLocate}}});
    ASSERT_TRUE(answer.result.plan) << answer.result.choices.size();
    const std::vector<recipes::Parameter> poses = Inputs(*answer.result.plan, "camera_pose");
    ASSERT_EQ(poses.size(), 1u) << wanted;
    EXPECT_EQ(poses[0].frame, frame) << wanted;
    std::istringstream numbers(poses[0].value);
    Eigen::Vector3d t;
    Eigen::Quaterniond q;
    numbers >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
    ASSERT_FALSE(numbers.fail()) << poses[0].value;
    EXPECT_LT((t - reported.translation_m).norm(), 1e-5) << wanted << ": " << poses[0].value;
    EXPECT_LT(q.angularDistance(reported.rotation), 1e-5) << wanted << ": " << poses[0].value;
  }
}

TEST_F(ImportedRobotTest, ThePlansBaseFrameIsThatOfTheReport) {
  Put(store::DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 1));
  for (const char* wanted : {"", "base_link", "mast"}) {
    PutUrdf("turned", TurnedCart(), {}, wanted);
    const auto answer = knowledge_->MakePlan({"Walk", "turned", "", 0, false, {}});
    ASSERT_TRUE(answer.result.plan) << ::testing::PrintToString(answer.result.problems);
    const std::vector<recipes::Parameter> frames = Inputs(*answer.result.plan, "base_frame");
    ASSERT_EQ(frames.size(), 1u) << wanted;
    EXPECT_EQ(frames[0].value, *wanted == 0 ? "base_footprint" : wanted);
  }
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
