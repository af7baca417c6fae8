// Plans made from recipes and robots of our own.
#include <gmock/gmock.h>

#include "tests/recipes/plan_maker.h"

namespace lares::testing {
namespace {

using recipes::Parameter;
using recipes::Plan;
using recipes::PlanOptions;
using recipes::PlanResult;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

const std::string kGo = "lares:Translation-LocationChange , " + Has("lares:toLocation", ":here");
const std::string kHere = ":here a lares:Point2D .\n";
const std::string kLook = "lares:Perceiving , " + Some("lares:detectedObject", "lares:Cup");
const std::string kInfer = "lares:InferLikelyObjectLocations , " +
                           Some("lares:objectActedOn", "lares:Cup") + " , " +
                           Has("lares:outputsCreated", ":poses");
const std::string kNext = "lares:Translation-LocationChange , " + Has("lares:toLocation", ":poses");

std::string ARobot() {
  return RobotText({"MobileBase", "Camera", "ObjectRecognitionComponent", "ObjectRecognitionModel",
                    "VisualSlamMappingComponent"},
                   {});
}

PlanResult Make(const std::string& recipe, const PlanOptions& options = {},
                const std::string& robot = ARobot(), const std::string& more = "") {
  return MakePlanOf(recipe, options, robot, more);
}

std::vector<std::string> Ways(const Plan& plan) {
  std::vector<std::string> texts;
  for (const auto& transition : plan.transitions) {
    if (transition.outcome == "failed" && transition.to == "failed") continue;
    texts.push_back(transition.from + " " + transition.outcome + " " + transition.to +
                    (transition.added ? " +" : ""));
  }
  return texts;
}

std::string Search() {
  return StateMachine({{"infer", kInfer}, {"next", kNext}, {"look", kLook}, {"stop", kGo}}, "infer",
                      {"stop"},
                      {{"infer", "COMPLETED_OK", "next"},
                       {"next", "COMPLETED_OK", "look"},
                       {"look", "CONDITION_FALSE", "next"},
                       {"look", "CONDITION_TRUE", "stop"}}) +
         kHere;
}

TEST(Plan, ALoopGetsTheExitThatItsSkillNeeds) {
  const auto result = Make(Search());
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->start, "infer");
  EXPECT_THAT(Ways(*result.plan),
              ElementsAre("infer succeeded next", "next succeeded look", "next exhausted stop +",
                          "look true stop", "look false next", "stop succeeded succeeded"));
  EXPECT_THAT(result.plan->notes, Contains(HasSubstr("added: next on 'exhausted' leads to stop")));
}

TEST(Plan, ASearchThatAlsoSucceedsWhenNothingWasFoundSaysSo) {
  const auto result = Make(Search());
  ASSERT_PLAN(result);
  EXPECT_THAT(result.plan->notes,
              Contains("the plan also ends as succeeded when nothing was found: from next on "
                       "'exhausted' by way of stop → succeeded"));
}

TEST(Plan, AnExitThatTheRecipeStatesIsKept) {
  const auto result = Make(
      Search() + ":Task rdfs:subClassOf " + Has("lares:stateTransition", ":out") +
      " . :out lares:fromState :next ; lares:causedBy lares:EXHAUSTED ; lares:toState :infer .");
  ASSERT_PLAN(result);
  EXPECT_THAT(Ways(*result.plan), Contains("next exhausted infer"));
}

TEST(Plan, ALoopWithoutAnyExitEndsWhenItsSkillIsExhausted) {
  const auto result =
      Make(StateMachine({{"infer", kInfer}, {"next", kNext}}, "infer", {},
                        {{"infer", "COMPLETED_OK", "next"}, {"next", "COMPLETED_OK", "next"}}));
  ASSERT_PLAN(result);
  EXPECT_THAT(Ways(*result.plan), Contains("next exhausted exhausted +"));
  EXPECT_THAT(Ids(*result.plan), ElementsAre("infer", "next", "exhausted", "failed"));
}

TEST(Plan, AnInnerLoopIsLeftAndNotTheOuterOne) {
  // Outer: room → search → more? with its own exit; the search inside has its own loop.
  const std::string inner =
      "lares:PurposefulAction , " + Some("lares:subAction", ":infer") + " , " +
      Some("lares:subAction", ":next") + " , " + Some("lares:subAction", ":look") + " , " +
      Has("lares:taskStartState", ":infer") + " , " + Has("lares:taskEndState", ":look") + " , " +
      Has("lares:stateTransition", ":i1") + " , " + Has("lares:stateTransition", ":i2") + " , " +
      Has("lares:stateTransition", ":i3");
  const std::string recipe =
      StateMachine({{"room", kGo}, {"search", inner}, {"more", kLook}, {"home", kGo}}, "room",
                   {"home"},
                   {{"room", "COMPLETED_OK", "search"},
                    {"search", "COMPLETED_OK", "more"},
                    {"more", "CONDITION_TRUE", "room"},
                    {"more", "CONDITION_FALSE", "home"}}) +
      kHere + ":infer rdfs:subClassOf " + kInfer + " . :next rdfs:subClassOf " + kNext +
      " . :look rdfs:subClassOf " + kLook +
      " . :i1 lares:fromState :infer ; lares:causedBy lares:COMPLETED_OK ; lares:toState :next ."
      " :i2 lares:fromState :next ; lares:causedBy lares:COMPLETED_OK ; lares:toState :look ."
      " :i3 lares:fromState :look ; lares:causedBy lares:CONDITION_FALSE ; lares:toState :next .";
  const auto result = Make(recipe);
  ASSERT_PLAN(result);
  EXPECT_THAT(
      Ways(*result.plan),
      UnorderedElementsAre("room succeeded infer", "infer succeeded next", "next succeeded look",
                           "next exhausted more +", "look true more", "look false next",
                           "more true room", "more false home", "home succeeded succeeded"));
}

TEST(Plan, StepsThatStayUnorderedAreReportedAndSequencedByName) {
  const auto result = Make(PartialOrder({{"d", kGo}, {"b", kGo}, {"a", kGo}, {"c", kGo}},
                                        {{"c", "a"}, {"c", "b"}, {"a", "d"}, {"b", "d"}}) +
                           kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), ElementsAre("c", "a", "b", "d", "succeeded", "failed"));
  EXPECT_THAT(result.plan->unordered, ElementsAre(ElementsAre("a", "b")));
  EXPECT_THAT(result.plan->notes, Contains(HasSubstr("in which order these are done: a, b")));
}

TEST(Plan, AnythingUnorderedAmongAllIsOneGroup) {
  const auto result = Make(PartialOrder({{"a", kGo}, {"b", kGo}, {"c", kGo}}, {}) + kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(result.plan->unordered, ElementsAre(ElementsAre("a", "b", "c")));
}

TEST(Plan, AStepUsedTwiceGetsTwoIds) {
  const std::string twice = " , " + Some("lares:subAction", ":go");
  const auto result = Make(PartialOrder({{"one", "lares:PurposefulAction" + twice},
                                         {"two", "lares:PurposefulAction" + twice}},
                                        {{"one", "two"}}) +
                           ":go rdfs:subClassOf " + kGo + " .\n" + kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ways(*result.plan),
              ElementsAre("one--go succeeded two--go", "two--go succeeded succeeded"));
}

TEST(Plan, AWayForFailureThatTheRecipeStatesIsKept) {
  const auto result = Make(StateMachine({{"a", kGo}, {"rescue", kGo}}, "a", {"a", "rescue"},
                                        {{"a", "COMPLETED_FAILED", "rescue"}}) +
                           kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ways(*result.plan), ElementsAre("a succeeded succeeded", "a failed rescue",
                                              "rescue succeeded succeeded"));
}

TEST(Plan, TheNearestTemplateIsTaken) {
  const std::string own = Turtle(
      ":Gliding rdfs:subClassOf lares:Translation-LocationChange .\n"
      ":glide a lares:SkillTemplate ; lares:forAction :Gliding ; lares:skillName \"Glide\" ;\n"
      "  lares:skillOutcome [ lares:outcomeName \"succeeded\" ; lares:meansResult "
      "lares:COMPLETED_OK ] .\n");
  const std::string step = ":Gliding , " + Has("lares:toLocation", ":here");
  const auto result = Make(PartialOrder({{"a", step}}, {}) + kHere, {}, ARobot(), own);
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->states.front().skill, "Glide");
  EXPECT_EQ(result.plan->states.front().rada_distance, 1);
  EXPECT_THAT(result.plan->states.front().outcomes, ElementsAre("succeeded", "failed"));
  const auto picky = Make(PartialOrder({{"a", step}}, {}) + kHere, {}, ARobot(),
                          own + ":glide lares:needsComponent :Wings .\n");
  ASSERT_PLAN(picky);
  EXPECT_EQ(picky.plan->states.front().skill, "NavigateToPose");
  EXPECT_EQ(picky.plan->states.front().rada_distance, 2);
}

TEST(Plan, ATieIsAChoiceThatCanBeAnswered) {
  const std::string rival = Turtle(
      ":drift a lares:SkillTemplate ; lares:forAction lares:Translation-LocationChange ;\n"
      "  lares:skillName \"Drift\" ; lares:skillOutcome [ lares:outcomeName \"succeeded\" ; "
      "lares:meansResult lares:COMPLETED_OK ] .\n");
  const std::string recipe = PartialOrder({{"a", kGo}}, {}) + kHere;
  const auto open = Make(recipe, {}, ARobot(), rival);
  EXPECT_FALSE(open.plan);
  ASSERT_EQ(open.choices.size(), 1u);
  EXPECT_EQ(open.choices.front().step.iri, Example("a"));
  EXPECT_THAT(Labels(open.choices.front().templates),
              UnorderedElementsAre("drift", "navigate to a pose"));
  PlanOptions options;
  options.templates[Example("a")] = Example("drift");
  const auto answered = Make(recipe, options, ARobot(), rival);
  ASSERT_PLAN(answered);
  EXPECT_EQ(answered.plan->states.front().skill, "Drift");
  options.templates[Example("a")] = Lares("GraspObjectTemplate");
  EXPECT_THAT(Make(recipe, options, ARobot(), rival).problems,
              ElementsAre(HasSubstr("does not apply to 'a'")));
}

TEST(Plan, AnActionWithoutATemplateIsAProblem) {
  const auto result =
      Make(PartialOrder({{"a", "lares:DownloadingData"}}, {}), {}, RobotText({"MobileBase"}, {}));
  ASSERT_TRUE(result.match.feasible);
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("'a'"), HasSubstr("no skill template"))));
}

TEST(Plan, AResultThatNoTemplateHasIsNamed) {
  const auto result = Make(
      StateMachine({{"a", kGo}, {"b", kGo}}, "a", {"b"}, {{"a", "CONDITION_TRUE", "b"}}) + kHere);
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("no skill template for 'a'"),
                                HasSubstr("an outcome that means"), HasSubstr("CONDITION_TRUE>"))));
}

TEST(Plan, AValueThatOneWayDoesNotCreateIsAProblem) {
  const auto result =
      Make(StateMachine({{"look", kLook}, {"infer", kInfer}, {"next", kNext}}, "look", {"next"},
                        {{"look", "CONDITION_TRUE", "infer"},
                         {"look", "CONDITION_FALSE", "next"},
                         {"infer", "COMPLETED_OK", "next"}}));
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("'candidate_poses' of 'next' uses 'poses'"),
                                HasSubstr("on the way look → next"))));
}

TEST(Plan, AnInputThatNothingSaysIsAProblem) {
  const auto result = Make(PartialOrder({{"a", "lares:Translation-LocationChange"}}, {}));
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("'target_pose' of 'a'"), HasSubstr("to location"))));
}

TEST(Plan, AnInfeasibleMatchGivesNoPlan) {
  const auto result = Make(Search(), {}, RobotText({"Camera"}, {}));
  EXPECT_FALSE(result.plan);
  EXPECT_FALSE(result.match.feasible);
  EXPECT_THAT(result.problems, IsEmpty());
}

TEST(Plan, ARecipeWithProblemsGivesThem) {
  const auto result =
      Make(StateMachine({{"a", kGo}}, "a", {"a"}, {{"a", "CONDITION_TRUE", "gone"}}) + kHere);
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems, ElementsAre(HasSubstr("which is no step")));
}

TEST(Plan, WhatAStepCreatesReachesTheStepThatUsesIt) {
  const auto result = Make(Search());
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->states.front().outputs.at("candidate_poses"), "poses");
  const Parameter& poses = Input(*result.plan, "next", "candidate_poses");
  EXPECT_EQ(poses.value, "{poses}");
  EXPECT_EQ(poses.source, Parameter::Source::kStep);
  EXPECT_EQ(poses.type, "pose_list");
  EXPECT_EQ(Input(*result.plan, "look", "object_class").value, Lares("Cup"));
}

// Turned by 90° about z at (1, 2, 0.5): x' = -y, y' = x.
const char kTurned[] =
    " a lares:RotationMatrix3D ; lares:m00 0.0 ; lares:m01 -1.0 ; lares:m02 0.0 ; lares:m03 1.0 ;"
    " lares:m10 1.0 ; lares:m11 0.0 ; lares:m12 0.0 ; lares:m13 2.0 ;"
    " lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 1.0 ; lares:m23 0.5 .\n";

TEST(Plan, AMatrixBecomesAPose) {
  const auto result = Make(PartialOrder({{"a", kGo}}, {}) + ":here" + kTurned);
  ASSERT_PLAN(result);
  const Parameter& pose = Input(*result.plan, "a", "target_pose");
  EXPECT_EQ(pose.value, "1 2 0.5 0 0 0.707107 0.707107");
  EXPECT_EQ(pose.frame, "map");
  EXPECT_EQ(pose.type, "pose");
}

TEST(Plan, AMatrixThatIsNoPoseIsAProblem) {
  std::string broken = kTurned;
  broken.replace(broken.find("m03 1.0"), 7, "m03 \"NaN\"^^xsd:double");
  const auto result = Make(PartialOrder({{"a", kGo}}, {}) + ":here" + broken);
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems, ElementsAre(AllOf(HasSubstr("'a'"), HasSubstr("matrix 'here'"))));
}

TEST(Plan, APlaceByWhatStandsThereIsADesignatorWithItsPoseFromTheMap) {
  PlanOptions options;
  options.environment = "home";
  const std::string recipe =
      PartialOrder({{"a", kGo}}, {}) + ":here a lares:Point2D ; lares:inReachOf :mug .\n";
  const auto bare = Make(recipe, options);
  ASSERT_PLAN(bare);
  EXPECT_EQ(Input(*bare.plan, "a", "target_pose").type, "designator");
  EXPECT_EQ(Input(*bare.plan, "a", "target_pose").text, "in reach of mug");
  const auto mapped = Make(recipe, options, ARobot(),
                           Turtle(":seen lares:objectActedOn :mug ; lares:eventOccursAt :at . :at" +
                                  std::string(kTurned)));
  ASSERT_PLAN(mapped);
  const Parameter& pose = Input(*mapped.plan, "a", "target_pose_reference_pose");
  EXPECT_EQ(pose.value, "1 2 0.5 0 0 0.707107 0.707107");
  EXPECT_EQ(pose.source, Parameter::Source::kEnvironment);
}

TEST(Plan, ABarePointIsANamedPlaceThatTheRobotMustKnow) {
  const auto result = Make(PartialOrder({{"a", kGo}}, {}) + kHere);
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a", "target_pose").text, "the named place here");
  EXPECT_THAT(result.plan->notes, Contains(HasSubstr("the robot must know it")));
}

TEST(Plan, AnotherKindOfPlaceThanTheRecipesIsNoted) {
  const std::string recipe = PartialOrder(
      {{"a", "lares:LoadTypicalObjectModels , " + Has("lares:modelsForPlace", "lares:Kitchen")}},
      {});
  PlanOptions options;
  options.environment = "home";
  options.environment_iri = Lares("Office");
  const auto other = Make(recipe, options);
  ASSERT_PLAN(other);
  EXPECT_EQ(Input(*other.plan, "a", "place").value, Lares("Kitchen"));
  EXPECT_THAT(other.plan->notes, Contains(HasSubstr("but this environment is")));
  options.environment_iri = Lares("Kitchen");
  const auto same = Make(recipe, options);
  ASSERT_PLAN(same);
  EXPECT_THAT(same.plan->notes, IsEmpty());
}

TEST(Plan, TheCamerasPoseComesFromTheChainOfJoints) {
  const std::string body = Turtle(
      ":robot a lares:Robot ; lares:succeedingLink :base ; lares:subComponent :rec , :model .\n"
      ":rec a lares:ObjectRecognitionComponent . :model a lares:ObjectRecognitionModel .\n"
      ":base a lares:MobileBase ; lares:urdfName \"base_link\" ; lares:succeedingJoint :j1 .\n"
      ":j1 lares:succeedingLink :neck ; lares:orientation :m1 . :neck lares:succeedingJoint :j2 .\n"
      ":j2 lares:succeedingLink :eye ; lares:orientation :m2 . :eye a lares:Camera .\n"
      ":m1" +
      std::string(kTurned) + ":m2" + kTurned);
  const auto result = Make(Search(), {}, body);
  ASSERT_PLAN(result);
  const Parameter& pose = Input(*result.plan, "look", "camera_pose");
  // (1, 2, 0.5) turned by 90° is (-2, 1, 0.5); plus (1, 2, 0.5).
  EXPECT_EQ(pose.value, "-1 3 1 0 0 1 0");
  EXPECT_EQ(pose.frame, "base_link");
  EXPECT_EQ(pose.source, Parameter::Source::kRobot);
}

TEST(Plan, AColourCameraIsTakenBeforeOthersAndWhatIsLeftOpenIsNoted) {
  const std::string cameras =
      ":robot lares:subComponent :a_depth , :b_ir_eye , :c_eye , :stair .\n"
      ":a_depth a lares:Camera . :b_ir_eye a lares:Camera . :c_eye a lares:Camera .\n"
      ":stair a lares:Camera .\n";
  const auto robot = [&](const std::string& more) {
    return RobotText({"MobileBase", "ObjectRecognitionComponent", "ObjectRecognitionModel"}, {}) +
           cameras + more;
  };
  const auto named = Make(Search(), {}, robot(""));
  ASSERT_PLAN(named);
  EXPECT_EQ(Input(*named.plan, "look", "camera").value, "c_eye");
  EXPECT_THAT(named.plan->notes,
              Contains(AllOf(HasSubstr("'c_eye'"), HasSubstr("is taken and not 'stair'"),
                             HasSubstr("'a_depth'"), HasSubstr("'b_ir_eye'"))));
  EXPECT_THAT(named.plan->notes, Contains(AllOf(HasSubstr("pose of the camera 'c_eye'"),
                                                HasSubstr("cannot be computed"))));
  const auto coloured = Make(Search(), {}, robot(":b_ir_eye a lares:ColorCamera .\n"));
  ASSERT_PLAN(coloured);
  EXPECT_EQ(Input(*coloured.plan, "look", "camera").value, "b_ir_eye");
}

TEST(Plan, AnOptionalInputThatNothingSaysIsNoted) {
  const auto result = Make(PartialOrder({{"a", kGo}}, {}) + kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(result.plan->notes, Contains(HasSubstr("'base_frame' of 'a'")));
}

TEST(Plan, TheLibraryRecipesGivePlansInTheDemonstrationFlat) {
  World world = Catalogue();
  world.PutFile("robot", Source("robots/models/helper.ttl"))
      .PutFile("environment", Source("demo/flat.ttl"))
      .PutFile("search", Source("recipes/library/object-search.ttl"))
      .PutFile("fetch", Source("recipes/library/fetch-drink.ttl"));
  PlanOptions options;
  options.environment = "flat";
  options.set["object"] = "Cup";
  const std::string robot = "https://w3id.org/lares/robots/helper#helper1";
  const auto search = recipes::MakePlan(Engines(), world.view(),
                                        "https://w3id.org/lares/recipes/object-search#ObjectSearch",
                                        robot, options);
  ASSERT_PLAN(search);
  EXPECT_THAT(Ways(*search.plan), Contains("go-to-next-pose exhausted stop-vision +"));
  options.set.clear();
  const auto fetch =
      recipes::MakePlan(Engines(), world.view(),
                        "https://w3id.org/lares/recipes/fetch-drink#FetchDrink", robot, options);
  ASSERT_PLAN(fetch);
  EXPECT_THAT(fetch.plan->unordered, ::testing::SizeIs(2));
  EXPECT_EQ(Input(*fetch.plan, "DriveToDrink", "target_pose_reference_pose").frame, "map");
}

}  // namespace
}  // namespace lares::testing
