#include "server/cli/when.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace lares::cli {
namespace {

using std::chrono::milliseconds;

TEST(WhenTest, SpansAreNumbersWithAUnit) {
  EXPECT_EQ(ParseSpan("45s"), milliseconds(45'000));
  EXPECT_EQ(ParseSpan("30m"), milliseconds(1'800'000));
  EXPECT_EQ(ParseSpan("12h"), milliseconds(43'200'000));
  EXPECT_EQ(ParseSpan("90d"), milliseconds(7'776'000'000));
  for (const char* bad :
       {"", "d", "90", "-1d", "1.5d", "1 d", "90days", "1w", "99999999999999999d", "40000d"}) {
    EXPECT_THROW(ParseSpan(bad), Error) << bad;
  }
}

TEST(WhenTest, TimesAreTakenAsTheyAreAndSpansFromNow) {
  const Time now = *FromRfc3339("2026-01-31T12:00:00Z");
  EXPECT_EQ(ToRfc3339(ParseWhen("2030-01-31T12:00:00Z", now, 1)), "2030-01-31T12:00:00.000Z");
  EXPECT_EQ(ToRfc3339(ParseWhen("1d", now, 1)), "2026-02-01T12:00:00.000Z");
  EXPECT_EQ(ToRfc3339(ParseWhen("1d", now, -1)), "2026-01-30T12:00:00.000Z");
  EXPECT_THROW(ParseWhen("tomorrow", now, 1), Error);
}

}  // namespace
}  // namespace lares::cli
