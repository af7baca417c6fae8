// The golden answers on RoboEarth's original files, with our modules alone and with theirs added.
#include <gmock/gmock.h>

#include <cstdio>

#include "tests/lares_data.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Availability;
using recipes::Plan;
using recipes::PlanResult;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

const char kPioneer[] = "http://ias.cs.tum.edu/kb/ari.owl#ari_robot1";
const char kServe[] = "http://www.roboearth.org/kb/serve_drink.owl#ServeADrink";

const World& CatalogueWithTheirs() {
  static const World* world = [] {
    const std::filesystem::path folder = DataFolder() / "roboearth";
    return new World({folder / "ontology/knowrob.owl", folder / "ontology/roboearth.owl",
                      folder / "srdl/srdl2.owl", folder / "srdl/srdl2-cap.owl",
                      folder / "srdl/srdl2-comp.owl", folder / "srdl/srdl2-action.owl"});
  }();
  return *world;
}

enum class Modules { kOurs, kOursAndTheirs };

class RoboEarth : public ::testing::TestWithParam<Modules> {
 protected:
  World Stack(const std::string& recipe, const std::string& robot) {
    World world = GetParam() == Modules::kOurs ? Catalogue() : CatalogueWithTheirs();
    const std::filesystem::path folder = DataFolder() / "roboearth";
    world.PutFile("robot", folder / "robots" / robot);
    world.PutFile("recipe", folder / "recipes" / recipe, recipe == "exploration-recipe.owl");
    return world;
  }
  static std::string Robot(const World& world) {
    const auto robots = recipes::FindRobots(Engines(), world.view(), "robot");
    EXPECT_EQ(robots.size(), 1u);
    return robots.empty() ? "" : robots.front().iri;
  }
  static recipes::MatchReport Match(const World& world, const std::string& task) {
    return recipes::Match(Engines(), world.view(), task, Robot(world));
  }
  static PlanResult Plan(const World& world, const std::string& task) {
    return recipes::MakePlan(Engines(), world.view(), task, Robot(world));
  }
};

INSTANTIATE_TEST_SUITE_P(Modules, RoboEarth,
                         ::testing::Values(Modules::kOurs, Modules::kOursAndTheirs),
                         [](const auto& parameter) {
                           return parameter.param == Modules::kOurs ? "Ours" : "OursAndTheirs";
                         });

std::vector<std::string> CapabilityIris(const recipes::MatchReport& report) {
  std::vector<std::string> iris;
  for (const auto& finding : report.capabilities) iris.push_back(finding.what.iri);
  return iris;
}

std::vector<std::string> Iris(const std::vector<recipes::Resource>& resources) {
  std::vector<std::string> iris;
  for (const auto& resource : resources) iris.push_back(resource.iri);
  return iris;
}

std::vector<std::string> TransitionTexts(const recipes::Plan& plan) {
  std::vector<std::string> texts;
  for (const auto& transition : plan.transitions) {
    if (transition.outcome == "failed") continue;
    texts.push_back(transition.from + " " + transition.outcome + " " + transition.to +
                    (transition.added ? " +" : ""));
  }
  return texts;
}

TEST_P(RoboEarth, FindBottleNeedsBaseMotionAndObjectRecognitionAndAllThreeRobotsHaveThem) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  for (const char* robot : {"pioneer.owl", "amigo.owl", "PR2.owl"}) {
    const World world = Stack("object-search-recipe.owl", robot);
    const auto report = Match(world, Lares("FindBottle"));
    EXPECT_TRUE(report.feasible) << robot;
    EXPECT_THAT(CapabilityIris(report), UnorderedElementsAre(Lares("BaseMotionCapability"),
                                                             Lares("ObjectRecognitionCapability")))
        << robot;
    EXPECT_THAT(report.smallest_repair, IsEmpty());
  }
}

TEST_P(RoboEarth, ExplorationLacksVisualSlamMappingOnThePr2AndNothingElse) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/exploration-recipe.owl");
  for (const char* robot : {"pioneer.owl", "amigo.owl"}) {
    const auto report =
        Match(Stack("exploration-recipe.owl", robot), Lares("RobotEnvironmentExploration"));
    EXPECT_TRUE(report.feasible) << robot;
    EXPECT_THAT(CapabilityIris(report),
                UnorderedElementsAre(Lares("BaseMotionCapability"), Lares("VisualSLAMCapability")));
  }
  const auto report =
      Match(Stack("exploration-recipe.owl", "PR2.owl"), Lares("RobotEnvironmentExploration"));
  EXPECT_FALSE(report.feasible);
  EXPECT_THAT(Iris(report.smallest_repair), ElementsAre(Lares("VisualSlamMappingComponent")));
  for (const auto& finding : report.capabilities) {
    for (const auto& dependency : finding.dependencies) {
      EXPECT_EQ(dependency.availability == Availability::kMissing,
                dependency.what.iri == Lares("VisualSlamMappingComponent"))
          << dependency.what.iri;
    }
  }
}

TEST_P(RoboEarth, ServingADrinkIsRefusedForThePioneerWithTheSmallestRepair) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/serve_drink.owl");
  for (const char* robot : {"amigo.owl", "PR2.owl"}) {
    EXPECT_TRUE(Match(Stack("serve_drink.owl", robot), kServe).feasible) << robot;
  }
  const auto report = Match(Stack("serve_drink.owl", "pioneer.owl"), kServe);
  EXPECT_FALSE(report.feasible);
  EXPECT_THAT(Iris(report.smallest_repair),
              UnorderedElementsAre(Lares("ArmComponent"), Lares("ArmMotionController"),
                                   Lares("ManipulationEntity")));
  std::map<std::string, Availability> found;
  for (const auto& finding : report.capabilities) {
    found[finding.what.iri] = finding.availability;
  }
  const std::map<std::string, Availability> expected = {
      {Lares("ArmMotionCapability"), Availability::kMissing},
      {Lares("BaseMotionCapability"), Availability::kAvailable},
      {Lares("GraspingCapability"), Availability::kDerivable},
      {Lares("GripperMotionCapability"), Availability::kMissing}};
  EXPECT_EQ(found, expected);
}

TEST_P(RoboEarth, FindBottleGetsAnExitForNoPoseLeft) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  const PlanResult result =
      Plan(Stack("object-search-recipe.owl", "pioneer.owl"), Lares("FindBottle"));
  ASSERT_TRUE(result.plan) << ::testing::PrintToString(result.problems);
  EXPECT_THAT(TransitionTexts(*result.plan),
              ElementsAre("start-vision-modules succeeded infer-likely-locations",
                          "infer-likely-locations succeeded go-to-next-best-pose",
                          "go-to-next-best-pose succeeded check-if-found",
                          "go-to-next-best-pose exhausted stop-vision-modules +",
                          "check-if-found true stop-vision-modules",
                          "check-if-found false go-to-next-best-pose",
                          "stop-vision-modules succeeded upload-vslam-map",
                          "upload-vslam-map succeeded succeeded"));
}

TEST_P(RoboEarth, ExplorationComesOutAsItIsWritten) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/exploration-recipe.owl");
  const PlanResult result =
      Plan(Stack("exploration-recipe.owl", "pioneer.owl"), Lares("RobotEnvironmentExploration"));
  ASSERT_TRUE(result.plan) << ::testing::PrintToString(result.problems);
  EXPECT_EQ(result.plan->start, "load-typical-object-models");
  EXPECT_THAT(TransitionTexts(*result.plan),
              UnorderedElementsAre("load-typical-object-models succeeded start-exploration-modules",
                                   "start-exploration-modules succeeded explore-environment",
                                   "explore-environment succeeded check-finished",
                                   "check-finished true stop-exploration-modules",
                                   "check-finished false move-to-nbv",
                                   "move-to-nbv succeeded explore-environment",
                                   "stop-exploration-modules succeeded move-to-origin",
                                   "move-to-origin succeeded upload-vslam-map",
                                   "upload-vslam-map succeeded succeeded"));
  for (const auto& state : result.plan->states) {
    if (state.id != "move-to-origin") continue;
    ASSERT_EQ(state.inputs.empty(), false);
    EXPECT_EQ(state.inputs.back().value, "0 0 0 0 0 0 1");
    EXPECT_EQ(state.inputs.back().frame, "map");
  }
}

TEST_P(RoboEarth, ServingADrinkInlinesTheGraspAndNamesItsPlaces) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/serve_drink.owl");
  const PlanResult result = Plan(Stack("serve_drink.owl", "PR2.owl"), kServe);
  ASSERT_TRUE(result.plan) << ::testing::PrintToString(result.problems);
  std::vector<std::string> ids;
  for (const auto& state : result.plan->states) ids.push_back(state.id);
  EXPECT_THAT(
      ids, ElementsAre("MoveBaseToGraspPose", "ReachToApproachPose", "OpenGripperForGrasping",
                       "ReachForObjectPose", "CloseGripperForGrasping", "LiftObjectToApproachPose",
                       "ReachToParkingPose", "MoveBaseToHandoverPose", "HandoverObject",
                       "OpenGripperForHandover", "succeeded", "failed"));
  EXPECT_THAT(result.plan->unordered, IsEmpty());
  const auto& inputs = result.plan->states.front().inputs;
  const auto target = std::find_if(inputs.begin(), inputs.end(),
                                   [](const auto& input) { return input.name == "target_pose"; });
  ASSERT_NE(target, inputs.end());
  EXPECT_EQ(target->type, "designator");
  EXPECT_EQ(target->text, "in reach of bottle1");
}

TEST_P(RoboEarth, TheRecipesHaveNoProblems) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/serve_drink.owl");
  for (const char* name :
       {"object-search-recipe.owl", "exploration-recipe.owl", "serve_drink.owl"}) {
    const World world = Stack(name, "pioneer.owl");
    const auto tasks = recipes::FindTasks(Engines(), world.view(), "recipe");
    EXPECT_FALSE(tasks.empty()) << name;
    int top = 0;
    for (const auto& task : tasks) {
      EXPECT_THAT(task.problems, IsEmpty()) << name;
      top += task.top_level;
    }
    EXPECT_EQ(top, 1) << name;
  }
}

TEST_P(RoboEarth, EveryFeasibleTaskGetsAPlan) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/serve_drink.owl");
  const std::vector<std::vector<std::string>> feasible = {
      {"object-search-recipe.owl", Lares("FindBottle"), "amigo.owl"},
      {"object-search-recipe.owl", Lares("FindBottle"), "PR2.owl"},
      {"exploration-recipe.owl", Lares("RobotEnvironmentExploration"), "amigo.owl"},
      {"serve_drink.owl", kServe, "amigo.owl"}};
  for (const auto& names : feasible) {
    const PlanResult result = Plan(Stack(names[0], names[2]), names[1]);
    EXPECT_TRUE(result.plan) << names[1] << " " << names[2]
                             << ::testing::PrintToString(result.problems);
  }
}

TEST_P(RoboEarth, ThePr2sCameraStandsWhereItsJointsPutIt) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  const PlanResult result = Plan(Stack("object-search-recipe.owl", "PR2.owl"), Lares("FindBottle"));
  ASSERT_TRUE(result.plan);
  bool found = false;
  for (const auto& input : result.plan->states.at(1).inputs) {
    if (input.name != "camera_pose") continue;
    found = true;
    double x = 0, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(input.value.c_str(), "%lf %lf %lf", &x, &y, &z), 3) << input.value;
    // On the head: above the base, some 1.1 to 1.6 m up.
    EXPECT_LT(std::abs(x), 0.3) << input.value;
    EXPECT_LT(std::abs(y), 0.3) << input.value;
    EXPECT_GT(z, 1.0) << input.value;
    EXPECT_LT(z, 1.7) << input.value;
    EXPECT_EQ(input.frame, "base_footprint");
  }
  EXPECT_TRUE(found);
}

TEST(RoboEarthBody, AnInferredCircleOfPartsIsNoFault) {
  LARES_REQUIRE_DATA(robot, "roboearth/robots/pioneer.owl");
  World world = Catalogue();
  world.PutFile("robot", robot);
  EXPECT_THAT(Iris(recipes::FindRobots(Engines(), world.view(), "robot")), ElementsAre(kPioneer));
}

}  // namespace
}  // namespace lares::testing
