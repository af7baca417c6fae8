// Requirements in numbers, downloads, and costs of repairs.
#include <gmock/gmock.h>

#include "recipes/match/rank.h"
#include "tests/lares_data.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using recipes::Availability;
using recipes::Finding;
using recipes::MatchOptions;
using recipes::MatchReport;
using recipes::Measure;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string Requires(const std::string& subject, const std::string& part,
                     const std::string& quantity, const std::string& bounds) {
  return subject + " lares:requires [ a lares:NumericRequirement ; lares:ofPart " + part +
         " ; lares:quantity " + quantity + " ; " + bounds + " ] .\n";
}

// A task of one step, which is a :Look.
std::string Looking(const std::string& more) {
  return PartialOrder({{"step", ":Look"}}, {}) +
         ":Look a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n" + more;
}

std::string Robot(const std::string& parts) {
  return Turtle(":Kind a owl:Class ; rdfs:subClassOf lares:Robot .\n:robot a :Kind .\n" + parts);
}
std::string Part(const std::string& name, const std::string& type, const std::string& values = "") {
  return ":robot lares:subComponent :" + name + " . :" + name + " a " + type +
         (values.empty() ? "" : " ; " + values) + " .\n";
}

MatchReport Match(const std::string& recipe, const std::string& robot,
                  const MatchOptions& options = {}) {
  World world = Catalogue();
  world.Put("robot", robot).Put("recipe", recipe);
  return recipes::Match(Engines(), world.view(), Example("Task"), Example("robot"), options);
}

const std::string kRange =
    Requires(":Look", "lares:Camera", "lares:maxRange_m", "lares:atLeast 3.0");

TEST(Requirements, AreMetByAPartThatKeepsThem) {
  const auto report =
      Match(Looking(kRange), Robot(Part("eye", "lares:RGBDCamera", "lares:maxRange_m 4.5")));
  EXPECT_TRUE(report.feasible);
  ASSERT_THAT(report.requirements, SizeIs(1));
  const Finding& finding = report.requirements[0].finding;
  EXPECT_EQ(finding.availability, Availability::kAvailable);
  ASSERT_THAT(finding.measures, SizeIs(1));
  EXPECT_EQ(finding.measures[0].actual, 4.5);
  EXPECT_THAT(Labels(finding.provided_by), ElementsAre("eye"));
  EXPECT_THAT(Labels(report.requirements[0].steps), ElementsAre("step"));
}

TEST(Requirements, AnEndOfTheBoundIsKept) {
  EXPECT_TRUE(
      Match(Looking(kRange), Robot(Part("eye", "lares:Camera", "lares:maxRange_m 3"))).feasible);
}

TEST(Requirements, InsufficientSaysOfWhichPartAndByHowMuch) {
  const auto report =
      Match(Looking(kRange), Robot(Part("near", "lares:Camera", "lares:maxRange_m 1.0") +
                                   Part("far", "lares:RGBDCamera", "lares:maxRange_m \"2.25\"")));
  EXPECT_FALSE(report.feasible);
  const Finding& finding = report.requirements.at(0).finding;
  EXPECT_EQ(finding.availability, Availability::kInsufficient);
  EXPECT_THAT(Labels(finding.provided_by), ElementsAre("far"));
  const Measure& measure = finding.measures.at(0);
  EXPECT_EQ(measure.verdict, Measure::Verdict::kInsufficient);
  EXPECT_EQ(measure.at_least, 3.0);
  EXPECT_EQ(measure.actual, 2.25);
  EXPECT_DOUBLE_EQ(measure.short_by, 0.75);
  EXPECT_DOUBLE_EQ(measure.short_by_percent.value(), 25);
  EXPECT_EQ(measure.unit, "m");
  EXPECT_EQ(finding.explanation,
            "step requires a camera with a max range of at least 3 m; far has 2.25 m, 0.75 m "
            "(25 %) too little");
  ASSERT_THAT(report.repairs, ::testing::Not(IsEmpty()));
  EXPECT_EQ(report.repairs[0].add.at(0).text, "camera with a max range of at least 3 m");
  EXPECT_EQ(report.repairs[0].cost, 10);
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("camera"));
}

TEST(Requirements, TwoOfOneClassOfPartsMustBeMetByTheSamePart) {
  const std::string recipe = Looking(
      kRange + Requires(":Look", "lares:Camera", "lares:imageWidth_px", "lares:atLeast 1000"));
  const std::string far = "lares:maxRange_m 5.0 ; lares:imageWidth_px 640";
  const std::string sharp = "lares:maxRange_m 1.5 ; lares:imageWidth_px 1920";
  const auto apart =
      Match(recipe, Robot(Part("far", "lares:Camera", far) + Part("sharp", "lares:Camera", sharp)));
  EXPECT_FALSE(apart.feasible) << "a camera with range and one with resolution do not add up";
  ASSERT_THAT(apart.requirements, SizeIs(1));
  EXPECT_THAT(apart.requirements[0].finding.measures, SizeIs(2));
  EXPECT_THAT(Labels(apart.requirements[0].finding.provided_by), ElementsAre("far"))
      << "36 % short is better than 50 %";
  EXPECT_THAT(apart.smallest_repair, SizeIs(1));
  EXPECT_THAT(apart.repairs.at(0).add.at(0).bounds, SizeIs(2));
  const auto together = Match(
      recipe, Robot(Part("eye", "lares:Camera", "lares:maxRange_m 5 ; lares:imageWidth_px 1920")));
  EXPECT_TRUE(together.feasible);
}

TEST(Requirements, OfTwoStepsMayBeMetByTwoParts) {
  const std::string recipe =
      PartialOrder({{"one", ":Look"}, {"two", ":Read"}}, {}) +
      ":Look a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n"
      ":Read a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n" +
      kRange + Requires(":Read", "lares:Camera", "lares:imageWidth_px", "lares:atLeast 1000");
  const std::string robot =
      Robot(Part("far", "lares:Camera", "lares:maxRange_m 5.0 ; lares:imageWidth_px 640") +
            Part("sharp", "lares:Camera", "lares:maxRange_m 1.5 ; lares:imageWidth_px 1920"));
  EXPECT_TRUE(Match(recipe, robot).feasible);
  // And one new part serves both where neither is met.
  const auto bare = Match(recipe, Robot(""));
  EXPECT_THAT(Labels(bare.smallest_repair), ElementsAre("camera"));
  EXPECT_EQ(bare.repairs.at(0).add.at(0).bounds.size(), 2U);
}

TEST(Requirements, ThatContradictEachOtherNeedTwoParts) {
  const std::string recipe =
      PartialOrder({{"one", ":Look"}, {"two", ":Read"}}, {}) +
      ":Look a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n"
      ":Read a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n" +
      Requires(":Look", "lares:Camera", "lares:hfov_rad", "lares:atMost 0.5") +
      Requires(":Read", "lares:Camera", "lares:hfov_rad", "lares:atLeast 1.5");
  EXPECT_EQ(Match(recipe, Robot("")).repairs.at(0).cost, 20);
}

TEST(Requirements, AreInheritedDownTheClasses) {
  const std::string recipe = PartialOrder({{"step", ":Peek"}}, {}) +
                             ":Look a owl:Class ; rdfs:subClassOf lares:PurposefulAction .\n"
                             ":Peek a owl:Class ; rdfs:subClassOf :Look .\n" +
                             kRange;
  EXPECT_FALSE(Match(recipe, Robot(Part("eye", "lares:Camera", "lares:maxRange_m 1"))).feasible);
}

TEST(Requirements, WhatTheDescriptionDoesNotGiveIsTakenOnTheMakersWord) {
  const std::string robot = Robot(Part("eye", "lares:Camera"));
  const auto report = Match(Looking(kRange), robot);
  EXPECT_TRUE(report.feasible);
  EXPECT_EQ(report.requirements.at(0).finding.availability, Availability::kOnMakersWord);
  EXPECT_EQ(report.requirements.at(0).finding.measures.at(0).actual, std::nullopt);
  EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("maker's word")));
  MatchOptions strict;
  strict.strict = true;
  EXPECT_FALSE(Match(Looking(kRange), robot, strict).feasible);
}

TEST(Requirements, WithoutAnySuchPartItIsMissing) {
  const auto report = Match(Looking(kRange), Robot(""));
  EXPECT_FALSE(report.feasible);
  EXPECT_EQ(report.requirements.at(0).finding.availability, Availability::kMissing);
}

TEST(Requirements, OfTheRobotAsAWholeLookAtItsOwnNumbers) {
  const std::string recipe =
      Looking(Requires(":Look", "lares:Robot", "lares:footprintRadius_m", "lares:atMost 0.3"));
  EXPECT_TRUE(Match(recipe, Robot(":robot lares:footprintRadius_m 0.25 .\n")).feasible);
  const auto report = Match(recipe, Robot(":robot lares:footprintRadius_m 0.4 .\n"));
  EXPECT_FALSE(report.feasible);
  EXPECT_THAT(report.requirements.at(0).finding.explanation, HasSubstr("0.1 m (33 %) too much"));
  EXPECT_EQ(report.repairs.at(0).cost, 1000);
}

TEST(Requirements, OfACapabilityStandAgainstAClaim) {
  const std::string recipe =
      PartialOrder(
          {{"step", "lares:PurposefulAction , " + Some("lares:dependsOnCapability", ":Reading")}},
          {}) +
      ":Reading a owl:Class ; rdfs:subClassOf lares:Capability .\n" +
      Requires(":Reading", "lares:Camera", "lares:imageWidth_px", "lares:atLeast 1000");
  const std::string claim = ":robot lares:hasCapability :mine . :mine a :Reading .\n";
  const auto report =
      Match(recipe, Robot(claim + Part("eye", "lares:Camera", "lares:imageWidth_px 320")));
  EXPECT_FALSE(report.feasible);
  EXPECT_EQ(report.capabilities.at(0).availability, Availability::kInsufficient);
  EXPECT_TRUE(Match(recipe, Robot(claim + Part("eye", "lares:Camera", "lares:imageWidth_px 2000")))
                  .feasible);
}

TEST(Requirements, OfAComponentHoldForARobotThatHasIt) {
  const std::string recipe =
      PartialOrder(
          {{"step", "lares:PurposefulAction , " + Some("lares:dependsOnComponent", ":Reader")}},
          {}) +
      ":Reader a owl:Class ; rdfs:subClassOf lares:SoftwareComponent .\n" +
      Requires(":Reader", "lares:Camera", "lares:imageWidth_px", "lares:atLeast 1000");
  const std::string reader = Part("r", ":Reader");
  const auto report =
      Match(recipe, Robot(reader + Part("eye", "lares:Camera", "lares:imageWidth_px 320")));
  EXPECT_EQ(report.capabilities.at(0).availability, Availability::kInsufficient);
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("camera"));
  EXPECT_TRUE(Match(recipe, Robot(reader)).feasible) << "a part that is there is not doubted";
}

TEST(Requirements, ThatARobotsOwnDocumentStatesDoNotApply) {
  EXPECT_TRUE(Match(Looking(""), Robot(Requires("lares:PurposefulAction", "lares:Camera",
                                                "lares:maxRange_m", "lares:atLeast 9")))
                  .feasible);
}

TEST(Requirements, OfASkillTemplateDecideWhetherItApplies) {
  // Any template that serves Translation-LocationChange asks for a fast base now.
  const auto result = [](const std::string& speed) {
    World world = Catalogue();
    world.Put("robot",
              Robot(Part("base", "lares:DifferentialBase", "lares:maxSpeed_m_s " + speed)));
    world.Put("fast",
              Turtle(Requires("<https://w3id.org/lares/skills/navigation#MoveToPose>",
                              "lares:MobileBase", "lares:maxSpeed_m_s", "lares:atLeast 0.5")));
    return world;
  };
  const auto holds = [&](const std::string& speed) {
    const World world = result(speed);
    using prolog::Atom;
    using prolog::Value;
    const auto verdicts = Engines().Once(
        world.view(), "requirements", "requirements_met",
        {Value{prolog::Compound{
             "context",
             {Value{Atom{Example("robot")}}, Value{prolog::List{}}, Value{Atom{"false"}}}}},
         Value{Atom{"https://w3id.org/lares/skills/navigation#MoveToPose"}}});
    return verdicts ? verdicts->list().at(0).at("verdict").text() : "";
  };
  EXPECT_EQ(holds("0.8"), "met");
  EXPECT_EQ(holds("0.3"), "insufficient");
}

// -- malformed ones are refused with their place --

std::vector<std::string> Problems(const std::string& statements) {
  World world = Catalogue();
  world.Put("recipe", Looking(statements));
  const auto tasks = recipes::FindTasks(Engines(), world.view(), "recipe");
  EXPECT_EQ(tasks.size(), 1U);
  return tasks.empty() ? std::vector<std::string>{} : tasks[0].problems;
}

TEST(Requirements, WellFormedOnesAreNoProblem) { EXPECT_THAT(Problems(kRange), IsEmpty()); }

TEST(Requirements, MalformedOnesAreRefusedByNameOfWhatRequiresThem) {
  const auto of = [](const std::string& quantity, const std::string& bounds) {
    return Problems(Requires(":Look", "lares:Camera", quantity, bounds));
  };
  const std::string range = "lares:maxRange_m";
  EXPECT_THAT(of(range, "lares:atLeast \"NaN\"^^xsd:double"),
              ElementsAre(HasSubstr("'Look' <https://example.org/test#Look> says atLeast \"NaN\", "
                                    "which is no finite number")));
  EXPECT_THAT(of(range, "lares:atLeast \"INF\"^^xsd:double"),
              ElementsAre(HasSubstr("no finite number")));
  EXPECT_THAT(of(range, "lares:atLeast \"three\""), ElementsAre(HasSubstr("\"three\"")));
  EXPECT_THAT(of(range, "lares:atMost lares:Cup"), ElementsAre(HasSubstr("no finite number")));
  EXPECT_THAT(of(range, "lares:atLeast -2"), ElementsAre(HasSubstr("is not negative")));
  EXPECT_THAT(of(range, "lares:atLeast 1 , 2"), ElementsAre(HasSubstr("twice")));
  EXPECT_THAT(of(range, "lares:atLeast 4 ; lares:atMost 3"),
              ElementsAre(HasSubstr("can never be met: at least 4 and at most 3")));
  EXPECT_THAT(of(range, "rdfs:label \"x\""), ElementsAre(HasSubstr("neither atLeast nor atMost")));
  EXPECT_THAT(of("lares:beamCount", "lares:atLeast 3"),
              ElementsAre(HasSubstr("does not end in a unit")));
  EXPECT_THAT(of("lares:maxRang_m", "lares:atLeast 3"),
              ElementsAre(HasSubstr("no property that the catalogue knows")));
  EXPECT_THAT(Problems(":Look lares:requires 3 .\n"), ElementsAre(HasSubstr("no requirement")));
  EXPECT_THAT(Problems(Requires(":Look", "lares:Cup", range, "lares:atLeast 3")),
              ElementsAre(HasSubstr("no known class of components")));
  EXPECT_THAT(Problems(":Look lares:requires [ lares:quantity lares:maxRange_m ; "
                       "lares:atLeast 3 ] .\n"),
              ElementsAre(HasSubstr("names no part")));
}

// -- downloads --

recipes::Offer ModelFor(const std::string& what) {
  recipes::Offer offer;
  offer.class_iri = Lares("ObjectRecognitionModel");
  offer.for_what = what;
  offer.document = "object-model:" + what;
  return offer;
}

TEST(Downloads, CountAsAvailableAlsoWhereStrict) {
  const std::string recipe = PartialOrder(
      {{"step", "lares:PurposefulAction , " +
                    Some("lares:dependsOnCapability", "lares:ObjectRecognitionCapability")}},
      {});
  const std::string robot = Robot(Part("r", "lares:ObjectRecognitionComponent"));
  EXPECT_FALSE(Match(recipe, robot).feasible);
  for (const bool strict : {false, true}) {
    const auto report = Match(recipe, robot, {strict, {ModelFor("Bottle")}});
    EXPECT_TRUE(report.feasible);
    ASSERT_THAT(report.downloads, SizeIs(1));
    EXPECT_EQ(report.downloads[0].what.iri, Lares("ObjectRecognitionModel"));
    EXPECT_EQ(report.downloads[0].offer.document, "object-model:Bottle");
  }
}

TEST(Downloads, WhatTheRobotHasIsNotDownloaded) {
  const std::string recipe =
      PartialOrder({{"step", "lares:PurposefulAction , " +
                                 Some("lares:dependsOnComponent", "lares:ObjectRecognitionModel")}},
                   {});
  const auto report = Match(recipe, Robot(Part("m", "lares:ObjectRecognitionModel")),
                            {false, {ModelFor("Bottle")}});
  EXPECT_THAT(report.downloads, IsEmpty());
}

TEST(Downloads, AMapOfAKindServesForTheGeneralKind) {
  recipes::Offer map;
  map.class_iri = Lares("OccupancyGridMap");
  map.document = "environment:flat/1";
  const std::string recipe = PartialOrder(
      {{"step", "lares:PurposefulAction , " +
                    Some("lares:dependsOnCapability", "lares:BaseCollisionCheckCapability")}},
      {});
  const auto report = Match(recipe, Robot(""), {false, {map}});
  EXPECT_TRUE(report.feasible);
  EXPECT_EQ(report.capabilities.at(0).dependencies.at(0).availability, Availability::kDownloadable);
}

TEST(Downloads, ABareBodyLacksTheProgramAndGetsTheModel) {
  LARES_REQUIRE_DATA(recipe, "roboearth/recipes/object-search-recipe.owl");
  World world = Catalogue();
  world.Put("robot", Robot(Part("base", "lares:Pr2Base") + Part("eye", "lares:StereoCamera") +
                           Part("scan", "lares:HokuyoUTM-30LX") + Part("arm", "lares:Pr2Arm")));
  world.PutFile("recipe", recipe);
  const auto match = [&](const MatchOptions& options) {
    return recipes::Match(Engines(), world.view(), Lares("FindBottle"), Example("robot"), options);
  };
  const auto bare = match({});
  EXPECT_FALSE(bare.feasible);
  EXPECT_THAT(Labels(bare.smallest_repair),
              ElementsAre("object recognition component", "object recognition model"));
  const auto with = match({false, {ModelFor("Bottle")}});
  EXPECT_FALSE(with.feasible);
  EXPECT_THAT(Labels(with.smallest_repair), ElementsAre("object recognition component"));
  ASSERT_THAT(with.downloads, SizeIs(1));
  EXPECT_EQ(with.downloads[0].what.iri, Lares("ObjectRecognitionModel"));
  const auto needs = recipes::FindNeeds(Engines(), world.view(), Lares("FindBottle"));
  EXPECT_THAT(Labels(needs.sought), ElementsAre("bottle"));
}

// -- costs --

TEST(Costs, AProgramIsAddedRatherThanAnArm) {
  const std::string recipe =
      PartialOrder({{"step", "lares:PurposefulAction , " +
                                 Some("lares:dependsOnComponent",
                                      "[ a owl:Class ; owl:unionOf ( lares:ArmComponent "
                                      ":Program ) ]")}},
                   {}) +
      ":Program a owl:Class ; rdfs:subClassOf lares:SoftwareComponent ,\n  " +
      Some("lares:dependsOnComponent", ":Other") + " , " +
      Some("lares:dependsOnComponent", ":Third") +
      " .\n:Other a owl:Class ; rdfs:subClassOf lares:SoftwareComponent .\n"
      ":Third a owl:Class ; rdfs:subClassOf lares:Sensor .\n";
  const auto report = Match(recipe, Robot(""));
  ASSERT_THAT(report.repairs, SizeIs(2));
  EXPECT_THAT(Labels(report.smallest_repair), ElementsAre("Other", "Program", "Third"));
  EXPECT_EQ(report.repairs[0].cost, 16);
  EXPECT_EQ(report.repairs[1].cost, 100);
  EXPECT_TRUE(report.repair_is_smallest);
}

TEST(Ranking, AbleRobotsComeFirstThenThoseWithTheSmallestChange) {
  World world = Catalogue();
  world.Put("recipe", Looking(kRange));
  const auto needs = recipes::FindNeeds(Engines(), world.view(), Example("Task"));
  const auto rank = [&](const std::string& text) {
    World other = Catalogue();
    other.Put("robot", text);
    // Another dictionary would be another world: the needs are of this one.
    EXPECT_EQ(other.view().shared_dictionary(), world.view().shared_dictionary());
    return recipes::Rank(needs, recipes::DescribeRobot(Engines(), other.view(), Example("robot")));
  };
  const auto able = rank(Robot(Part("eye", "lares:Camera", "lares:maxRange_m 4")));
  const auto unable = rank(Robot(""));
  EXPECT_TRUE(able.feasible);
  EXPECT_EQ(able.cost, 0);
  EXPECT_EQ(unable.cost, 10);
  EXPECT_TRUE(recipes::RanksBefore(able, unable));
  EXPECT_FALSE(recipes::RanksBefore(unable, able));
}

}  // namespace
}  // namespace lares::testing
