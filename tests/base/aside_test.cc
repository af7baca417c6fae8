#include "base/aside.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"

namespace lares {
namespace {

TEST(AsideTest, GivesWhatTheWorkGives) {
  EXPECT_EQ(Aside([] { return 42; }), 42);
}

TEST(AsideTest, ThrowsWhatTheWorkThrows) {
  try {
    RunAside([] { throw Error(Code::kTooLarge, "too much"); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kTooLarge);
  }
}

TEST(AsideTest, TheWorkGivesWayAndTheCallerStaysAsItWas) {
  const int before = ::getpriority(PRIO_PROCESS, 0);
  const int during = Aside([] { return ::getpriority(PRIO_PROCESS, 0); });
  EXPECT_GT(during, before);
  EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), before);
}

}  // namespace
}  // namespace lares
