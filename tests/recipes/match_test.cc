// The rules of matching on recipes, robots and capabilities of our own.
#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Availability;
using recipes::Finding;
using recipes::MatchReport;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

const std::string kNeeds = "lares:dependsOnCapability";
const std::string kUses = "lares:dependsOnComponent";

// A one-step recipe whose step needs :Skill, with `more` statements about :Skill and the rest.
std::string Needing(const std::string& more) {
  return PartialOrder({{"step", "lares:PurposefulAction , " + Some(kNeeds, ":Skill")}}, {}) +
         ":Skill rdfs:subClassOf lares:Capability .\n" + more;
}

MatchReport Match(const std::string& recipe, const std::string& robot, bool strict = false) {
  World world = Catalogue();
  world.Put("robot", robot).Put("recipe", recipe);
  return recipes::Match(Engines(), world.view(), Example("Task"), Example("robot"), {strict});
}

std::string Robot(const std::string& parts, const std::string& claims = "") {
  return Turtle(":Kind a owl:Class ; rdfs:subClassOf lares:Robot" + claims +
                " .\n:robot a :Kind .\n" + parts);
}
std::string Part(const std::string& name, const std::string& type) {
  return ":robot lares:subComponent :" + name + " . :" + name + " a " + type + " .\n";
}
std::string Claim(const std::string& capability) {
  return " , " + Some("lares:hasCapability", capability);
}

Availability Only(const MatchReport& report) {
  EXPECT_EQ(report.capabilities.size(), 1u);
  return report.capabilities.empty() ? Availability::kMissing
                                     : report.capabilities.front().availability;
}

TEST(Match, ACapabilityIsThereWhenAllThatItDependsOnIs) {
  const auto report = Match(Needing(":Skill rdfs:subClassOf " + Some(kUses, ":Lens") + " , " +
                                    Some(kUses, ":Shutter") + " .\n"),
                            Robot(Part("l", ":Lens") + Part("s", ":Shutter")));
  EXPECT_TRUE(report.feasible);
  EXPECT_EQ(Only(report), Availability::kAvailable);
  EXPECT_FALSE(report.capabilities.front().asserted);
  EXPECT_THAT(report.warnings, IsEmpty());
}

TEST(Match, OneMissingPartIsNamedAndIsTheRepair) {
  const auto report = Match(Needing(":Skill rdfs:subClassOf " + Some(kUses, ":Lens") + " , " +
                                    Some(kUses, ":Shutter") + " .\n"),
                            Robot(Part("l", ":Lens")));
  EXPECT_FALSE(report.feasible);
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Shutter"));
  EXPECT_EQ(report.capabilities.front().explanation, "Skill lacks Shutter");
}

TEST(Match, PartsOfPartsCount) {
  const auto report =
      Match(Needing(":Skill rdfs:subClassOf " + Some(kUses, ":Lens") + " .\n"),
            Robot(Part("head", "lares:HardwareComponent") +
                  ":head lares:subComponent :eye . :eye lares:subComponent :l . :l a :Lens .\n"));
  EXPECT_TRUE(report.feasible);
  EXPECT_THAT(Labels(report.capabilities.front().dependencies.front().provided_by),
              ElementsAre("l"));
}

TEST(Match, AClaimWithoutKnownDependenciesCounts) {
  const auto report = Match(Needing(""), Robot("", Claim(":Skill")));
  EXPECT_TRUE(report.feasible);
  EXPECT_EQ(Only(report), Availability::kAvailable);
  EXPECT_TRUE(report.capabilities.front().asserted);
}

TEST(Match, WithoutKnownDependenciesAndWithoutAClaimItIsMissing) {
  const auto report = Match(Needing(""), Robot(""));
  EXPECT_FALSE(report.feasible);
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Skill"));
}

TEST(Match, AClaimOfASpecialCaseCounts) {
  const auto report =
      Match(Needing(":Special rdfs:subClassOf :Skill .\n"), Robot("", Claim(":Special")));
  EXPECT_TRUE(report.feasible);
  EXPECT_THAT(Labels(report.capabilities.front().provided_by), ElementsAre("Special"));
}

TEST(Match, AClaimByHasValueOrOfTheIndividualCounts) {
  EXPECT_TRUE(
      Match(Needing(":mine a :Skill .\n"), Robot("", " , " + Has("lares:hasCapability", ":mine")))
          .feasible);
  EXPECT_TRUE(
      Match(Needing(""), Robot(":robot lares:hasCapability :mine . :mine a :Skill .\n")).feasible);
}

TEST(Match, ASpecialCaseWhoseDependenciesAreThereCounts) {
  const auto report =
      Match(Needing(":Special rdfs:subClassOf :Skill , " + Some(kUses, ":Lens") + " .\n"),
            Robot(Part("l", ":Lens")));
  EXPECT_TRUE(report.feasible);
  EXPECT_THAT(report.capabilities.front().explanation, HasSubstr("Special, a special case of"));
}

TEST(Match, AClaimAgainstAMissingPartHoldsOnTheMakersWord) {
  const std::string recipe = Needing(":Skill rdfs:subClassOf " + Some(kUses, ":Lens") + " .\n");
  const auto report = Match(recipe, Robot("", Claim(":Skill")));
  EXPECT_TRUE(report.feasible);
  EXPECT_EQ(Only(report), Availability::kOnMakersWord);
  EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("on the maker's word only")));
  const auto strict = Match(recipe, Robot("", Claim(":Skill")), true);
  EXPECT_FALSE(strict.feasible);
  EXPECT_EQ(Only(strict), Availability::kMissing);
  EXPECT_THAT(Labels(strict.smallest_repair), ElementsAre("Lens"));
}

TEST(Match, ACapabilityThatOnlyRestsOnMissingOnesComesWithThem) {
  const std::string recipe =
      PartialOrder({{"one", "lares:PurposefulAction , " + Some(kNeeds, ":Grasp")},
                    {"two", "lares:PurposefulAction , " + Some(kNeeds, ":MoveArm")}},
                   {}) +
      ":Grasp rdfs:subClassOf lares:Capability , " + Some(kNeeds, ":MoveArm") +
      " . :MoveArm rdfs:subClassOf lares:Capability , " + Some(kUses, ":Arm") + " .\n";
  const auto report = Match(recipe, Robot(""));
  ASSERT_EQ(report.capabilities.size(), 2u);
  EXPECT_EQ(report.capabilities[0].what.label, "Grasp");
  EXPECT_EQ(report.capabilities[0].availability, Availability::kDerivable);
  EXPECT_EQ(report.capabilities[1].availability, Availability::kMissing);
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Arm"));
}

TEST(Match, AMissingPartBringsWhatItWorksWith) {
  const std::string recipe =
      Needing(":Skill rdfs:subClassOf " + Some(kUses, ":Controller") +
              " . :Controller rdfs:subClassOf " + Some(kUses, ":Motor") + " .\n");
  EXPECT_THAT(Labels(Match(recipe, Robot("")).smallest_repair),
              UnorderedElementsAre("Controller", "Motor"));
  // A part that is there is not doubted; only a warning says what it usually works with.
  const auto report = Match(recipe, Robot(Part("c", ":Controller")));
  EXPECT_TRUE(report.feasible);
  EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("works with Motor")));
}

TEST(Match, ASpecialPartCoversTheGeneralOne) {
  const auto report = Match(
      Needing(":ColourEye rdfs:subClassOf :Eye . :Skill rdfs:subClassOf " + Some(kUses, ":Eye") +
              " , " + Some(kNeeds, ":Other") + " . :Other rdfs:subClassOf lares:Capability , " +
              Some(kUses, ":ColourEye") + " .\n"),
      Robot(""));
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("ColourEye"));
}

TEST(Match, OfAUnionTheCheapestMemberIsTheRepair) {
  const std::string recipe = Needing(
      ":Skill rdfs:subClassOf " + Some(kUses, "[ a owl:Class ; owl:unionOf ( :Costly :Cheap ) ]") +
      " . :Costly rdfs:subClassOf " + Some(kUses, ":Extra") + " .\n");
  EXPECT_THAT(Labels(Match(recipe, Robot("")).smallest_repair), ElementsAre("Cheap"));
  EXPECT_TRUE(Match(recipe, Robot(Part("c", ":Costly"))).feasible);
}

TEST(Match, SharedPartsMakeTheSmallerRepairTogether) {
  // Each need alone could be met by one part of its own, both together by one.
  const std::string either = "[ a owl:Class ; owl:unionOf ( :A :Shared ) ]";
  const std::string or_else = "[ a owl:Class ; owl:unionOf ( :B :Shared ) ]";
  const auto report = Match(Needing(":Skill rdfs:subClassOf " + Some(kUses, either) + " , " +
                                    Some(kUses, or_else) + " .\n"),
                            Robot(""));
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Shared"));
}

TEST(Match, CirclesOfDependenciesEnd) {
  const std::string circle = ":Skill rdfs:subClassOf " + Some(kNeeds, ":Other") +
                             " . :Other rdfs:subClassOf lares:Capability , " +
                             Some(kNeeds, ":Skill");
  const auto bare = Match(Needing(circle + " .\n"), Robot(""));
  EXPECT_FALSE(bare.feasible) << "two capabilities that only rest on each other";
  EXPECT_THAT(bare.smallest_repair, ::testing::SizeIs(1));
  const auto grounded =
      Match(Needing(circle + " , " + Some(kUses, ":Lens") + " .\n"), Robot(Part("l", ":Lens")));
  EXPECT_TRUE(grounded.feasible);
  const auto missing = Match(Needing(circle + " , " + Some(kUses, ":Lens") + " .\n"), Robot(""));
  EXPECT_THAT(Labels(missing.smallest_repair), ElementsAre("Lens"));
}

TEST(Match, NeedsAreInheritedAndTheChainIsReported) {
  const auto report = Match(
      PartialOrder({{"step", ":Nearer"}}, {}) +
          ":Nearer rdfs:subClassOf :Farther . :Farther rdfs:subClassOf lares:PurposefulAction , " +
          Some(kNeeds, ":Skill") + " . :Skill rdfs:subClassOf lares:Capability .\n",
      Robot("", Claim(":Skill")));
  ASSERT_EQ(report.needs.size(), 1u);
  EXPECT_EQ(report.needs.front().step.label, "step");
  EXPECT_THAT(Labels(report.needs.front().inherited_through),
              ElementsAre("step", "Nearer", "Farther"));
}

TEST(Match, NeedsOfInnerRecipesAndOfTheTaskItselfCount) {
  const std::string recipe =
      PartialOrder({{"outer", "lares:PurposefulAction , " + Some("lares:subAction", ":inner")}},
                   {}) +
      ":inner a owl:Class ; rdfs:subClassOf lares:PurposefulAction , " + Some(kNeeds, ":Deep") +
      " .\n:Task rdfs:subClassOf " + Has(kNeeds, ":Own") +
      " .\n:Deep rdfs:subClassOf lares:Capability . :Own rdfs:subClassOf lares:Capability .\n";
  const auto report = Match(recipe, Robot("", Claim(":Deep")));
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Own"));
  EXPECT_EQ(report.capabilities.size(), 2u);
}

TEST(Match, OnlyTheMostSpecificCapabilityIsReported) {
  const auto report = Match(PartialOrder({{"step", "lares:Translation-LocationChange , " +
                                                       Some(kNeeds, "lares:BodyMotionCapability")}},
                                         {}),
                            RobotText({"MobileBase"}, {}));
  ASSERT_EQ(report.capabilities.size(), 1u);
  EXPECT_EQ(report.capabilities.front().what.iri, Lares("BaseMotionCapability"));
  EXPECT_TRUE(report.feasible);
}

TEST(Match, AStepThatNeedsEitherOfTwoIsMetByOne) {
  const std::string recipe =
      PartialOrder({{"step", "lares:PurposefulAction , " +
                                 Some(kNeeds, "[ a owl:Class ; owl:unionOf ( :Fly :Swim ) ]")}},
                   {}) +
      ":Fly rdfs:subClassOf lares:Capability . :Swim rdfs:subClassOf lares:Capability .\n";
  const auto met = Match(recipe, Robot("", Claim(":Swim")));
  EXPECT_TRUE(met.feasible);
  ASSERT_EQ(met.needs.size(), 1u);
  EXPECT_EQ(met.needs.front().capability.label, "Swim");
  const auto unmet = Match(recipe, Robot(""));
  EXPECT_FALSE(unmet.feasible);
  EXPECT_THAT(unmet.smallest_repair, ::testing::SizeIs(1));
}

TEST(Match, WhatIsNoTaskOrNoRobotIsNotFound) {
  World world = Catalogue();
  world.Put("robot", Robot("")).Put("recipe", Needing(""));
  const auto code = [&](const std::string& task, const std::string& robot) {
    try {
      recipes::Match(Engines(), world.view(), task, robot);
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("is no "));
      return error.code();
    }
    return Code::kInternal;
  };
  EXPECT_EQ(code(Example("step"), Example("robot")), Code::kNotFound);
  EXPECT_EQ(code(Example("Task"), Example("Task")), Code::kNotFound);
  EXPECT_EQ(code(Example("nothing"), Example("robot")), Code::kNotFound);
}

TEST(Match, TheDemonstrationRobotsDoWhatTheirBodiesAllow) {
  World world = Catalogue();
  world.PutFile("search", Source("recipes/library/object-search.ttl"))
      .PutFile("fetch", Source("recipes/library/fetch-drink.ttl"))
      .PutFile("scout", Source("robots/models/scout.ttl"))
      .PutFile("helper", Source("robots/models/helper.ttl"));
  const auto feasible = [&](const std::string& task, const std::string& robot) {
    return recipes::Match(Engines(), world.view(), "https://w3id.org/lares/recipes/" + task,
                          "https://w3id.org/lares/robots/" + robot);
  };
  EXPECT_TRUE(feasible("object-search#ObjectSearch", "scout#scout1").feasible);
  EXPECT_TRUE(feasible("object-search#ObjectSearch", "helper#helper1").feasible);
  EXPECT_TRUE(feasible("fetch-drink#FetchDrink", "helper#helper1").feasible);
  const auto refused = feasible("fetch-drink#FetchDrink", "scout#scout1");
  EXPECT_FALSE(refused.feasible);
  std::vector<std::string> repair;
  for (const auto& part : refused.smallest_repair) repair.push_back(part.iri);
  EXPECT_THAT(repair, UnorderedElementsAre(Lares("ArmComponent"), Lares("ArmMotionController"),
                                           Lares("ManipulationEntity")));
}

}  // namespace
}  // namespace lares::testing
