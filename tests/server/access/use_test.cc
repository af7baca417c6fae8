#include "server/access/use.h"

#include <gtest/gtest.h>

namespace lares::access {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TokenBucketTest, GivesAMinutesWorthAtOnceAndThenAPace) {
  TokenBucket bucket;
  TokenBucket::Clock::time_point now{seconds(1000)};
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(bucket.Take(60, now)) << i;
  EXPECT_EQ(bucket.Take(60, now), seconds(1));
  now += milliseconds(500);
  EXPECT_EQ(bucket.Take(60, now), seconds(1));
  now += milliseconds(600);
  EXPECT_FALSE(bucket.Take(60, now));
  EXPECT_TRUE(bucket.Take(60, now));
  now += std::chrono::hours(1);  // no more than a minute's worth is saved up
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(bucket.Take(60, now)) << i;
  EXPECT_TRUE(bucket.Take(60, now));
}

TEST(TokenBucketTest, SaysHowLongToWait) {
  TokenBucket bucket;
  const TokenBucket::Clock::time_point now{seconds(1000)};
  EXPECT_FALSE(bucket.Take(1, now));
  EXPECT_EQ(bucket.Take(1, now), seconds(60));
  EXPECT_EQ(bucket.Take(1, now - seconds(10)), seconds(60));  // a clock that goes back
}

TEST(TokenBucketTest, WithoutALimitThereIsNone) {
  TokenBucket bucket;
  for (int i = 0; i < 10'000; ++i) ASSERT_FALSE(bucket.Take(0, {}));
}

TEST(HeldTest, PlacesOfQueriesComeBackWithTheirRequest) {
  const auto use = std::make_shared<Use>();
  auto first = std::make_unique<Held>(use);
  EXPECT_TRUE(first->BeginQuery(1));
  EXPECT_FALSE(Held(use).BeginQuery(1));
  EXPECT_TRUE(Held(use).BeginQuery(0));
  first.reset();
  EXPECT_TRUE(Held(use).BeginQuery(1));
  EXPECT_EQ(use->queries_running, 0);
}

TEST(HeldTest, BytesOfAllRequestsThatArriveAreCountedTogether) {
  const auto use = std::make_shared<Use>();
  auto first = std::make_unique<Held>(use);
  Held second(use);
  EXPECT_EQ(first->Arriving(100), 100u);
  EXPECT_EQ(second.Arriving(10), 110u);
  EXPECT_EQ(second.Arriving(30), 130u);
  EXPECT_EQ(second.Arriving(20), 130u);  // never fewer
  first.reset();
  EXPECT_EQ(second.Arriving(30), 30u);
}

}  // namespace
}  // namespace lares::access
