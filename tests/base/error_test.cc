#include "base/error.h"

#include <gtest/gtest.h>

namespace lares {
namespace {

TEST(ErrorTest, FullMessageNamesThePlace) {
  const Error error(Code::kInvalid, "malformed comment", {"recipe.owl", 715, 6});
  EXPECT_EQ(error.FullMessage(), "recipe.owl:715:6: malformed comment");
}

TEST(ErrorTest, UnknownColumnIsLeftOut) {
  EXPECT_EQ(ToString(Place{"a.ttl", 3, 0}), "a.ttl:3");
  EXPECT_EQ(ToString(Place{"a.ttl", 0, 0}), "a.ttl");
}

TEST(ErrorTest, WithoutPlaceTheMessageStandsAlone) {
  EXPECT_EQ(Error(Code::kIo, "disk gone").FullMessage(), "disk gone");
}

}  // namespace
}  // namespace lares
