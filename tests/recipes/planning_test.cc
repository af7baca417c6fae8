// What plans are asked for with: parameters, other values, steps side by side, what is done
// already.
#include <gmock/gmock.h>

#include "base/error.h"
#include "recipes/skill/skill_template.h"
#include "tests/recipes/world.h"

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
  World world = Catalogue();
  if (!more.empty()) world.Put("more", more);
  world.Put("robot", robot).Put("recipe", recipe);
  return recipes::MakePlan(Engines(), world.view(), Example("Task"), Example("robot"), options);
}

const State& StateOf(const Plan& plan, const std::string& id) {
  static const State kNone;
  for (const State& state : plan.states) {
    if (state.id == id) return state;
  }
  ADD_FAILURE() << "no state " << id;
  return kNone;
}

const Parameter& Input(const Plan& plan, const std::string& id, const std::string& name) {
  static const Parameter kNone;
  for (const Parameter& input : StateOf(plan, id).inputs) {
    if (input.name == name) return input;
  }
  ADD_FAILURE() << id << " has no input " << name;
  return kNone;
}

std::vector<std::string> Ids(const Plan& plan) {
  std::vector<std::string> ids;
  for (const State& state : plan.states) ids.push_back(state.id);
  return ids;
}

#define ASSERT_PLAN(result)                                                 \
  ASSERT_TRUE((result).plan) << ::testing::PrintToString((result).problems) \
                             << ::testing::PrintToString(Labels((result).match.smallest_repair))

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
  EXPECT_THAT(result.plan->assumptions, IsEmpty());  // vision was started
  EXPECT_THAT(result.plan->done, ElementsAre("a"));
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

// -- skill templates --

std::vector<recipes::SkillTemplate> Templates(const std::string& body) {
  World world = Catalogue();
  world.Put("skills", Turtle(body));
  return recipes::FindTemplates(Engines(), world.view(), "skills");
}

std::string ATemplate(const std::string& more,
                      const std::string& outcomes =
                          "lares:skillOutcome [ lares:outcomeName \"succeeded\" ; "
                          "lares:meansResult lares:COMPLETED_OK ] ") {
  return ":T a lares:SkillTemplate ; lares:forAction lares:Waiting ; lares:skillName \"Wait\" ; " +
         more + (more.empty() ? "" : " ; ") + outcomes + ".\n";
}

TEST(SkillTemplates, OursAreSound) {
  const auto all = recipes::FindTemplates(Engines(), Catalogue().view());
  EXPECT_GE(all.size(), 15u);
  for (const auto& each : all) EXPECT_THAT(each.problems, IsEmpty()) << each.iri.label;
}

TEST(SkillTemplates, ASoundOneIsDescribed) {
  const auto found = Templates(ATemplate(
      "lares:retryCount 2 ; lares:timeLimit_s 5 ; lares:notWithComponent lares:Camera ; "
      "lares:precondition \"not busy\" ; lares:skillInput [ lares:parameterName \"for\" ; "
      "lares:parameterType \"number\" ; lares:parameterUnit \"s\" ; "
      "lares:valueFrom [ lares:defaultValue \"1\" ] ]"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].problems, IsEmpty());
  EXPECT_EQ(found[0].skill, "Wait");
  EXPECT_EQ(found[0].retries, "2");
  EXPECT_THAT(found[0].conditions, ElementsAre("for robots without camera"));
  ASSERT_THAT(found[0].inputs, SizeIs(1));
  EXPECT_THAT(found[0].inputs[0].sources, ElementsAre("default: 1"));
}

TEST(SkillTemplates, EachFaultIsNamed) {
  const std::string in = "lares:skillInput [ lares:parameterName \"a\" ; ";
  const std::string from = "lares:valueFrom [ lares:robotFact \"camera\" ]";
  const std::pair<std::string, std::string> faults[] = {
      {ATemplate("lares:needsComponent lares:RGBDCamera ; lares:notWithComponent lares:Camera"),
       "can never apply"},
      {ATemplate(
           "lares:appliesWithProperty lares:toLocation ; lares:notWithProperty lares:toLocation"),
       "can never apply"},
      {ATemplate("", "lares:skillOutcome [ lares:outcomeName \"lost\" ]"),
       "nobody can handle the outcome 'lost'"},
      {ATemplate("", "lares:skillName \"Wait\""), "no outcome but failing"},
      {ATemplate("lares:skillName \"Wait2\""), "names two skills"},
      {ATemplate("lares:retryCount 1000"), "retryCount"},
      {ATemplate("lares:timeLimit_s -1"), "timeLimit_s"},
      {ATemplate("lares:needsLayer \"clouds\""), "needs the layer 'clouds'"},
      {ATemplate("lares:needsComponent :NoClass"), "no class that is known"},
      {ATemplate("lares:claims lares:Cup"), "no kind of component"},
      {ATemplate("lares:precondition \"what (\""), "cannot be read"},
      {ATemplate("lares:precondition \"at(b)\""), "no input or output"},
      {ATemplate("lares:precondition \"at(*)\""), "uses '*'"},
      {ATemplate(in + from + " ; lares:parameterType \"colour\" ]"),
       "'colour', which is not known"},
      {ATemplate(in + from + " ; lares:parameterType \"number\" ; lares:parameterUnit \"ft\" ]"),
       "is in 'ft'"},
      {ATemplate(in + from + " ; lares:parameterType \"pose\" ; lares:parameterUnit \"cm\" ]"),
       "poses are in m"},
      {ATemplate(in + "lares:parameterType \"string\" ]"), "nothing says where 'a' comes from"},
      {ATemplate(in + "lares:valueFrom [ ] ]"), "names nothing"},
      {ATemplate(in + "lares:valueFrom [ lares:robotFact \"mood\" ] ]"), "no robot fact 'mood'"},
      {ATemplate("lares:skillInput [ lares:parameterName \"name\" ; " + from + " ]"),
       "cannot use that name"},
      {ATemplate(in + from + " ] ; " + in + from + " ]"), "two parameters 'a'"},
      {ATemplate("",
                 "lares:skillOutcome [ lares:outcomeName \"succeeded\" ; "
                 "lares:meansResult lares:COMPLETED_OK ; lares:effect \"x\" , \"not x\" ]"),
       "both is so and is not"},
      {":T a lares:SkillTemplate ; lares:skillName \"Wait\" .\n", "serves no action"},
      {":T a lares:SkillTemplate ; lares:skillName \"Wait\" ; lares:forAction lares:Cup .\n",
       "no action that is known"},
      {":T a lares:SkillTemplate ; lares:skillName \"W ait\" ; lares:forAction lares:Waiting .\n",
       "is no identifier"},
  };
  for (const auto& [body, fault] : faults) {
    const auto found = Templates(body);
    ASSERT_THAT(found, SizeIs(1)) << body;
    EXPECT_THAT(found[0].problems, Contains(HasSubstr(fault))) << body;
  }
}

TEST(SkillTemplates, TheBaseDecidesHowToDrive) {
  const std::string recipe = PartialOrder({{"a", kGo}}, {}) + kHere;
  const auto model = [&](const std::string& base) {
    const auto result = Make(recipe, {}, ARobot({base}));
    return result.plan ? Input(*result.plan, "a", "motion_model").value : result.problems.at(0);
  };
  EXPECT_EQ(model("DifferentialBase"), "DiffDrive");
  EXPECT_EQ(model("HolonomicBase"), "Omni");
}

TEST(SkillTemplates, TheEnvironmentDecidesToo) {
  const std::string mine = Turtle(
      ":T a lares:SkillTemplate ; lares:forAction lares:Waiting ; lares:skillName \"WaitOutside\" "
      "; "
      "lares:notInPlace lares:Kitchen ; lares:needsLayer \"octomap\" ; "
      "lares:skillOutcome [ lares:outcomeName \"succeeded\" ; lares:meansResult "
      "lares:COMPLETED_OK ] .\n");
  const std::string recipe = PartialOrder({{"a", "lares:Waiting"}}, {});
  PlanOptions options;
  options.environment = "e";
  options.environment_iri = Lares("LivingRoom");
  const auto plain = Make(recipe, options, ARobot(), mine);
  ASSERT_PLAN(plain);  // no octomap: ours alone applies
  EXPECT_EQ(plain.plan->states[0].skill, "Wait");
  options.layers = {"octomap"};
  EXPECT_THAT(Make(recipe, options, ARobot(), mine).choices, SizeIs(1));
  options.environment_iri = Lares("Kitchen");
  ASSERT_PLAN(Make(recipe, options, ARobot(), mine));
}

}  // namespace
}  // namespace lares::testing
