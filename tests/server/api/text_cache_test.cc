#include "server/api/text_cache.h"

#include <gtest/gtest.h>

namespace lares::api {
namespace {

TEST(TextCacheTest, MakesEachTextOnce) {
  TextCache cache;
  int made = 0;
  const auto make = [&] { return std::to_string(++made); };
  EXPECT_EQ(*cache.Get("a", make), "1");
  EXPECT_EQ(*cache.Get("a", make), "1");
  EXPECT_EQ(*cache.Get("b", make), "2");
}

TEST(TextCacheTest, HoldsNoMoreThanItMay) {
  TextCache cache(2);
  int made = 0;
  const auto make = [&] { return std::to_string(++made); };
  const auto first = cache.Get("a", make);
  cache.Get("b", make);
  cache.Get("c", make);
  EXPECT_EQ(*cache.Get("a", make), "4");
  EXPECT_EQ(*first, "1");  // what was given out stays
}

}  // namespace
}  // namespace lares::api
