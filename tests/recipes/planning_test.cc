// What plans are asked for with: parameters, other values, steps side by side, what is done
// already.
#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/recipes/plan_maker.h"

namespace lares::testing {
namespace {

using recipes::Parameter;
using recipes::Plan;
using recipes::PlanOptions;
using recipes::PlanResult;
using recipes::State;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::string ARobot(const std::vector<std::string>& more = {}) {
  std::vector<std::string> parts = {"MobileBase", "Camera", "ObjectRecognitionComponent",
                                    "ObjectRecognitionModel", "VisualSlamMappingComponent"};
  parts.insert(parts.end(), more.begin(), more.end());
  return RobotText(parts, {"GraspingCapability", "GripperMotionCapability"});
}

// Two skills look for things; the steps of these tests want the one that finds a pose.
void ChooseLocateObject(const std::string& recipe, PlanOptions& options) {
  for (const std::string step : {"a", "b", "c", "look"}) {
    const std::string above = " rdfs:subClassOf lares:Perceiving";
    const bool looks = recipe.find(":" + step + " a owl:Class ;" + above) != std::string::npos ||
                       recipe.find(":" + step + above) != std::string::npos;
    if (!looks) continue;
    options.templates.emplace(Example(step), Lares("LocateObjectTemplate"));
  }
}

PlanResult Make(const std::string& recipe, PlanOptions options = {},
                const std::string& robot = ARobot(), const std::string& more = "") {
  ChooseLocateObject(recipe, options);
  return MakePlanOf(recipe, options, robot, more);
}

const std::string kLookFor = "lares:Perceiving , " + Some("lares:detectedObject", ":object");
const std::string kObject =
    ":object a lares:RecipeParameter , owl:Class ; lares:parameterOf :Task ; "
    "lares:parameterName \"object\" ; lares:parameterType \"class\" ; "
    "lares:valuesBelow lares:PhysicalObject ; lares:parameterProperty lares:objectSought .\n";

PlanOptions Set(const std::map<std::string, std::string>& set) {
  PlanOptions options;
  options.set = set;
  return options;
}

// -- parameters --

TEST(Parameters, AValueThatWasAskedForStandsWhereTheParameterDoes) {
  const auto result = Make(PartialOrder({{"a", kLookFor}}, {}) + kObject, Set({{"object", "cup"}}));
  ASSERT_PLAN(result);
  const Parameter& input = Input(*result.plan, "a", "object_class");
  EXPECT_EQ(input.value, Lares("Cup"));
  EXPECT_EQ(input.source, Parameter::Source::kRequest);
  ASSERT_THAT(result.plan->settings, SizeIs(1));
  EXPECT_EQ(result.plan->settings[0].value, Lares("Cup"));
  EXPECT_FALSE(result.plan->settings[0].is_default);
}

TEST(Parameters, OneWithoutAValueIsAProblemThatSaysHowToGiveIt) {
  const auto result = Make(PartialOrder({{"a", kLookFor}}, {}) + kObject);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("needs a value for 'object'"), HasSubstr("object=…"))));
}

TEST(Parameters, TheRecipesDefaultIsTaken) {
  const auto result = Make(PartialOrder({{"a", kLookFor}}, {}) + kObject +
                           ":object lares:parameterDefault lares:Bottle .\n");
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a", "object_class").value, Lares("Bottle"));
  EXPECT_TRUE(result.plan->settings.at(0).is_default);
}

TEST(Parameters, AValueThatIsNothingOfTheKindIsAProblem) {
  const std::string recipe = PartialOrder({{"a", kLookFor}}, {}) + kObject;
  EXPECT_THAT(Make(recipe, Set({{"object", "Perceiving"}})).problems,
              ElementsAre(HasSubstr("'object' must be a kind of physical object")));
  EXPECT_THAT(Make(recipe, Set({{"object", "no such thing"}})).problems,
              ElementsAre(HasSubstr("'object' must be a class that is known here")));
}

TEST(Parameters, ANameThatNothingHasIsAProblemThatListsThoseThatThereAre) {
  const auto result = Make(PartialOrder({{"a", kLookFor}}, {}) + kObject,
                           Set({{"object", "Cup"}, {"colour", "red"}}));
  EXPECT_THAT(result.problems, ElementsAre(AllOf(HasSubstr("'colour' is no parameter"),
                                                 HasSubstr("object"), HasSubstr("camera"))));
}

TEST(Parameters, ANestedRecipeTakesItsValueFromTheStepThatNestsIt) {
  // The inner recipe's object is what the step seeks, twice with other things.
  const std::string inner =
      ":Inner rdfs:subClassOf lares:PurposefulAction , " + Some("lares:subAction", ":look") +
      " . :look rdfs:subClassOf " + kLookFor +
      " . :object a lares:RecipeParameter , owl:Class ; lares:parameterOf :Inner ; "
      "lares:parameterName \"object\" ; lares:parameterType \"class\" ; "
      "lares:parameterProperty lares:objectSought .\n";
  const auto result =
      Make(PartialOrder({{"a", ":Inner , " + Some("lares:objectSought", "lares:Cup")},
                         {"b", ":Inner , " + Some("lares:objectSought", "lares:Bottle")}},
                        {{"a", "b"}}) +
           inner);
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a--look", "object_class").value, Lares("Cup"));
  EXPECT_EQ(Input(*result.plan, "b--look", "object_class").value, Lares("Bottle"));
}

TEST(Parameters, AnInnerParameterMayStandForAnOuterOne) {
  const std::string inner =
      ":Inner rdfs:subClassOf lares:PurposefulAction , " + Some("lares:subAction", ":look") +
      " . :look rdfs:subClassOf lares:Perceiving , " + Some("lares:detectedObject", ":what") +
      " . :what a lares:RecipeParameter , owl:Class ; lares:parameterOf :Inner ; "
      "lares:parameterName \"what\" ; lares:parameterType \"class\" ; "
      "lares:parameterProperty lares:objectSought .\n";
  const auto result =
      Make(PartialOrder({{"a", ":Inner , " + Some("lares:objectSought", ":object")}}, {}) + inner +
               kObject,
           Set({{"object", "Cup"}}));
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "look", "object_class").value, Lares("Cup"));
}

TEST(Parameters, ARecipeThatNestsItselfByInheritanceIsRefused) {
  World world = Catalogue();
  world.Put("recipe", PartialOrder({{"a", ":Task"}}, {}));
  const auto tasks = recipes::FindTasks(Engines(), world.view(), "recipe");
  ASSERT_FALSE(tasks.empty());
  EXPECT_THAT(tasks[0].problems, Contains(HasSubstr("would never end")));
}

TEST(Parameters, EveryPartOfAListMustBeOfTheKind) {
  const std::string recipe =
      PartialOrder({{"a", "lares:VisitingPlaces , " + Has("lares:toLocation", ":places")}}, {}) +
      ":places a lares:RecipeParameter , lares:Point2D ; lares:parameterOf :Task ; "
      "lares:parameterName \"places\" ; lares:parameterType \"designator_list\" ; "
      "lares:valuesBelow lares:Point2D . :p a lares:Point2D . :q a lares:Cup .\n";
  ASSERT_PLAN(Make(recipe, Set({{"places", "p"}})));
  EXPECT_THAT(Make(recipe, Set({{"places", "p,q"}})).problems,
              ElementsAre(HasSubstr("must be a kind of")));
}

TEST(Parameters, ANameOfSeveralThingsIsNoFaultWhereAClassIsMeant) {
  const std::string things = Turtle(
      ":cup1 a lares:Cup ; rdfs:label \"cup\" . "
      ":cup2 a lares:Cup ; rdfs:label \"cup\" .");
  const std::string recipe = PartialOrder({{"a", kLookFor}}, {}) + kObject;
  const auto result = Make(recipe, Set({{"object", "cup"}}), ARobot(), things);
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a", "object_class").value, Lares("Cup"));
  const std::string to =
      PartialOrder(
          {{"a", "lares:Translation-LocationChange , " + Has("lares:toLocation", ":here")}}, {}) +
      ":here a lares:Point2D .\n";
  EXPECT_THAT(Make(to, Set({{"target_pose", "cup"}}), ARobot(), things).problems,
              ElementsAre(AllOf(HasSubstr("cup1"), HasSubstr("cup2"), HasSubstr("write the IRI"))));
}

// -- other values than the recipe's --

const std::string kCup = "lares:Perceiving , " + Some("lares:detectedObject", "lares:Cup");

TEST(Overrides, AnInputOfThatNameGetsTheOtherValueInEveryStep) {
  const auto result = Make(PartialOrder({{"a", kCup}, {"b", kCup}}, {{"a", "b"}}),
                           Set({{"object_class", "Bottle"}}));
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a", "object_class").value, Lares("Bottle"));
  EXPECT_EQ(Input(*result.plan, "b", "object_class").value, Lares("Bottle"));
  ASSERT_THAT(result.plan->settings, SizeIs(1));
  EXPECT_EQ(result.plan->settings[0].was, "cup");
}

TEST(Overrides, AStepsOwnNameReachesItAlone) {
  const auto result = Make(PartialOrder({{"a", kCup}, {"b", kCup}}, {{"a", "b"}}),
                           Set({{"b.object_class", "Bottle"}}));
  ASSERT_PLAN(result);
  EXPECT_EQ(Input(*result.plan, "a", "object_class").value, Lares("Cup"));
  EXPECT_EQ(Input(*result.plan, "b", "object_class").value, Lares("Bottle"));
}

TEST(Overrides, NumbersAreCheckedWithTheirUnits) {
  const std::string recipe = PartialOrder({{"a", "lares:Waiting"}}, {});
  const auto value = [&](const std::string& text) {
    const auto result = Make(recipe, Set({{"duration_s", text}}));
    return result.plan ? Input(*result.plan, "a", "duration_s").value : result.problems.at(0);
  };
  EXPECT_EQ(value("2.5"), "2.5");
  EXPECT_EQ(value("2.5 s"), "2.5");
  EXPECT_THAT(value("2.5 min"), HasSubstr("a finite number in s"));
  EXPECT_THAT(value("nan"), HasSubstr("a finite number in s"));
  EXPECT_THAT(value("1e999"), HasSubstr("a finite number in s"));
  EXPECT_EQ(value(".5"), ".5");
  for (const char* of_prolog : {"0x10", "1_000", "0'a", "1r3"}) {
    EXPECT_THAT(value(of_prolog), HasSubstr("a finite number in s"));
  }
}

TEST(Overrides, APlaceMayBeAPose) {
  const std::string recipe =
      PartialOrder(
          {{"a", "lares:Translation-LocationChange , " + Has("lares:toLocation", ":here")}}, {}) +
      ":here a lares:Point2D .\n";
  const auto result = Make(recipe, Set({{"target_pose", "1 2 3.14159265"}}));
  ASSERT_PLAN(result);
  const Parameter& pose = Input(*result.plan, "a", "target_pose");
  EXPECT_EQ(pose.type, "pose");
  EXPECT_EQ(pose.frame, "map");
  EXPECT_THAT(pose.value, HasSubstr("1 2 0 0 0 1"));
  EXPECT_THAT(Make(recipe, Set({{"target_pose", "1 2"}})).problems,
              ElementsAre(HasSubstr("'target_pose' must be a thing of the environment or a pose")));
}

// -- side by side --

const std::string kOpen = "lares:OpeningAGripper";
const std::string kGo = "lares:Translation-LocationChange , " + Has("lares:toLocation", ":here");
const std::string kHere = ":here a lares:Point2D .\n";

TEST(SideBySide, WhatTheRecipeLeavesUnorderedRunsTogether) {
  const auto result = Make(PartialOrder({{"go", kGo}, {"open", kOpen}, {"look", kCup}},
                                        {{"go", "look"}, {"open", "look"}}) +
                           kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan),
              ElementsAre("parallel-1", "go", "open", "look", "succeeded", "failed"));
  EXPECT_THAT(StateOf(*result.plan, "parallel-1").members, ElementsAre("go", "open"));
  EXPECT_EQ(StateOf(*result.plan, "open").parallel, "parallel-1");
  EXPECT_EQ(result.plan->start, "parallel-1");
}

TEST(SideBySide, OneBaseIsNotClaimedTwice) {
  const auto result = Make(PartialOrder({{"a", kGo}, {"b", kGo}}, {}) + kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), ElementsAre("a", "b", "succeeded", "failed"));
}

TEST(SideBySide, StepsThatChangeTheSameThingDoNotRunTogether) {
  const auto result = Make(PartialOrder({{"a", kOpen}, {"b", "lares:ClosingAGripper"}}, {}));
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), Not(Contains("parallel-1")));
}

TEST(SideBySide, WhatIsOrderedStaysSo) {
  const auto result = Make(PartialOrder({{"go", kGo}, {"open", kOpen}}, {{"go", "open"}}) + kHere);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), ElementsAre("go", "open", "succeeded", "failed"));
}

TEST(SideBySide, TwoNestingsOfOneRecipeKeepTheirOrder) {
  // Inside each, a and b are unordered; of the two nestings the first comes first.
  const std::string inner =
      ":Inner rdfs:subClassOf lares:PurposefulAction , " + Some("lares:subAction", ":say") + " , " +
      Some("lares:subAction", ":wait") + " . :say rdfs:subClassOf lares:Speaking , " +
      Has("lares:textSpoken", "\"now\"") + " . :wait rdfs:subClassOf lares:Waiting .\n";
  const auto result =
      Make(PartialOrder({{"n1", ":Inner"}, {"n2", ":Inner"}}, {{"n1", "n2"}}) + inner);
  ASSERT_PLAN(result);
  EXPECT_THAT(StateOf(*result.plan, "parallel-1").members, ElementsAre("n1--say", "n1--wait"));
  EXPECT_THAT(StateOf(*result.plan, "parallel-2").members, ElementsAre("n2--say", "n2--wait"));
}

TEST(SideBySide, WhoAsksForARowGetsOne) {
  PlanOptions options;
  options.sequential = true;
  const auto result = Make(PartialOrder({{"go", kGo}, {"open", kOpen}}, {}) + kHere, options);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), ElementsAre("go", "open", "succeeded", "failed"));
}

// -- conditions --

TEST(Conditions, ASearchAfterVisionWasStoppedIsRefusedWithTheWay) {
  const auto result =
      Make(PartialOrder({{"a", "lares:StopVisionModules"}, {"b", kCup}}, {{"a", "b"}}));
  EXPECT_FALSE(result.plan);
  EXPECT_THAT(result.problems,
              ElementsAre(AllOf(HasSubstr("'b' needs vision_running"), HasSubstr("a → b"))));
}

TEST(Conditions, WhatIsAssumedIsSaid) {
  const auto result = Make(PartialOrder({{"b", kCup}}, {}));
  ASSERT_PLAN(result);
  ASSERT_THAT(result.plan->assumptions, SizeIs(1));
  EXPECT_EQ(ToText(result.plan->assumptions[0]), "vision_running");
}

TEST(Conditions, WhatEndsForAnyEndsBeforeSomethingNewBegins) {
  const auto result = Make(PartialOrder({{"a", kGo}}, {}) + kHere);
  ASSERT_PLAN(result);
  std::vector<std::string> effects;
  for (const auto& effect : StateOf(*result.plan, "a").effects) {
    if (effect.outcome == "succeeded") effects.push_back(ToText(effect.fluent));
  }
  EXPECT_THAT(effects, ElementsAre("not at(*)", "at(here)"));
}

// -- made anew --

std::string Three() {
  return PartialOrder({{"a", "lares:StartVisionModules"}, {"b", kGo}, {"c", kCup}},
                      {{"a", "b"}, {"b", "c"}}) +
         kHere;
}

TEST(MadeAnew, WhatIsDoneIsLeftOutAndStillCounts) {
  PlanOptions options;
  options.done = {"a"};
  const auto result = Make(Three(), options);
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->start, "b");
  EXPECT_THAT(Ids(*result.plan), ElementsAre("b", "c", "succeeded", "failed"));
  ASSERT_THAT(result.plan->assumptions, SizeIs(1));  // what was started must run on
  EXPECT_EQ(ToText(result.plan->assumptions[0]), "vision_running");
  EXPECT_THAT(result.plan->done, ElementsAre("a"));
}

TEST(MadeAnew, WhatWasDoneOutOfOrderIsPassedOver) {
  const std::string recipe = PartialOrder({{"go", kGo}, {"open", kOpen}}, {}) + kHere;
  PlanOptions options;
  options.done = {"open"};
  const auto result = Make(recipe, options);
  ASSERT_PLAN(result);
  EXPECT_THAT(Ids(*result.plan), ElementsAre("go", "succeeded", "failed"));
}

TEST(MadeAnew, TheOrderOfThePlanCountsAndNotThatOfTheRequest) {
  const std::string recipe = PartialOrder(
      {{"a", "lares:StartVisionModules"}, {"b", "lares:StopVisionModules"}, {"c", kCup}},
      {{"a", "b"}, {"b", "c"}});
  for (const auto& done : {std::vector<std::string>{"a", "b"}, {"b", "a"}}) {
    PlanOptions options;
    options.done = done;
    EXPECT_THAT(Make(recipe, options).problems,
                ElementsAre(HasSubstr("which is not so after what is done")));
  }
}

TEST(MadeAnew, WhatLiesOnALoopIsDoneAgain) {
  const std::string recipe =
      StateMachine({{"go", kGo}, {"look", "lares:CheckingWhetherConditionObtains , " + kCup}}, "go",
                   {"look"}, {{"go", "COMPLETED_OK", "look"}, {"look", "CONDITION_FALSE", "go"}}) +
      kHere;
  PlanOptions options;
  options.done = {"go"};
  const auto result = Make(recipe, options);
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->start, "look");
  EXPECT_THAT(Ids(*result.plan), Contains("go"));
}

TEST(MadeAnew, ItCanBeginAnywhere) {
  PlanOptions options;
  options.from = "c";
  const auto result = Make(Three(), options);
  ASSERT_PLAN(result);
  EXPECT_EQ(result.plan->start, "c");
  EXPECT_THAT(result.plan->assumptions, SizeIs(1));
}

TEST(MadeAnew, WhatADoneStepCreatedIsGiven) {
  const std::string recipe = StateMachine(
      {{"infer", "lares:InferLikelyObjectLocations , " + Some("lares:objectActedOn", "lares:Cup") +
                     " , " + Has("lares:outputsCreated", ":poses")},
       {"next", "lares:Translation-LocationChange , " + Has("lares:toLocation", ":poses")}},
      "infer", {"next"}, {{"infer", "COMPLETED_OK", "next"}});
  PlanOptions options;
  options.from = "next";
  EXPECT_THAT(Make(recipe, options).problems, ElementsAre(HasSubstr("which no step creates")));
  options.done = {"infer"};
  const auto result = Make(recipe, options);
  ASSERT_PLAN(result);
  EXPECT_THAT(result.plan->given, ElementsAre("poses"));
}

TEST(MadeAnew, AnUnknownStepIsNamed) {
  PlanOptions options;
  options.done = {"nothing"};
  EXPECT_THROW(Make(Three(), options), Error);
}

TEST(MadeAnew, WhenAllIsDoneThereIsNoPlan) {
  PlanOptions options;
  options.done = {"a", "b", "c"};
  try {
    Make(Three(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nothing is left to do"));
  }
}

// -- where a recipe says that the task has failed --

TEST(TaskFailed, ATransitionThereEndsThePlanWithoutSuccess) {
  const std::string recipe =
      StateMachine({{"look", "lares:CheckingWhetherConditionObtains , " + kCup}, {"go", kGo}},
                   "look", {"go"}, {{"look", "CONDITION_TRUE", "go"}}) +
      kHere + ":Task rdfs:subClassOf " + Has("lares:stateTransition", ":no") +
      " . :no lares:fromState :look ; lares:causedBy lares:CONDITION_FALSE ; "
      "lares:toState lares:TaskFailed .\n";
  const auto result = Make(recipe);
  ASSERT_PLAN(result);
  bool found = false;
  for (const auto& transition : result.plan->transitions) {
    if (transition.from != "look" || transition.outcome != "false") continue;
    found = true;
    EXPECT_EQ(transition.to, "failed");
    EXPECT_FALSE(transition.added);
  }
  EXPECT_TRUE(found);
}

std::string To(const Plan& plan, const std::string& from, const std::string& outcome) {
  for (const auto& transition : plan.transitions) {
    if (transition.from == from && transition.outcome == outcome) return transition.to;
  }
  return "";
}

// ":Inner" says that it has failed when nothing is seen.
const std::string kInner =
    ":Inner rdfs:subClassOf lares:PurposefulAction , " + Some("lares:subAction", ":look") + " , " +
    Some("lares:subAction", ":use") + " , " + Has("lares:taskStartState", ":look") + " , " +
    Has("lares:taskEndState", ":use") + " , " + Has("lares:stateTransition", ":seen") + " , " +
    Has("lares:stateTransition", ":unseen") +
    " . :look rdfs:subClassOf lares:CheckingWhetherConditionObtains , " + kCup +
    " . :use rdfs:subClassOf lares:Waiting . "
    ":seen lares:fromState :look ; lares:causedBy lares:CONDITION_TRUE ; lares:toState :use . "
    ":unseen lares:fromState :look ; lares:causedBy lares:CONDITION_FALSE ; "
    "lares:toState lares:TaskFailed .\n";

TEST(TaskFailed, OfANestedRecipeItLeadsWhereTheOuterOneSays) {
  const auto result = Make(
      StateMachine({{"inner", ":Inner"}, {"home", kGo}, {"help", "lares:Waiting"}}, "inner",
                   {"home", "help"},
                   {{"inner", "COMPLETED_OK", "home"}, {"inner", "COMPLETED_FAILED", "help"}}) +
      kHere + kInner);
  ASSERT_PLAN(result);
  EXPECT_EQ(To(*result.plan, "look", "false"), "help");
  EXPECT_EQ(To(*result.plan, "look", "failed"), "help") << "no exit of the inner recipe";
  EXPECT_EQ(To(*result.plan, "use", "failed"), "help");
  EXPECT_EQ(To(*result.plan, "use", "succeeded"), "home");
}

TEST(TaskFailed, OfANestedRecipeItIsTheEndWhereTheOuterOneSaysNothing) {
  const auto result = Make(PartialOrder({{"inner", ":Inner"}}, {}) + kInner);
  ASSERT_PLAN(result);
  EXPECT_EQ(To(*result.plan, "look", "false"), "failed");
}

TEST(TaskFailed, ForTheResultOfANestedRecipesLastStep) {
  const std::string check =
      ":Check rdfs:subClassOf lares:PurposefulAction , " + Some("lares:subAction", ":look") +
      " . :look rdfs:subClassOf lares:CheckingWhetherConditionObtains , " + kCup + " .\n";
  const auto result =
      Make(StateMachine({{"check", ":Check"}, {"home", kGo}}, "check", {"home"},
                        {{"check", "CONDITION_TRUE", "home"}}) +
           kHere + check + ":Task rdfs:subClassOf " + Has("lares:stateTransition", ":no") +
           " . :no lares:fromState :check ; lares:causedBy lares:CONDITION_FALSE ; "
           "lares:toState lares:TaskFailed .\n");
  ASSERT_PLAN(result);
  EXPECT_EQ(To(*result.plan, "look", "true"), "home");
  EXPECT_EQ(To(*result.plan, "look", "false"), "failed");
}

TEST(Choices, AnAnswerForNoStepIsNamed) {
  PlanOptions options;
  options.templates["lok"] = "LocateObject";
  EXPECT_THAT(Make(PartialOrder({{"a", kCup}}, {}), options).problems,
              ElementsAre(HasSubstr("there is no step 'lok'")));
}

// -- the library --

struct LibraryTask {
  const char* recipe;
  const char* task;
  std::map<std::string, std::string> set;
};

TEST(Library, EveryRecipeGivesAPlanToTheHelper) {
  const LibraryTask tasks[] = {
      {"semantic-mapping", "SemanticMapping", {{"environment_type", "Kitchen"}}},
      {"object-search", "ObjectSearch", {{"object", "Cup"}}},
      {"fetch-and-serve", "FetchAndServe", {{"object", "Cup"}, {"to", "sofa"}}},
      {"fetch-drink", "FetchDrink", {}},
      {"patrol", "Patrol", {{"places", "sofa, bottle"}}}};
  for (const LibraryTask& task : tasks) {
    World world = Catalogue();
    world.PutFile("robot", Source("robots/models/helper.ttl"))
        .PutFile("environment", Source("demo/flat.ttl"))
        .PutFile("recipe", Source(std::string("recipes/library/") + task.recipe + ".ttl"));
    PlanOptions options = Set(task.set);
    options.environment = "flat";
    const auto result = recipes::MakePlan(
        Engines(), world.view(),
        std::string("https://w3id.org/lares/recipes/") + task.recipe + "#" + task.task,
        "https://w3id.org/lares/robots/helper#helper1", options);
    EXPECT_TRUE(result.plan) << task.task << ::testing::PrintToString(result.problems)
                             << ::testing::PrintToString(Labels(result.match.smallest_repair));
  }
}

TEST(Library, NothingFoundIsNoSuccessOfFetchAndServe) {
  World world = Catalogue();
  world.PutFile("robot", Source("robots/models/helper.ttl"))
      .PutFile("recipe", Source("recipes/library/fetch-and-serve.ttl"));
  const auto result = recipes::MakePlan(
      Engines(), world.view(), "https://w3id.org/lares/recipes/fetch-and-serve#FetchAndServe",
      "https://w3id.org/lares/robots/helper#helper1", Set({{"object", "Cup"}, {"to", "1 2 0"}}));
  ASSERT_PLAN(result);
  for (const auto& transition : result.plan->transitions) {
    if (transition.outcome != "exhausted") continue;
    EXPECT_EQ(transition.to, "failed");
  }
}

}  // namespace
}  // namespace lares::testing
