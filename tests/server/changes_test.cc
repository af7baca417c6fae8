#include "server/knowledge/changes.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace lares::server {
namespace {

TEST(Changes, AreCountedAndToldUntilTheTokenIsDropped) {
  Changes changes;
  int told = 0;
  auto token = changes.Listen([&] { ++told; });
  changes.Notify();
  changes.Notify();
  EXPECT_EQ(changes.generation(), 2u);
  EXPECT_EQ(told, 2);
  token.reset();
  changes.Notify();
  EXPECT_EQ(changes.generation(), 3u);
  EXPECT_EQ(told, 2);
}

TEST(Changes, ReachEveryListener) {
  Changes changes;
  std::vector<int> told;
  const auto a = changes.Listen([&] { told.push_back(1); });
  const auto b = changes.Listen([&] { told.push_back(2); });
  changes.Notify();
  EXPECT_EQ(told, (std::vector{1, 2}));
}

TEST(Changes, ATokenMayOutliveThem) {
  std::shared_ptr<void> token;
  {
    Changes changes;
    token = changes.Listen([] {});
  }
  token.reset();
}

TEST(Changes, OfManyThreadsAreAllCounted) {
  Changes changes;
  int told = 0;
  const auto token = changes.Listen([&] { ++told; });  // one call at a time
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int j = 0; j < 100; ++j) changes.Notify();
    });
  }
  threads.clear();
  EXPECT_EQ(changes.generation(), 400u);
  EXPECT_EQ(told, 400);
}

}  // namespace
}  // namespace lares::server
