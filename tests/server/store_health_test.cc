#include "server/store/health.h"

#include <gmock/gmock.h>

#include <system_error>

#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

using ::testing::HasSubstr;

void Attempt(Health& health, std::errc fault) {
  health.Attempt([&] { throw std::system_error(std::make_error_code(fault), "cannot write 'x'"); });
}

TEST(HealthTest, FullDiskStopsEveryWriteUntilThereIsRoomAgain) {
  bool has_room = false;
  Health health;
  health.WatchRoom([&] { return has_room; });
  EXPECT_EQ(health.reason(), "");
  EXPECT_EQ(CodeOf([&] { Attempt(health, std::errc::no_space_on_device); }), Code::kUnavailable);
  EXPECT_THAT(health.reason(), HasSubstr("cannot write 'x'"));
  EXPECT_EQ(CodeOf([&] { health.Check(); }), Code::kUnavailable);
  bool ran = false;
  EXPECT_EQ(CodeOf([&] { health.Attempt([&] { ran = true; }); }), Code::kUnavailable);
  EXPECT_FALSE(ran);
  has_room = true;
  EXPECT_EQ(health.reason(), "");
  health.Attempt([&] { ran = true; });
  EXPECT_TRUE(ran);
}

TEST(HealthTest, OtherFaultOfAnAttemptStopsNothing) {
  Health health;
  health.WatchRoom([] { return false; });
  EXPECT_EQ(CodeOf([&] { Attempt(health, std::errc::io_error); }), Code::kUnavailable);
  EXPECT_EQ(health.reason(), "");
}

TEST(HealthTest, FaultOfAGuardedWriteStaysWhateverRoomThereIs) {
  Health health;
  health.WatchRoom([] { return true; });
  EXPECT_EQ(CodeOf([&] {
              health.Guard([] {
                throw std::system_error(std::make_error_code(std::errc::io_error), "fsync 'x'");
              });
            }),
            Code::kUnavailable);
  EXPECT_THAT(health.reason(), HasSubstr("fsync 'x'"));
  EXPECT_EQ(CodeOf([&] { health.Check(); }), Code::kUnavailable);
}

}  // namespace
}  // namespace lares::store::testing
