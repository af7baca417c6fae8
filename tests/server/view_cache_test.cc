#include "server/knowledge/view_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "base/error.h"

namespace lares::server {
namespace {

rdf::View EmptyView() { return rdf::View(std::make_shared<rdf::Dictionary>()); }

TEST(ViewCacheTest, ThreadsThatAskAtOnceShareOneMaking) {
  ViewCache cache(4);
  std::atomic<int> made{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      cache.GetOrMake("key", [&] {
        ++made;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return EmptyView();
      });
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
}

TEST(ViewCacheTest, TheLeastRecentlyUsedIsForgotten) {
  ViewCache cache(2);
  int made = 0;
  const auto make = [&] {
    ++made;
    return EmptyView();
  };
  cache.GetOrMake("a", make);
  cache.GetOrMake("b", make);
  cache.GetOrMake("a", make);
  cache.GetOrMake("c", make);
  EXPECT_EQ(made, 3);
  cache.GetOrMake("a", make);
  EXPECT_EQ(made, 3);
  cache.GetOrMake("b", make);
  EXPECT_EQ(made, 4);
  EXPECT_EQ(cache.size(), 2U);
}

TEST(ViewCacheTest, AFailureIsNotKept) {
  ViewCache cache(2);
  EXPECT_THROW(cache.GetOrMake("a", []() -> rdf::View { throw Error(Code::kInvalid, "no"); }),
               Error);
  EXPECT_EQ(cache.size(), 0U);
  EXPECT_NO_THROW(cache.GetOrMake("a", EmptyView));
}

}  // namespace
}  // namespace lares::server
