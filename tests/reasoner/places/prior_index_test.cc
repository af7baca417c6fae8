#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "reasoner/places/prior.h"

namespace lares::places {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Kitchen: 3 cups, 1 pan. Office: 1 cup, 1 pen. Two places, three classes, six statements.
PriorTable Small() {
  return {"small",
          "",
          {{"cup", "kitchen", 3, ""},
           {"cup", "office", 1, ""},
           {"pan", "kitchen", 1, ""},
           {"pen", "office", 1, ""}}};
}

std::vector<std::string> Names(const std::vector<RankedPlace>& places) {
  std::vector<std::string> names;
  for (const RankedPlace& place : places) names.push_back(place.place);
  return names;
}

double Sum(const std::vector<RankedPlace>& places) {
  double sum = 0;
  for (const RankedPlace& place : places) sum += place.probability;
  return sum;
}

TEST(PriorIndexTest, BayesByHand) {
  // P(cup|kitchen) = 3.5/5.5, P(kitchen) = 4/6; P(cup|office) = 1.5/3.5, P(office) = 2/6.
  const double kitchen = 3.5 / 5.5 * 4 / 6, office = 1.5 / 3.5 * 2 / 6;
  const auto ranked = RankPlaces(Small(), "cup");
  ASSERT_THAT(Names(ranked), ElementsAre("kitchen", "office"));
  EXPECT_NEAR(ranked[0].probability, kitchen / (kitchen + office), 1e-12);
  EXPECT_NEAR(ranked[1].probability, office / (kitchen + office), 1e-12);
  EXPECT_EQ(ranked[0].support, 3);
}

TEST(PriorIndexTest, PlaceNeverPairedGetsTheSmoothedShare) {
  // P(pan|office) = 0.5/3.5 although no pan was ever in an office.
  const double kitchen = 1.5 / 5.5 * 4 / 6, office = 0.5 / 3.5 * 2 / 6;
  const auto ranked = RankPlaces(Small(), "pan");
  ASSERT_THAT(ranked, SizeIs(2));
  EXPECT_NEAR(ranked[1].probability, office / (kitchen + office), 1e-12);
  EXPECT_EQ(ranked[1].support, 0);
}

TEST(PriorIndexTest, WithoutSmoothingOnlyWhatWasSeenCounts) {
  const auto ranked = RankPlaces(Small(), "pan", 0);
  EXPECT_EQ(ranked[0].probability, 1);
  EXPECT_EQ(ranked[1].probability, 0);
}

TEST(PriorIndexTest, ProbabilitiesSumToOne) {
  for (const char* object : {"cup", "pan", "pen"}) {
    for (const double lambda : {0.0, 0.5, 100.0}) {
      EXPECT_NEAR(Sum(RankPlaces(Small(), object, lambda)), 1, 1e-12) << object << lambda;
    }
  }
}

TEST(PriorIndexTest, ObjectThatTheTableNeverMentionsHasNoPlaces) {
  EXPECT_THAT(RankPlaces(Small(), "unicorn"), IsEmpty());
}

TEST(PriorIndexTest, SinglePlaceIsCertain) {
  const auto ranked = RankPlaces({"t", "", {{"cup", "kitchen", 2, ""}}}, "cup");
  ASSERT_THAT(ranked, SizeIs(1));
  EXPECT_EQ(ranked[0].probability, 1);
}

TEST(PriorIndexTest, EqualPlacesAreOrderedByIri) {
  const PriorTable table = {
      "t", "", {{"cup", "z", 1, ""}, {"cup", "a", 1, ""}, {"cup", "m", 1, ""}}};
  EXPECT_THAT(Names(RankPlaces(table, "cup")), ElementsAre("a", "m", "z"));
}

TEST(PriorIndexTest, PlaceWithoutAnyCountIsImpossible) {
  const PriorTable table = {"t", "", {{"cup", "kitchen", 1, ""}, {"cup", "moon", 0, ""}}};
  const auto ranked = RankPlaces(table, "cup");
  ASSERT_THAT(Names(ranked), ElementsAre("kitchen", "moon"));
  EXPECT_EQ(ranked[1].probability, 0);
}

TEST(PriorIndexTest, WrongLambdaIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double lambda : {-0.5, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(RankPlaces(Small(), "cup", lambda), Error);
  }
}

TEST(PriorIndexTest, OneIndexAnswersAsTheTableDoes) {
  const PriorIndex index(Small());
  EXPECT_EQ(index.object_count(), 3U);
  EXPECT_THAT(index.places(), ElementsAre("kitchen", "office"));
  EXPECT_EQ(index.Rank("pen")[0].probability, RankPlaces(Small(), "pen")[0].probability);
}

TEST(PriorIndexTest, PlacesOfOneKindAreRankedAmongThemselves) {
  PriorTable table = Small();
  table.rows.push_back({"cup", "table", 50, ""});
  const PriorTable rooms =
      OnlyPlaces(table, [](std::string_view place) { return place != "table"; });
  EXPECT_THAT(rooms.rows, SizeIs(4));
  EXPECT_EQ(rooms.name, "small");
  EXPECT_THAT(RankPlaces(rooms, "cup")[0].probability,
              DoubleNear(RankPlaces(Small(), "cup")[0].probability, 1e-15));
}

}  // namespace
}  // namespace lares::places
