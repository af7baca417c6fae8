#include <atomic>
#include <thread>

#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

class ConcurrencyTest : public StoreTest {};

template <typename Work>
void InThreads(int count, Work work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i) threads.emplace_back([&work, i] { work(i); });
  for (std::thread& thread : threads) thread.join();
}

TEST_F(ConcurrencyTest, OfTwoUpdatesFromTheSameVersionExactlyOneWins) {
  const Blob blob = PutBlob("layer");
  std::string etag = store_->PutVersion(Version("e", {Layer("a", blob)})).etag();
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> won{0};
    std::atomic<int> refused{0};
    InThreads(2, [&](int thread) {
      NewVersion version = Version("e", {Layer("a", blob)}, etag);
      version.author = std::to_string(thread);
      try {
        store_->PutVersion(version);
        ++won;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::kPreconditionFailed);
        ++refused;
      }
    });
    ASSERT_EQ(won, 1);
    ASSERT_EQ(refused, 1);
    ASSERT_EQ(store_->GetVersion("e", 0).number, round + 2);
    etag = store_->GetVersion("e", 0).etag();
  }
}

TEST_F(ConcurrencyTest, OfManyCreatorsExactlyOneCreates) {
  std::atomic<int> won{0};
  InThreads(4, [&](int thread) {
    try {
      store_->PutDocument(Recipe("a", std::to_string(thread), "none"));
      ++won;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kPreconditionFailed);
    }
  });
  EXPECT_EQ(won, 1);
  EXPECT_EQ(store_->DocumentLog(DocumentKind::kRecipe, "a").size(), 1U);
}

TEST_F(ConcurrencyTest, UnconditionalPutsOfOneDocumentAreAllKept) {
  InThreads(4, [&](int thread) {
    for (int i = 0; i < 10; ++i) {
      store_->PutDocument(Recipe("a", std::to_string(thread * 100 + i)));
    }
  });
  const std::vector<DocumentInfo> log = store_->DocumentLog(DocumentKind::kRecipe, "a");
  ASSERT_EQ(log.size(), 40U);
  EXPECT_EQ(log.front().version, 40);
}

TEST_F(ConcurrencyTest, ReadersNeverSeeAHalf) {
  // In every version both layers, and the document's bytes and name, carry the same number.
  const auto put = [&](int number) {
    const std::string text = std::to_string(number);
    const Blob blob = PutBlob(text);
    store_->PutVersion(Version("e", {Layer("a", blob), Layer("b", blob)}));
    NewDocument document = Recipe("d", text);
    document.names = {{"name", "label", text}};
    store_->PutDocument(document);
  };
  put(0);
  std::atomic<bool> stop{false};
  std::atomic<int> reads{0};
  InThreads(4, [&](int thread) {
    if (thread == 0) {
      for (int number = 1; number <= 60; ++number) put(number);
      stop = true;
      return;
    }
    do {
      const EnvironmentVersion version = store_->GetVersion("e", 0);
      ASSERT_EQ(version.layers.size(), 2U);
      EXPECT_EQ(version.layers[0].blob.sha256, version.layers[1].blob.sha256);
      EXPECT_EQ(store_->ReadBlob(version.layers[0].blob.sha256),
                std::to_string(version.number - 1));
      const auto named = store_->FindByName(DocumentKind::kRecipe, "NAME");
      ASSERT_EQ(named.size(), 1U);
      EXPECT_EQ(store_->ReadBlob(named[0].first.blob.sha256), named[0].second.target);
      EXPECT_EQ(store_->ListDocuments(DocumentKind::kRecipe).size(), 1U);
      ++reads;
    } while (!stop);
  });
  EXPECT_GE(reads, 3);
}

TEST_F(ConcurrencyTest, BlobsOfManyThreadsAllArrive) {
  std::vector<std::string> hashes(8 * 10);
  InThreads(8, [&](int thread) {
    for (int i = 0; i < 10; ++i) {
      // Every second one is the same in all threads.
      const std::string bytes = i % 2 == 0 ? std::to_string(i) : std::to_string(thread * 100 + i);
      hashes[thread * 10 + i] = PutBlob(bytes).sha256;
    }
  });
  for (const std::string& hash : hashes) EXPECT_FALSE(store_->ReadBlob(hash).empty());
}

}  // namespace
}  // namespace lares::store::testing
