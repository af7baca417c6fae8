#include <gmock/gmock.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class BackupTest : public StoreTest {
 protected:
  void Fill() {
    NewDocument document = Recipe("fetch", "one");
    document.names = {{"Fetch", "label", "x:Fetch"}};
    store_->PutDocument(document);
    store_->PutDocument(Recipe("fetch", "two"));
    store_->PutDocument(Recipe("gone", "three"));
    store_->DeleteDocument(DocumentKind::kRecipe, "gone");
    NewVersion version = Version("flat", {Layer("grid", PutBlob(std::string(3 << 20, 'g')))});
    version.keys = std::vector<SearchKey>{{"street", "Straße"}};
    version.label = "Flät 'quoted'";
    store_->PutVersion(version);
    store_->PutVersion(Version("flat", {Layer("octomap", PutBlob("o"))}));
    store_->PutTag({"flat", "tidy", 1, {}, "ann", ""}, false);
    store_->PutPin({"amigo", "flat", 1, {}, ""});
  }
  fs::path backup() const { return other_.path() / "backup"; }

  TemporaryFolder other_{FastFolder()};
};

TEST_F(BackupTest, RestoresToTheSameDigestInEitherStore) {
  Fill();
  std::uint64_t done = 0;
  std::uint64_t all = 0;
  const BackupReport report = store_->Backup(backup(), [&](std::uint64_t d, std::uint64_t a) {
    done = d;
    all = a;
  });
  EXPECT_EQ(report.digest, store_->Digest());
  EXPECT_EQ(report.documents, 3u);
  EXPECT_EQ(report.environments, 2u);
  EXPECT_EQ(done, all);
  EXPECT_GT(all, 3u << 20);

  const auto sqlite = OpenSqliteStore({other_.path() / "restored"});
  EXPECT_EQ(sqlite->FillFrom(backup(), {}).digest, report.digest);
  EXPECT_EQ(sqlite->Digest(), report.digest);
  EXPECT_TRUE(sqlite->Verify().empty());
  EXPECT_EQ(sqlite->FindTag("flat", "tidy")->number, 1);
  // It goes on from there.
  EXPECT_EQ(sqlite->PutDocument(Recipe("fetch", "four")).version, 3);
  EXPECT_EQ(sqlite->PutDocument(Recipe("another", "five")).version, 1);
}

TEST_F(BackupTest, FillsAnEmptyStoreOfThisKind) {
  Fill();
  const BackupReport report = store_->Backup(backup(), {});
  const TemporaryFolder blobs{FastFolder()};
  const auto into = postgres_.empty()
                        ? OpenSqliteStore({blobs.path()})
                        : OpenPostgresStore({SharedPostgres().NewDatabase(), blobs.path()});
  into->FillFrom(backup(), {});
  EXPECT_EQ(into->Digest(), report.digest);
  EXPECT_EQ(into->Verify(), std::vector<std::string>{});
  EXPECT_EQ(into->PutDocument(Recipe("another", "five")).version, 1);
  EXPECT_EQ(into->PutVersion(
                    Version("new", {Layer("grid", into->GetVersion("flat", 1).layers.at(0).blob)}))
                .number,
            1);
}

TEST_F(BackupTest, MadeUnderWritesIsOneMoment) {
  Fill();
  std::atomic<bool> stop = false;
  std::thread writer([&] {
    for (int i = 0; !stop; ++i) {
      store_->PutDocument(Recipe("w" + std::to_string(i % 7), std::to_string(i)));
    }
  });
  const BackupReport report = store_->Backup(backup(), {});
  stop = true;
  writer.join();
  const auto restored = OpenSqliteStore({other_.path() / "restored"});
  restored->FillFrom(backup(), {});
  EXPECT_EQ(restored->Digest(), report.digest);
  EXPECT_EQ(restored->Verify(), std::vector<std::string>{});
}

TEST_F(BackupTest, FolderWithSomethingInItIsRefused) {
  fs::create_directories(backup());
  std::ofstream(backup() / "mine") << "x";
  EXPECT_EQ(CodeOf([&] { store_->Backup(backup(), {}); }), Code::kConflict);
}

TEST_F(BackupTest, DamagedBlobOfABackupIsNamedAndNothingIsKept) {
  Fill();
  store_->Backup(backup(), {});
  const std::string sha256 = store_->GetVersion("flat", 1).layers.at(0).blob.sha256;
  fs::resize_file(backup() / "blobs" / sha256.substr(0, 2) / sha256.substr(2), 100);
  const auto into = OpenSqliteStore({other_.path() / "restored"});
  const Error error = ErrorOf([&] { into->FillFrom(backup(), {}); });
  EXPECT_EQ(error.code(), Code::kInvalid);
  EXPECT_THAT(error.what(), HasSubstr(sha256));
  EXPECT_TRUE(into->ListEnvironments().empty());
}

TEST_F(BackupTest, WhatIsNoBackupOrIsUnfinishedIsRefused) {
  Fill();
  store_->Backup(backup(), {});
  fs::remove(backup() / "backup.json");
  const auto into = OpenSqliteStore({other_.path() / "restored"});
  EXPECT_EQ(CodeOf([&] { into->FillFrom(backup(), {}); }), Code::kInvalid);
  for (const char* text : {"", "{", "[]", "{\"schema\": 99}", "{\"schema\": \"3\"}"}) {
    std::ofstream(backup() / "backup.json") << text;
    EXPECT_EQ(CodeOf([&] { into->FillFrom(backup(), {}); }), Code::kInvalid) << text;
  }
}

TEST_F(BackupTest, StoreWithSomethingInItIsNotFilled) {
  Fill();
  store_->Backup(backup(), {});
  EXPECT_EQ(CodeOf([&] { store_->FillFrom(backup(), {}); }), Code::kConflict);
}

}  // namespace
}  // namespace lares::store::testing
