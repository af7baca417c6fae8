#include "server/knowledge/overlays.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/materialise.h"

namespace lares::server {
namespace {

class OverlaysTest : public ::testing::Test {
 protected:
  rdf::TermId Iri(const std::string& name) {
    return dictionary_->InternIri("http://example.org/" + name);
  }
  // A catalogue that says which generation it is.
  Snapshot Catalogue(std::uint64_t generation) {
    rdf::Graph graph;
    graph.name = "catalogue";
    const rdf::TermId me = Iri("generation" + std::to_string(generation));
    graph.triples = {{me, Iri("is"), me}};
    const rdf::View empty(dictionary_);
    return {empty.With(owl::Materialise(empty, {graph})), generation};
  }
  // A document that says its name; counts how often it is read, and takes `delay` for it.
  OverlaySource Source(const std::string& name, std::chrono::milliseconds delay = {}) {
    return {name, [this, name, delay] {
              ++read_;
              std::this_thread::sleep_for(delay);
              if (fails_) throw Error(Code::kInvalid, "no");
              rdf::Graph graph;
              graph.name = name;
              graph.triples = {{Iri(name), Iri("is"), Iri(name)}};
              return graph;
            }};
  }
  // What the view's own catalogue says that it is.
  std::uint64_t GenerationIn(const rdf::View& view) {
    const rdf::TermView said =
        dictionary_->Get(view.layers().front()->graphs().front().triples.front().subject);
    return std::stoull(std::string(said.value.substr(said.value.rfind('n') + 1)));
  }

  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  std::atomic<int> read_{0};
  std::atomic<bool> fails_{false};
};

using std::chrono::milliseconds;

TEST_F(OverlaysTest, ThreadsThatAskAtOnceShareOneMaking) {
  Overlays overlays(4);
  const Snapshot catalogue = Catalogue(1);
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] { overlays.Get(catalogue, {Source("map", milliseconds(5))}); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read_, 1);
}

TEST_F(OverlaysTest, TheLeastRecentlyUsedIsForgotten) {
  Overlays overlays(2);
  const Snapshot catalogue = Catalogue(1);
  for (const char* name : {"a", "b", "a", "c"}) overlays.Get(catalogue, {Source(name)});
  EXPECT_EQ(read_, 3);
  overlays.Get(catalogue, {Source("a")});
  EXPECT_EQ(read_, 3);
  overlays.Get(catalogue, {Source("b")});
  EXPECT_EQ(read_, 4);
  EXPECT_EQ(overlays.size(), 2U);
}

TEST_F(OverlaysTest, AFailureIsNotKept) {
  Overlays overlays(2);
  fails_ = true;
  EXPECT_THROW(overlays.Get(Catalogue(1), {Source("a")}), Error);
  EXPECT_EQ(overlays.size(), 0U);
  fails_ = false;
  EXPECT_NO_THROW(overlays.Get(Catalogue(1), {Source("a")}));
}

TEST_F(OverlaysTest, AStackLiesOverItsLowerPart) {
  Overlays overlays(8);
  const Snapshot catalogue = Catalogue(1);
  const Snapshot both = overlays.Get(catalogue, {Source("robot"), Source("recipe")});
  EXPECT_EQ(both.view.layers().size(), 3U);
  EXPECT_EQ(overlays.Get(catalogue, {Source("robot")}).view.layers()[1], both.view.layers()[1]);
  EXPECT_EQ(read_, 2);
}

TEST_F(OverlaysTest, AfterAChangeTheOldViewServesUntilTheNewOneIsMade) {
  Overlays overlays(8);
  overlays.Get(Catalogue(1), {Source("map", milliseconds(50))});
  const Snapshot next = Catalogue(2);
  overlays.Renew(next);
  const Snapshot meanwhile = overlays.Get(next, {Source("map")});
  EXPECT_EQ(meanwhile.generation, 1U);
  EXPECT_EQ(GenerationIn(meanwhile.view), 1U);
  overlays.Wait();
  const Snapshot later = overlays.Get(next, {Source("map")});
  EXPECT_EQ(later.generation, 2U);
  EXPECT_EQ(GenerationIn(later.view), 2U);
  EXPECT_EQ(read_, 2);
}

TEST_F(OverlaysTest, ARenewalIsToldOnceReadersGetIt) {
  const Snapshot next = Catalogue(2);
  std::atomic<int> told{0};
  std::atomic<std::uint64_t> seen{0};
  Overlays* readers = nullptr;
  Overlays overlays(4, [&] {
    seen = GenerationIn(readers->Get(next, {Source("map")}).view);
    ++told;
  });
  readers = &overlays;
  overlays.Get(Catalogue(1), {Source("map")});
  EXPECT_EQ(told, 0);
  overlays.Renew(next);
  overlays.Wait();
  EXPECT_EQ(told, 1);
  EXPECT_EQ(seen, 2u);
}

TEST_F(OverlaysTest, WhatHasNoOlderViewIsMadeOverTheNewCatalogue) {
  Overlays overlays(8);
  overlays.Renew(Catalogue(2));
  EXPECT_EQ(overlays.Get(Catalogue(2), {Source("map")}).generation, 2U);
}

TEST_F(OverlaysTest, WhatWasBegunBeforeTheChangeIsRenewedAfterIt) {
  Overlays overlays(8);
  std::thread slow([&] { overlays.Get(Catalogue(1), {Source("map", milliseconds(50))}); });
  while (read_ == 0) std::this_thread::yield();
  overlays.Renew(Catalogue(2));
  slow.join();
  overlays.Wait();
  EXPECT_EQ(overlays.Get(Catalogue(2), {Source("map")}).generation, 2U);
}

TEST_F(OverlaysTest, WhatCannotBeRenewedIsForgottenAndTheNextReaderMeetsTheFault) {
  Overlays overlays(8);
  overlays.Get(Catalogue(1), {Source("map")});
  fails_ = true;
  overlays.Renew(Catalogue(2));
  overlays.Wait();
  EXPECT_EQ(overlays.size(), 0U);
  EXPECT_THROW(overlays.Get(Catalogue(2), {Source("map")}), Error);
}

TEST_F(OverlaysTest, TheEndDoesNotWaitForWhatIsDue) {
  {
    Overlays overlays(64);
    for (int i = 0; i < 40; ++i) {
      overlays.Get(Catalogue(1), {Source("map" + std::to_string(i), milliseconds(5))});
    }
    EXPECT_EQ(read_, 40);
    overlays.Renew(Catalogue(2));
  }
  EXPECT_LT(read_, 70);
}

// Readers ask without a pause while the catalogue changes: none waits for a renewal, and whatever
// one sees is of one generation throughout, never older than what it saw before.
TEST_F(OverlaysTest, ReadersSeeWholeGenerationsInOrderWhileTheCatalogueChanges) {
  Overlays overlays(8);
  std::mutex mutex;
  Snapshot now = Catalogue(1);
  const auto catalogue = [&] {
    const std::lock_guard lock(mutex);
    return now;
  };
  const std::vector<OverlaySource> robot = {Source("robot", milliseconds(2))};
  const std::vector<OverlaySource> both = {robot[0], Source("recipe", milliseconds(2))};
  overlays.Get(now, both);
  std::atomic<bool> is_over{false};
  std::atomic<int> mixed{0}, backwards{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < 4; ++i) {
    readers.emplace_back([&, i] {
      std::uint64_t last = 0;
      while (!is_over) {
        const Snapshot seen = overlays.Get(catalogue(), i % 2 == 0 ? robot : both);
        if (GenerationIn(seen.view) != seen.generation) ++mixed;
        if (seen.generation < last) ++backwards;
        last = seen.generation;
      }
    });
  }
  for (std::uint64_t generation = 2; generation <= 20; ++generation) {
    const Snapshot next = Catalogue(generation);
    {
      const std::lock_guard lock(mutex);
      now = next;
    }
    overlays.Renew(next);
    std::this_thread::sleep_for(milliseconds(5));
  }
  overlays.Wait();
  is_over = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(mixed, 0);
  EXPECT_EQ(backwards, 0);
  EXPECT_EQ(overlays.Get(catalogue(), both).generation, 20U);
}

}  // namespace
}  // namespace lares::server
