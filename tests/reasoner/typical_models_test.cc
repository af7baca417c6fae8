// Which models are worth loading: numbers by hand, budgets, robots.
#include "reasoner/models/typical_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/recipes/world.h"

namespace lares::models {
namespace {

using lares::testing::Engines;
using lares::testing::Example;
using lares::testing::Lares;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// 12 things in hospital rooms (6 beds, 4 bottles of two kinds, 2 cups), 8 cups in kitchens. V = 5.
places::PriorTable Table() {
  return {"small",
          "",
          {{Lares("Bed"), Lares("HospitalRoom"), 6, ""},
           {Lares("Bottle"), Lares("HospitalRoom"), 1, ""},
           {Lares("DrinkingBottle"), Lares("HospitalRoom"), 3, ""},
           {Lares("Cup"), Lares("HospitalRoom"), 2, ""},
           {Lares("Cup"), Lares("Kitchen"), 8, ""},
           {Lares("Skillet"), Lares("Kitchen"), 0, ""}}};
}

Candidate ModelOf(const std::string& id, const std::string& local, std::uint64_t size_bytes = 10) {
  return {id, {{Lares(local), {}}}, {}, size_bytes};
}

TypicalOptions For(const std::string& room) {
  TypicalOptions options;
  options.room_iri = Lares(room);
  return options;
}

TypicalChoice Choose(const std::vector<Candidate>& candidates, const TypicalOptions& options,
                     const rdf::View& view = lares::testing::Catalogue().view()) {
  return ChooseTypical(Engines(), view, Table(), candidates, options);
}

std::vector<std::string> Ids(const std::vector<Choice>& choices) {
  std::vector<std::string> ids;
  for (const Choice& choice : choices) ids.push_back(choice.id);
  return ids;
}

std::vector<Verdict> Verdicts(const std::vector<Choice>& choices) {
  std::vector<Verdict> verdicts;
  for (const Choice& choice : choices) verdicts.push_back(choice.verdict);
  return verdicts;
}

TEST(TypicalModelsTest, ProbabilitiesByHand) {
  const auto choice =
      Choose({ModelOf("cup", "Cup"), ModelOf("bottle", "Bottle"), ModelOf("bed", "Bed")},
             For("HospitalRoom"));
  ASSERT_THAT(Ids(choice.loaded), ElementsAre("bed", "bottle", "cup"));
  EXPECT_THAT(choice.places, ElementsAre(Lares("HospitalRoom")));
  EXPECT_THAT(choice.loaded[0].probability, DoubleNear(6.5 / 14.5, 1e-12));
  EXPECT_THAT(choice.loaded[1].probability, DoubleNear(4.5 / 14.5, 1e-12));  // both kinds
  EXPECT_THAT(choice.loaded[2].probability, DoubleNear(2.5 / 14.5, 1e-12));
  EXPECT_THAT(choice.loaded[0].probability_of_room, DoubleNear(1, 1e-12));
  EXPECT_THAT(choice.loaded[2].probability_of_room, DoubleNear(0.2, 1e-12));
  EXPECT_EQ(choice.size_bytes, 30U);
  EXPECT_THAT(choice.loaded[0].why, HasSubstr("44.8 % of the things in hospital room"));
}

TEST(TypicalModelsTest, WhatIsNotCountedThereIsLeftOut) {
  const auto choice =
      Choose({ModelOf("pan", "Skillet"), ModelOf("cup", "Cup")}, For("HospitalRoom"));
  EXPECT_THAT(Ids(choice.loaded), ElementsAre("cup"));
  ASSERT_THAT(Verdicts(choice.left_out), ElementsAre(Verdict::kNotTypical));
  EXPECT_THAT(choice.left_out[0].why, HasSubstr("nothing says"));
  EXPECT_THAT(Choose({ModelOf("cup", "Cup")}, For("Tunnel")).loaded, IsEmpty());
}

TEST(TypicalModelsTest, AClassWithoutRowsTakesThoseOfTheNearestAbove) {
  Candidate ours{"ours", {{Example("OurBed"), {Lares("Bed")}}}, {}, 10};
  const auto choice = Choose({ModelOf("wine", "WineBottle"), ours}, For("HospitalRoom"));
  ASSERT_THAT(Ids(choice.loaded), ElementsAre("ours", "wine"));
  EXPECT_THAT(choice.loaded[0].counted, ElementsAre(Lares("Bed")));
  EXPECT_TRUE(choice.loaded[0].counted_above);
  EXPECT_THAT(choice.loaded[0].why, HasSubstr("a kind of bed"));
  EXPECT_THAT(choice.loaded[1].probability, DoubleNear(1.5 / 14.5, 1e-12));  // of Bottle alone
}

TEST(TypicalModelsTest, TheMostProbableClassOfAModelCounts) {
  Candidate both = ModelOf("both", "Cup");
  both.kinds.push_back({Lares("Bed"), {}});
  const auto choice = Choose({both}, For("HospitalRoom"));
  EXPECT_EQ(choice.loaded[0].class_iri, Lares("Bed"));
}

TEST(TypicalModelsTest, ABudgetOfModelsCoversTheClassesFirst) {
  TypicalOptions options = For("HospitalRoom");
  options.max_models = 3;
  const auto choice = Choose({ModelOf("bed-large", "Bed", 90), ModelOf("bed-small", "Bed", 10),
                              ModelOf("cup", "Cup"), ModelOf("bottle", "Bottle")},
                             options);
  EXPECT_THAT(Ids(choice.loaded), ElementsAre("bed-small", "bottle", "cup"));
  EXPECT_THAT(Verdicts(choice.left_out), ElementsAre(Verdict::kTooMany));
  EXPECT_EQ(choice.left_out[0].nth_of_its_class, 2U);
}

TEST(TypicalModelsTest, ABudgetOfBytesPassesOverWhatDoesNotFit) {
  TypicalOptions options = For("HospitalRoom");
  options.max_bytes = 25;
  const auto choice =
      Choose({ModelOf("bed", "Bed", 20), ModelOf("bottle", "Bottle", 6), ModelOf("cup", "Cup", 5)},
             options);
  EXPECT_THAT(Ids(choice.loaded), ElementsAre("bed", "cup"));
  EXPECT_EQ(choice.size_bytes, 25U);
  EXPECT_THAT(Verdicts(choice.left_out), ElementsAre(Verdict::kTooLarge));
  EXPECT_THAT(choice.left_out[0].why, HasSubstr("its 6 bytes do not fit into the 5"));
  options.max_bytes = 0;
  options.max_models = 0;
  EXPECT_THAT(Choose({ModelOf("bed", "Bed")}, options).loaded, IsEmpty());
}

TEST(TypicalModelsTest, RarerThanAskedForIsLeftOut) {
  TypicalOptions options = For("HospitalRoom");
  options.min_probability = 0.3;
  const auto choice = Choose({ModelOf("bed", "Bed"), ModelOf("cup", "Cup")}, options);
  EXPECT_THAT(Ids(choice.loaded), ElementsAre("bed"));
  EXPECT_THAT(Verdicts(choice.left_out), ElementsAre(Verdict::kTooRare));
}

TEST(TypicalModelsTest, ARobotGetsWhatItsProgramsCanUse) {
  lares::testing::World world;
  world.Put("robot", lares::testing::RobotText({"SURFbasedObjectRecognition"}, {}));
  Candidate surf = ModelOf("surf", "Bed");
  surf.algorithms = {{Lares("SURFbasedObjectRecognition"), {Lares("SURFbasedObjectRecognition")}}};
  Candidate sift = ModelOf("sift", "Bed");
  sift.algorithms = {{Lares("SIFTbasedObjectRecognition"), {Lares("SIFTbasedObjectRecognition")}}};
  Candidate either = sift;
  either.id = "either";
  either.algorithms.push_back(surf.algorithms.front());
  TypicalOptions options = For("HospitalRoom");
  options.robot_iri = Example("robot");
  const auto choice =
      Choose({surf, sift, either, ModelOf("unstated", "Cup")}, options, world.view());
  EXPECT_THAT(Ids(choice.loaded), ElementsAre("either", "unstated", "surf"));
  EXPECT_EQ(choice.loaded[2].robot_has, Lares("SURFbasedObjectRecognition"));
  ASSERT_THAT(Verdicts(choice.left_out), ElementsAre(Verdict::kRobotLacks));
  EXPECT_THAT(choice.left_out[0].why, HasSubstr("has no SIFT object recognition"));
}

TEST(TypicalModelsTest, ARobotDescribedInGeneralTermsIsTrustedUnlessStrict) {
  lares::testing::World world;
  world.Put("robot", lares::testing::RobotText({"ObjectRecognitionComponent"}, {}));
  Candidate surf = ModelOf("surf", "Bed");
  surf.algorithms = {{Lares("SURFbasedObjectRecognition"), {Lares("SURFbasedObjectRecognition")}}};
  TypicalOptions options = For("HospitalRoom");
  options.robot_iri = Example("robot");
  const auto trusted = Choose({surf}, options, world.view());
  ASSERT_THAT(Ids(trusted.loaded), ElementsAre("surf"));
  EXPECT_THAT(trusted.loaded[0].why, HasSubstr("of which it is not said whether"));
  options.strict = true;
  const auto strict = Choose({surf}, options, world.view());
  EXPECT_THAT(strict.loaded, IsEmpty());
  EXPECT_THAT(Verdicts(strict.left_out), ElementsAre(Verdict::kRobotLacks));
}

TEST(TypicalModelsTest, OptionsThatMakeNoSenseAreRefused) {
  TypicalOptions options = For("HospitalRoom");
  options.min_probability = 1.5;
  EXPECT_THROW(Choose({}, options), Error);
  options = For("HospitalRoom");
  options.lambda = 0;
  EXPECT_THROW(Choose({}, options), Error);
  EXPECT_THROW(Choose({}, {}), Error);
}

TEST(TypicalModelsTest, TenThousandModelsAreJudgedInOneGo) {
  std::vector<Candidate> many;
  for (int i = 0; i < 10'000; ++i) {
    many.push_back(ModelOf("m" + std::to_string(i), i % 2 == 0 ? "Bed" : "Skillet"));
  }
  const auto choice = Choose(many, For("HospitalRoom"));
  EXPECT_EQ(choice.loaded.size(), 5'000U);
  EXPECT_EQ(choice.left_out.size(), 5'000U);
}

}  // namespace
}  // namespace lares::models
