#include "server/knowledge/robot_grids.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "base/error.h"

namespace lares::server {
namespace {

RobotGrid OfSize(std::size_t bytes) {
  RobotGrid grid;
  grid.pgm.assign(bytes, 'x');
  return grid;
}

TEST(RobotGridsTest, OneKeyIsMadeOnce) {
  RobotGrids grids;
  int made = 0;
  const auto make = [&] {
    ++made;
    return OfSize(10);
  };
  const auto first = grids.Get("a", make);
  EXPECT_EQ(grids.Get("a", make), first);
  EXPECT_EQ(made, 1);
  grids.Get("b", make);
  EXPECT_EQ(made, 2);
}

TEST(RobotGridsTest, TheLeastRecentlyUsedGoesWhenThereIsNoRoom) {
  RobotGrids grids(3 * 4096);
  int made = 0;
  const auto make = [&] {
    ++made;
    return OfSize(4096 - 1024);
  };
  for (const char* key : {"a", "b", "c"}) grids.Get(key, make);
  grids.Get("a", make);
  EXPECT_EQ(made, 3);
  grids.Get("d", make);  // b goes
  EXPECT_LE(grids.kept_bytes(), 3U * 4096);
  grids.Get("a", make);
  grids.Get("c", make);
  EXPECT_EQ(made, 4);
  grids.Get("b", make);
  EXPECT_EQ(made, 5);
}

TEST(RobotGridsTest, OneThatIsLargerThanTheRoomIsGivenAndNotKept) {
  RobotGrids grids(4096);
  EXPECT_EQ(grids.Get("a", [] { return OfSize(10'000); })->pgm.size(), 10'000U);
  EXPECT_EQ(grids.kept_bytes(), 0U);
}

TEST(RobotGridsTest, ALayerThatMakesNoGridIsNotReadAgain) {
  RobotGrids grids;
  int made = 0;
  const auto make = [&]() -> RobotGrid {
    ++made;
    throw Error(Code::kTooLarge, "too many cells");
  };
  EXPECT_THROW(grids.Get("a", make), Error);
  EXPECT_THROW(grids.Get("a", make), Error);
  EXPECT_EQ(made, 1);
}

TEST(RobotGridsTest, AFaultOfTheDiskIsForgotten) {
  RobotGrids grids;
  EXPECT_THROW(grids.Get("a", []() -> RobotGrid { throw Error(Code::kIo, "no"); }), Error);
  EXPECT_EQ(grids.Get("a", [] { return OfSize(1); })->pgm.size(), 1U);
}

TEST(RobotGridsTest, ThreadsThatAskAtOnceShareOneMaking) {
  RobotGrids grids;
  std::atomic<int> made = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      grids.Get("a", [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++made;
        return OfSize(10);
      });
    });
  }
  threads.clear();
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace lares::server
