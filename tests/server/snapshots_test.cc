#include "server/knowledge/snapshots.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

namespace lares::server {
namespace {

using std::chrono::seconds;

rdf::View EmptyView() { return rdf::View(std::make_shared<rdf::Dictionary>()); }

TEST(Snapshots, AreCountedWhileTheyArePinned) {
  const auto snapshots = std::make_shared<Snapshots>();
  EXPECT_EQ(snapshots->count(), 0u);
  EXPECT_EQ(snapshots->OldestAge(), Snapshots::Clock::duration::zero());
  {
    const PinnedView a(snapshots, EmptyView());
    const PinnedView b(snapshots, EmptyView());
    EXPECT_EQ(snapshots->count(), 2u);
  }
  EXPECT_EQ(snapshots->count(), 0u);
}

TEST(Snapshots, TheOldestCountsUntilItIsFreed) {
  const auto snapshots = std::make_shared<Snapshots>();
  const auto now = Snapshots::Clock::now();
  std::optional<PinnedView> old(std::in_place, snapshots, EmptyView(), now - seconds(30));
  const PinnedView young(snapshots, EmptyView(), now - seconds(2));
  EXPECT_EQ(snapshots->OldestAge(now), seconds(30));
  old.reset();
  EXPECT_EQ(snapshots->OldestAge(now), seconds(2));
}

TEST(Snapshots, AreFreedByAnException) {
  const auto snapshots = std::make_shared<Snapshots>();
  EXPECT_THROW(
      {
        const PinnedView pinned(snapshots, EmptyView());
        throw std::runtime_error("no more");
      },
      std::runtime_error);
  EXPECT_EQ(snapshots->count(), 0u);
}

TEST(Snapshots, APinKeepsItsLayersAlive) {
  const auto snapshots = std::make_shared<Snapshots>();
  auto layer = std::make_shared<const rdf::Layer>(std::vector<rdf::Graph>{}, rdf::Inference{});
  const std::weak_ptr<const rdf::Layer> watched = layer;
  {
    const PinnedView pinned(snapshots, EmptyView().With(std::move(layer)));
    EXPECT_FALSE(watched.expired());
  }
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace lares::server
