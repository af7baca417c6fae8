#include "base/time.h"

#include <gtest/gtest.h>

namespace lares {
namespace {

TEST(TimeTest, Rfc3339RoundTrips) {
  const Time time{std::chrono::milliseconds(1700000000123)};
  EXPECT_EQ(ToRfc3339(time), "2023-11-14T22:13:20.123Z");
  EXPECT_EQ(FromRfc3339(ToRfc3339(time)), time);
  EXPECT_EQ(FromRfc3339("2023-11-14T22:13:20Z"), time - std::chrono::milliseconds(123));
}

TEST(TimeTest, WhatIsNoTimeIsNothing) {
  for (const char* bad : {"", "yesterday", "2023-13-14T22:13:20Z", "2023-11-14T22:13:20",
                          "2023-11-14T22:13:20+02:00"}) {
    EXPECT_FALSE(FromRfc3339(bad)) << bad;
  }
}

TEST(TimeTest, AgeIsInTheLargestWholeUnit) {
  const Time then{std::chrono::milliseconds(0)};
  EXPECT_EQ(ToAge(then, then), "just now");
  EXPECT_EQ(ToAge(then, then + std::chrono::seconds(61)), "1 minute ago");
  EXPECT_EQ(ToAge(then, then + std::chrono::hours(49)), "2 days ago");
}

}  // namespace
}  // namespace lares
