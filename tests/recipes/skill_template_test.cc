// What skill templates say, what is wrong with them, and when they apply.
#include "recipes/skill/skill_template.h"

#include <gmock/gmock.h>

#include "tests/recipes/plan_maker.h"

namespace lares::testing {
namespace {

using recipes::PlanOptions;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kGo = "lares:Translation-LocationChange , " + Has("lares:toLocation", ":here");
const std::string kHere = ":here a lares:Point2D .\n";

std::string ARobot(const std::string& base = "MobileBase") { return RobotText({base}, {}); }

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
      {ATemplate("lares:retryCount \"0x10\""), "retryCount"},
      {ATemplate("lares:retryCount 1 , 2"), "states retry count more than once"},
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
    const auto result = MakePlanOf(recipe, {}, ARobot(base));
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
  const auto plain = MakePlanOf(recipe, options, ARobot(), mine);
  ASSERT_PLAN(plain);  // no octomap: ours alone applies
  EXPECT_EQ(plain.plan->states[0].skill, "Wait");
  options.layers = {"octomap"};
  EXPECT_THAT(MakePlanOf(recipe, options, ARobot(), mine).choices, SizeIs(1));
  options.environment_iri = Lares("Kitchen");
  ASSERT_PLAN(MakePlanOf(recipe, options, ARobot(), mine));
}

}  // namespace
}  // namespace lares::testing
