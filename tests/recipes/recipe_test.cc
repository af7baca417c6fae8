// What FindTasks says about recipes, right and wrong; what FindRobots says about bodies.
#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Task;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kGo = "lares:Translation-LocationChange";
const std::string kLook = "lares:Perceiving";

std::vector<Task> Tasks(const std::string& recipe) {
  World world = Catalogue();
  world.Put("recipe", recipe);
  return recipes::FindTasks(Engines(), world.view(), "recipe");
}

std::vector<std::string> Problems(const std::string& recipe) {
  const auto tasks = Tasks(recipe);
  EXPECT_FALSE(tasks.empty());
  return tasks.empty() ? std::vector<std::string>{} : tasks.front().problems;
}

TEST(Recipe, ASoundStateMachineHasNoProblems) {
  const auto tasks =
      Tasks(StateMachine({{"a", kGo}, {"b", kLook}}, "a", {"b"},
                         {{"a", "COMPLETED_OK", "b"}, {"b", "CONDITION_FALSE", "a"}}));
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_TRUE(tasks.front().state_machine);
  EXPECT_TRUE(tasks.front().top_level);
  EXPECT_THAT(Labels(tasks.front().steps), ElementsAre("a", "b"));
  EXPECT_THAT(tasks.front().problems, IsEmpty());
  EXPECT_THAT(tasks.front().warnings, IsEmpty());
}

TEST(Recipe, RestrictionsCountUntypedNestedAndInEquivalentClasses) {
  const auto tasks = Tasks(Turtle(
      ":Task owl:equivalentClass [ owl:intersectionOf ( lares:PurposefulAction "
      "[ owl:onProperty lares:subAction ; owl:someValuesFrom :a ] "
      "[ owl:intersectionOf ( [ owl:onProperty lares:subAction ; owl:hasValue :b ] ) ] ) ] .\n"
      ":a rdfs:subClassOf " +
      kGo + " . :b rdfs:subClassOf " + kGo + " .\n"));
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_FALSE(tasks.front().state_machine);
  EXPECT_THAT(Labels(tasks.front().steps), ElementsAre("a", "b"));
}

TEST(Recipe, AnInnerRecipeIsNotTopLevel) {
  const auto tasks =
      Tasks(PartialOrder({{"outer", kGo + " , " + Some("lares:subAction", ":in")}}, {}) +
            ":in rdfs:subClassOf " + kGo + " .\n");
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks[0].task.label, "Task");
  EXPECT_TRUE(tasks[0].top_level);
  EXPECT_FALSE(tasks[1].top_level);
}

TEST(Recipe, AClassThatOnlyInheritsStepsIsNoTask) {
  const auto tasks = Tasks(PartialOrder({{"a", kGo}}, {}) + ":Heir rdfs:subClassOf :Task .\n");
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_EQ(tasks.front().task.label, "Task");
}

TEST(Recipe, TwoStartStatesAreRefused) {
  EXPECT_THAT(
      Problems(StateMachine({{"a", kGo}, {"b", kGo}}, "a", {"b"}, {{"a", "COMPLETED_OK", "b"}}) +
               ":Task rdfs:subClassOf " + Has("lares:taskStartState", ":b") + " .\n"),
      ElementsAre(AllOf(HasSubstr("more than one start state"),
                        HasSubstr("'a' <https://example.org/test#a>"),
                        HasSubstr("'b' <https://example.org/test#b>"))));
}

TEST(Recipe, NoStartStateIsRefused) {
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}}, "", {"a"}, {})),
              ElementsAre(HasSubstr("has no start state")));
}

TEST(Recipe, ATransitionToOrFromNowhereIsRefused) {
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}}, "a", {"a"}, {{"a", "CONDITION_TRUE", "gone"}})),
              ElementsAre(AllOf(HasSubstr("'move0' <https://example.org/test#move0> leads to"),
                                HasSubstr("'gone'"), HasSubstr("which is no step"))));
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}}, "a", {"a"}, {{"gone", "COMPLETED_OK", "a"}})),
              ElementsAre(HasSubstr("comes from 'gone'")));
}

TEST(Recipe, ATransitionThatLacksAPartIsRefused) {
  const auto without = [](const MoveText& move) {
    return Problems(StateMachine({{"a", kGo}}, "a", {"a"}, {move}));
  };
  EXPECT_THAT(without({"", "COMPLETED_OK", "a"}), Contains(HasSubstr("(fromState)")));
  EXPECT_THAT(without({"a", "", "a"}), Contains(HasSubstr("(causedBy)")));
  EXPECT_THAT(without({"a", "COMPLETED_OK", ""}), Contains(HasSubstr("(toState)")));
}

TEST(Recipe, TwoWaysOnForOneResultAreRefused) {
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", kGo}, {"c", kGo}}, "a", {"b", "c"},
                                    {{"a", "COMPLETED_OK", "b"}, {"a", "COMPLETED_OK", "c"}})),
              ElementsAre(HasSubstr("leads both to 'b'")));
}

TEST(Recipe, AnUnknownActionIsRefused) {
  const auto problem = HasSubstr("'b' <https://example.org/test#b> is of an unknown kind");
  EXPECT_THAT(Problems(PartialOrder({{"a", kGo}, {"b", ":Juggling"}}, {{"a", "b"}})),
              ElementsAre(AllOf(problem, HasSubstr("a task of another document"))));
  EXPECT_THAT(Problems(PartialOrder({{"a", kGo}, {"b", ":Juggling"}}, {{"a", "b"}}) +
                       ":Juggling rdfs:subClassOf lares:Action .\n"),
              ElementsAre(problem))
      << "an action that only this document knows";
  EXPECT_THAT(Problems(PartialOrder({{"a", kGo}, {"b", ":Juggling"}}, {{"a", "b"}}) +
                       ":Juggling rdfs:subClassOf lares:Reaching .\n"),
              IsEmpty());
}

TEST(Recipe, ACircleOfOrderingConstraintsIsListed) {
  EXPECT_THAT(Problems(PartialOrder({{"a", kGo}, {"b", kGo}, {"c", kGo}, {"d", kGo}},
                                    {{"a", "b"}, {"b", "c"}, {"c", "a"}, {"c", "d"}})),
              ElementsAre(AllOf(HasSubstr("go in a circle: 'a'"), HasSubstr("→ 'b'"),
                                HasSubstr("→ 'c'"), Not(HasSubstr("'d'")))));
}

TEST(Recipe, AStepThatCannotBeReachedIsRefused) {
  EXPECT_THAT(
      Problems(StateMachine({{"a", kGo}, {"island", kGo}}, "a", {"a", "island"}, {})),
      ElementsAre(HasSubstr("'island' <https://example.org/test#island> cannot be reached")));
}

TEST(Recipe, ACycleThatCannotEndIsRefused) {
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", kGo}, {"end", kGo}}, "a", {"end"},
                                    {{"a", "COMPLETED_OK", "b"},
                                     {"b", "COMPLETED_OK", "a"},
                                     {"a", "CONDITION_TRUE", "end"}})),
              IsEmpty());
  EXPECT_THAT(
      Problems(StateMachine({{"a", kGo}, {"b", kGo}, {"c", kGo}, {"end", kGo}}, "a", {"end"},
                            {{"a", "COMPLETED_OK", "end"},
                             {"a", "CONDITION_TRUE", "b"},
                             {"b", "COMPLETED_OK", "c"},
                             {"c", "COMPLETED_OK", "b"}})),
      ElementsAre(AllOf(HasSubstr("from the cycle"), HasSubstr("'b'"), HasSubstr("'c'"))));
}

TEST(Recipe, ACycleWhoseStatedEndAlwaysLeadsOnIsRefused) {
  const std::string machine =
      StateMachine({{"a", kGo}, {"b", "lares:OpeningAGripper"}}, "a", {"b"},
                   {{"a", "COMPLETED_OK", "b"}, {"b", "COMPLETED_OK", "a"}});
  EXPECT_THAT(Problems(machine), ElementsAre(HasSubstr("can be reached from the cycle 'a'")));
  EXPECT_THAT(Tasks(machine).front().warnings, ElementsAre(HasSubstr("'b' <")));
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", kLook}}, "a", {"b"},
                                    {{"a", "COMPLETED_OK", "b"},
                                     {"b", "CONDITION_TRUE", "a"},
                                     {"b", "CONDITION_FALSE", "a"}})),
              ElementsAre(HasSubstr("from the cycle")));
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", "lares:OpeningAGripper"}}, "a", {"b"},
                                    {{"a", "COMPLETED_OK", "b"}, {"b", "COMPLETED_FAILED", "a"}})),
              IsEmpty())
      << "a second attempt";
}

TEST(Recipe, AStatedEndThatIsARecipeAndLeadsOnIsNoEnd) {
  const std::string inner = "lares:PurposefulAction , " + Some("lares:subAction", ":go");
  const std::string go = ":go rdfs:subClassOf " + kGo + " .\n";
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", inner}}, "a", {"b"},
                                    {{"a", "COMPLETED_OK", "b"}, {"b", "COMPLETED_OK", "a"}}) +
                       go),
              ElementsAre(HasSubstr("from the cycle")));
  EXPECT_THAT(Problems(StateMachine({{"a", kGo}, {"b", inner}}, "a", {"b"},
                                    {{"a", "COMPLETED_OK", "b"}, {"b", "COMPLETED_FAILED", "a"}}) +
                       go),
              IsEmpty());
}

TEST(Recipe, AResultThatTheCatalogueDoesNotKnowIsRefused) {
  const std::string machine =
      StateMachine({{"a", kLook}, {"b", kGo}}, "a", {"b"}, {{"a", "CONDITION_TRU", "b"}});
  const auto problem =
      AllOf(HasSubstr("'move0' <https://example.org/test#move0> is caused by 'CONDITION_TRU'"),
            HasSubstr("lares#CONDITION_TRUE>"), HasSubstr("lares#EXHAUSTED>"));
  EXPECT_THAT(Problems(machine), ElementsAre(problem));
  EXPECT_THAT(Problems(machine + "lares:CONDITION_TRU a lares:ActionResult .\n"),
              ElementsAre(problem))
      << "a result that only this document knows";
}

TEST(Recipe, ACycleThatASkillCanRunOutOfIsAccepted) {
  EXPECT_THAT(
      Problems(StateMachine(
          {{"infer", "lares:InferLikelyObjectLocations , " + Has("lares:outputsCreated", ":poses")},
           {"go", kGo + " , " + Has("lares:toLocation", ":poses")}},
          "infer", {}, {{"infer", "COMPLETED_OK", "go"}, {"go", "COMPLETED_OK", "go"}})),
      IsEmpty());
}

TEST(Recipe, ADeadEndIsRefused) {
  EXPECT_THAT(
      Problems(StateMachine({{"a", kGo}, {"dead", kGo}, {"end", kGo}}, "a", {"end"},
                            {{"a", "COMPLETED_OK", "end"}, {"a", "CONDITION_TRUE", "dead"}})),
      ElementsAre(AllOf(HasSubstr("'dead'"), HasSubstr("no transition leaves it"))));
}

TEST(Recipe, ATaskAmongItsOwnStepsIsRefused) {
  const auto problems =
      Problems(PartialOrder({{"a", kGo + " , " + Some("lares:subAction", ":Task")}}, {}));
  EXPECT_THAT(problems, Contains(HasSubstr("is among its own sub-actions")));
}

TEST(Recipe, WithoutStepsItIsRefused) {
  EXPECT_THAT(Problems(StateMachine({}, "", {}, {}) + ":Task rdfs:subClassOf " +
                       Has("lares:orderingConstraints", ":o") + " .\n"),
              ElementsAre(HasSubstr("has no steps")));
}

TEST(Recipe, ConstraintsThatOrderNothingAreNamed) {
  const auto tasks = Tasks(PartialOrder({{"a", kGo}, {"b", kGo}}, {{"a", "b"}, {"a", "gone"}}));
  EXPECT_THAT(tasks.front().problems, IsEmpty());
  EXPECT_THAT(tasks.front().warnings, ElementsAre(HasSubstr("'order1'")));
}

// -- bodies --

std::string Body(const std::string& more) {
  return Turtle(
      ":robot a lares:Robot ; lares:succeedingLink :l0 . :l0 lares:succeedingJoint :j1 . "
      ":j1 lares:succeedingLink :l1 .\n" +
      more);
}

std::string FaultOf(const std::string& robot) {
  World world = Catalogue();
  world.Put("robot", robot);
  try {
    recipes::FindRobots(Engines(), world.view(), "robot");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    return error.what();
  }
  return "";
}

TEST(Robot, IndividualsOfRobotClassesAndThoseThatClaimCapabilitiesAreRobots) {
  World world = Catalogue();
  world.Put("robot", Turtle(":Mine rdfs:subClassOf lares:Robot . :one a :Mine .\n"
                            ":two lares:hasCapability :c ; a :Thing . :c a lares:Capability .\n"
                            ":three a :Thing .\n"));
  EXPECT_THAT(Labels(recipes::FindRobots(Engines(), world.view(), "robot")),
              ElementsAre("one", "two"));
}

TEST(Robot, JointsInACircleAreNamed) {
  EXPECT_EQ(FaultOf(Body("")), "");
  EXPECT_THAT(FaultOf(Body(":l1 lares:succeedingJoint :j2 . :j2 lares:succeedingLink :l0 .\n")),
              AllOf(HasSubstr("in a circle"), HasSubstr("'j1'"), HasSubstr("'j2'")));
}

TEST(Robot, AMatrixEntryThatIsNoFiniteNumberIsNamed) {
  for (const char* entry : {"NaN", "INF", "a lot"}) {
    EXPECT_THAT(
        FaultOf(Body(std::string(":m lares:m12 \"") + entry + "\"^^xsd:double .\n")),
        AllOf(HasSubstr("m12"), HasSubstr("'m' <https://example.org/test#m>"), HasSubstr(entry)));
  }
  EXPECT_EQ(FaultOf(Body(":m lares:m12 \"-1.5E-3\"^^xsd:double .\n")), "");
}

// A matrix whose rows are given; the last row need not be.
std::string Matrix(const std::string& rows) {
  return ":m a lares:RotationMatrix3D ; " + rows + " .\n";
}

TEST(Robot, AMatrixThatIsNoPoseIsNamed) {
  const std::string x = "lares:m00 0.0 ; lares:m01 -1.0 ; lares:m02 0.0 ; lares:m03 2.0 ; ";
  const std::string y = "lares:m10 1.0 ; lares:m11 0.0 ; lares:m12 0.0 ; lares:m13 2.0 ; ";
  const std::string z = "lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 1.0 ; lares:m23 0.5";
  const auto matrix = HasSubstr("matrix 'm' <https://example.org/test#m>");
  EXPECT_EQ(FaultOf(Body(Matrix(x + y + z))), "");
  EXPECT_EQ(FaultOf(Body(Matrix(x + y + z + " ; lares:m22 1.004 ; lares:m22 1.0") +
                         ":n a lares:RotationMatrix3D .\n"))
                .find("'n'"),
            std::string::npos)
      << "a matrix without entries is no pose of anything";
  EXPECT_THAT(FaultOf(Body(Matrix(x + z))),
              AllOf(matrix, HasSubstr("entry m10"), HasSubstr("is missing")));
  EXPECT_THAT(FaultOf(Body(Matrix(x + y + z + " ; lares:m13 3.0"))),
              AllOf(matrix, HasSubstr("entry m13"), HasSubstr("given twice"), HasSubstr("2"),
                    HasSubstr("3")));
  EXPECT_EQ(FaultOf(Body(Matrix(x + y + z + " ; lares:m13 \"2\"^^xsd:double"))), "");
  const std::string scaled = "lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 2.0 ; lares:m23 0.5";
  EXPECT_THAT(FaultOf(Body(Matrix(x + y + scaled))), AllOf(matrix, HasSubstr("no rotation")));
  const std::string mirrored = "lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 -1.0 ; lares:m23 0.5";
  EXPECT_THAT(FaultOf(Body(Matrix(x + y + mirrored))), AllOf(matrix, HasSubstr("no rotation")));
  const std::string huge = "lares:m20 0.0 ; lares:m21 0.0 ; lares:m22 1e300 ; lares:m23 0.5";
  EXPECT_THAT(FaultOf(Body(Matrix(x + y + huge))), HasSubstr("no rotation"));
}

}  // namespace
}  // namespace lares::testing
