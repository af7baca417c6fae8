// The disk fails at every single operation, in every way, and nothing acknowledged is lost.
#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/hash.h"
#include "server/store/sqlite_store.h"
#include "tests/server/simulated_disk.h"
#include "tests/server/store_fixture.h"
#include "tests/server/store_ledger.h"

namespace lares::store::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr DocumentKind kRecipe = DocumentKind::kRecipe;

// Each life has one thread, so the thread sanitizer, which is slow, need not see them all.
#ifdef __SANITIZE_THREAD__
constexpr int kStep = 7;
#else
constexpr int kStep = 1;
#endif

// With so few pages that the script below meets several checkpoints.
std::unique_ptr<Store> OpenOn(SimulatedDisk& disk, int checkpoint_pages = 12) {
  Seams seams;
  seams.files = &disk;
  seams.sqlite_vfs = disk.vfs();
  seams.checkpoint_pages = checkpoint_pages;
  return OpenSqliteStore({disk.folder()}, seams);
}

// Writes that note in the ledger what was acknowledged, and in `under_way` what was not yet.
class Writer {
 public:
  Writer(Store& store, Ledger& ledger) : store_(store), ledger_(ledger) {}

  void PutDocument(const std::string& id, const std::string& bytes) {
    under_way = {id};
    NewDocument document = Recipe(id, bytes);
    document.names = {{"name of " + id, "label", bytes.substr(0, 10)}};
    const DocumentInfo info = store_.PutDocument(document);
    auto& versions = ledger_.documents[id];
    versions.resize(static_cast<std::size_t>(info.version));
    versions.back() = bytes;
    ledger_.deleted[id] = false;
    under_way.clear();
  }
  void DeleteDocument(const std::string& id) {
    under_way = {id};
    store_.DeleteDocument(kRecipe, id);
    ledger_.deleted[id] = true;
    under_way.clear();
  }
  Blob PutBlob(const std::string& bytes) {
    const auto writer = store_.NewBlob();
    writer->Append(bytes.substr(0, bytes.size() / 3));
    writer->Append(bytes.substr(bytes.size() / 3));
    const Blob blob = writer->Commit();
    ledger_.blobs[blob.sha256] = bytes;
    return blob;
  }
  // As a client does that does not send again what it finds.
  Blob FindOrPutBlob(const std::string& bytes) {
    try {
      store_.BlobPath(Sha256Hex(bytes));
      return {Sha256Hex(bytes), bytes.size()};
    } catch (const Error&) {
      return PutBlob(bytes);
    }
  }
  void PutVersion(const std::string& id, std::vector<LayerInfo> layers) {
    under_way = {id};
    const EnvironmentVersion version = store_.PutVersion(Version(id, std::move(layers)));
    auto& versions = ledger_.environments[id];
    versions.resize(static_cast<std::size_t>(version.number));
    for (const LayerInfo& layer : version.layers) versions.back()[layer.name] = layer.blob.sha256;
    under_way.clear();
  }

  std::set<std::string> under_way;

 private:
  Store& store_;
  Ledger& ledger_;
};

void RunScript(Writer& write) {
  write.PutDocument("a", "first");
  write.PutVersion("room", {Layer("semantic", write.PutBlob("semantic one")),
                            Layer("grid", write.PutBlob(std::string(20000, 'g')))});
  write.PutDocument("a", "second");
  write.PutDocument("b", std::string(9000, 'b'));
  write.DeleteDocument("a");
  write.PutVersion("room", {Layer("semantic", write.PutBlob("semantic two"))});
  write.PutDocument("a", "third");
}

// An upload that is taken in, and the folder made for it.
bool RestsNothingOn(std::string_view operation, const std::filesystem::path& path) {
  const bool incoming = path.parent_path().filename() == "incoming";
  return operation == "mkdir" || (incoming && (operation == "create" || operation == "write"));
}

// One life of a store on a disk that fails at operation `at`. False when it was not reached.
bool Survives(int at, Fault fault, Unsynced unsynced) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  Ledger ledger;
  std::set<std::string> under_way;
  bool harmless = false;  // the first operation that failed was one on which nothing rests
  disk.set_observer([&](std::string_view operation, const std::filesystem::path& path) {
    if (!disk.has_failed()) harmless = RestsNothingOn(operation, path);
  });
  disk.FailAt(at, fault);
  try {
    std::unique_ptr<Store> store = OpenOn(disk);
    EXPECT_FALSE(disk.has_failed()) << "opened in spite of a fault";
    Writer write(*store, ledger);
    try {
      RunScript(write);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kUnavailable) << error.what();
    }
    under_way = write.under_way;
    // Where nothing rests on what failed, that write alone was refused. Otherwise nothing is
    // accepted from then on, and all that was accepted can be read.
    if (disk.has_failed() && harmless) {
      EXPECT_EQ(store->health(), "");
      EXPECT_TRUE(fault == Fault::kPowerCut ||
                  std::filesystem::is_empty(disk.folder() / "incoming"));
      if (fault == Fault::kError) {
        write.under_way.clear();
        write.PutDocument("late", "x");
        under_way.insert(write.under_way.begin(), write.under_way.end());
      }
      EXPECT_THAT(Missing(*store, ledger, under_way), IsEmpty());
    } else if (disk.has_failed()) {
      EXPECT_NE(store->health(), "");
      EXPECT_EQ(CodeOf([&] { store->PutDocument(Recipe("late", "x")); }), Code::kUnavailable);
      EXPECT_EQ(CodeOf([&] { store->DeleteDocument(kRecipe, "b"); }), Code::kUnavailable);
      EXPECT_EQ(CodeOf([&] { store->NewBlob(); }), Code::kUnavailable);
      EXPECT_THAT(Missing(*store, ledger, under_way), IsEmpty());
      const int operations = disk.operations();
      store.reset();
      EXPECT_EQ(disk.operations(), operations) << "closing touched the files";
    }
  } catch (const Error& error) {
    EXPECT_TRUE(disk.has_failed()) << error.what();  // while opening
  }
  const bool reached = disk.has_failed();
  disk.set_observer(nullptr);
  disk.Restart(unsynced, static_cast<unsigned>(at));
  {
    // Without checkpoints, so that all rests on the log.
    const std::unique_ptr<Store> store = OpenOn(disk, 1000);
    EXPECT_THAT(Missing(*store, ledger, under_way), IsEmpty());
    EXPECT_THAT(store->Verify(), IsEmpty());
    EXPECT_TRUE(std::filesystem::is_empty(disk.folder() / "incoming"));
    Absorb(*store, under_way, ledger);
    under_way.clear();
    Writer write(*store, ledger);
    write.PutDocument("after", "the restart");
    write.PutVersion("after", {Layer("semantic", write.FindOrPutBlob("semantic two"))});
    // The power fails again, at once.
    disk.FailAt(1, Fault::kPowerCut);
  }
  disk.Restart(Unsynced::kLost);
  const std::unique_ptr<Store> store = OpenOn(disk);
  EXPECT_THAT(Missing(*store, ledger, under_way), IsEmpty());
  EXPECT_THAT(store->Verify(), IsEmpty());
  return reached;
}

void SurvivesEverywhere(Fault fault, Unsynced unsynced) {
  int at = 1;
  while (Survives(at, fault, unsynced)) {
    ASSERT_FALSE(::testing::Test::HasFailure()) << "the fault was at operation " << at;
    at += kStep;
  }
  EXPECT_GT(at, 100);  // the script is as long as it is thought to be
}

TEST(StoreFaultTest, NothingIsLostWhenOneOperationFailsAndTheProcessRestarts) {
  SurvivesEverywhere(Fault::kError, Unsynced::kKept);
}
TEST(StoreFaultTest, NothingIsLostWhenOneOperationFailsAndThePowerFails) {
  SurvivesEverywhere(Fault::kError, Unsynced::kLost);
}
TEST(StoreFaultTest, NothingIsLostWhenTheDiskFillsUp) {
  SurvivesEverywhere(Fault::kFull, Unsynced::kKept);
}
TEST(StoreFaultTest, NothingIsLostWhenThePowerFails) {
  SurvivesEverywhere(Fault::kPowerCut, Unsynced::kLost);
}
TEST(StoreFaultTest, NothingIsLostWhenThePowerFailsAndSomeUnsyncedWritesSurvive) {
  SurvivesEverywhere(Fault::kPowerCut, Unsynced::kSomeLost);
}
TEST(StoreFaultTest, NothingIsLostWhenTheProcessDiesAndThePowerFailsLater) {
  SurvivesEverywhere(Fault::kPowerCut, Unsynced::kKept);
}

TEST(StoreFaultTest, UploadThatFillsTheDiskIsRefusedAloneAndLaterOnesAreAccepted) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  const std::unique_ptr<Store> store = OpenOn(disk);
  const std::unique_ptr<BlobWriter> writer = store->NewBlob();
  writer->Append("fits");
  disk.FailAt(1, Fault::kFull);
  const Error error = ErrorOf([&] { writer->Append("does not fit"); });
  EXPECT_EQ(error.code(), Code::kUnavailable);
  EXPECT_THAT(error.what(), HasSubstr("there is no room"));
  EXPECT_THROW(writer->Commit(), Error);
  EXPECT_EQ(CodeOf([&] { store->NewBlob(); }), Code::kUnavailable);
  EXPECT_TRUE(std::filesystem::is_empty(disk.folder() / "incoming"));
  EXPECT_EQ(store->health(), "");
  disk.FailAt(0, Fault::kNone);  // there is space again
  EXPECT_EQ(store->PutDocument(Recipe("a", "x")).version, 1);
}

TEST(StoreFaultTest, DatabaseOnAFullDiskIsNamedAndReadingGoesOn) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  const std::unique_ptr<Store> store = OpenOn(disk);
  store->PutDocument(Recipe("a", "kept"));
  store->PutDocument(Recipe("c", "deleted in vain"));
  disk.FailAt(1, Fault::kFull);
  const Error error = ErrorOf([&] { store->DeleteDocument(kRecipe, "c"); });
  EXPECT_EQ(error.code(), Code::kUnavailable);
  EXPECT_THAT(error.what(), HasSubstr("disk is full"));
  EXPECT_THAT(store->health(), HasSubstr("disk is full"));
  disk.FailAt(0, Fault::kNone);  // there is space again, but the store stays shut
  EXPECT_EQ(CodeOf([&] { store->PutDocument(Recipe("b", "x")); }), Code::kUnavailable);
  EXPECT_EQ(store->ReadBlob(store->FindDocument(kRecipe, "a")->blob.sha256), "kept");
  EXPECT_EQ(store->ListDocuments(kRecipe).size(), 2U);
}

TEST(StoreFaultTest, RefusalsDoNotEndWriting) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  const std::unique_ptr<Store> store = OpenOn(disk);
  EXPECT_THROW(store->PutDocument(Recipe("a", "x", "*")), Error);
  EXPECT_THROW(store->PutDocument(Recipe("a/b", "x")), Error);
  EXPECT_THROW(store->DeleteDocument(kRecipe, "a"), Error);
  EXPECT_EQ(store->health(), "");
  EXPECT_EQ(store->PutDocument(Recipe("a", "x")).version, 1);
}

TEST(StoreFaultTest, BlobIsDurableBeforeTheRowThatRefersToIt) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  const std::unique_ptr<Store> store = OpenOn(disk);
  store->PutDocument(Recipe("a", "before"));
  const std::string sha256 = Sha256Hex("bytes");
  std::vector<std::string> steps;
  disk.set_observer([&](std::string_view operation, const std::filesystem::path& path) {
    const std::string name = path.lexically_relative(disk.folder()).string();
    const std::string step = std::string(operation) + " " + name;
    if (steps.empty() || steps.back() != step) steps.push_back(step);
  });
  store->PutDocument(Recipe("a", "bytes"));
  disk.set_observer(nullptr);
  const std::string subfolder = "blobs/" + sha256.substr(0, 2);
  EXPECT_THAT(steps, ::testing::ElementsAre("create incoming/2", "write incoming/2",
                                            "sync incoming/2", "mkdir " + subfolder,
                                            "sync-folder " + subfolder, "sync-folder blobs",
                                            "rename " + subfolder + "/" + sha256.substr(2),
                                            "sync-folder " + subfolder, "sync-folder incoming",
                                            "write lares.sqlite-wal", "sync lares.sqlite-wal"));
}

// Holds the writer inside the sync of its log until a reader has answered.
TEST(StoreFaultTest, ReadersDoNotWaitForTheWritersDisk) {
  const TemporaryFolder folder(FastFolder());
  SimulatedDisk disk(folder.path());
  const std::unique_ptr<Store> store = OpenOn(disk);
  store->PutDocument(Recipe("a", "old"));
  std::mutex mutex;
  std::condition_variable changed;
  bool syncing = false;
  bool answered = false;
  disk.set_observer([&](std::string_view operation, const std::filesystem::path& path) {
    if (operation != "sync" || path.extension() != ".sqlite-wal") return;
    std::unique_lock lock(mutex);
    syncing = true;
    changed.notify_all();
    changed.wait(lock, [&] { return answered; });
  });
  std::thread writer([&] { store->PutDocument(Recipe("a", "new")); });
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return syncing; });
  }
  EXPECT_EQ(store->FindDocument(kRecipe, "a")->version, 1);
  EXPECT_EQ(store->ListDocuments(kRecipe).size(), 1U);
  {
    const std::lock_guard lock(mutex);
    answered = true;
    changed.notify_all();
  }
  writer.join();
  EXPECT_EQ(store->FindDocument(kRecipe, "a")->version, 2);
}

}  // namespace
}  // namespace lares::store::testing
