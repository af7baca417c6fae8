#include "base/number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lares {
namespace {

TEST(NumberTest, UsualNotationsAreNumbers) {
  EXPECT_EQ(ToNumber("-1.5e2"), -150.0);
  EXPECT_EQ(ToNumber("+2"), 2.0);
  EXPECT_EQ(ToNumber("-9.722474E-8"), -9.722474e-8);
  EXPECT_EQ(ToNumber("-0.0"), 0.0);
}

TEST(NumberTest, OnlyWholeWordsAreNumbers) {
  for (const char* text : {"2x", "", "+-2", " 2", "2 ", "0x10", "1,5", "-"}) {
    EXPECT_EQ(ToNumber(text), std::nullopt) << text;
  }
}

TEST(NumberTest, InfinityAndNanAreToldByTheirNames) {
  EXPECT_TRUE(std::isinf(*ToNumber("INF")));
  EXPECT_TRUE(std::isinf(*ToNumber("-inf")));
  EXPECT_TRUE(std::isnan(*ToNumber("NaN")));
}

TEST(NumberTest, OutOfRangeIsInfinityOrZero) {
  EXPECT_TRUE(std::isinf(*ToNumber("1e999")));
  EXPECT_EQ(ToNumber("1e-999"), 0.0);
}

}  // namespace
}  // namespace lares
