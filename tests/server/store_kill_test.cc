// A process that writes is killed at any moment, again and again (LARES_KILLS times, 20 without);
// what it had acknowledged is there. Once over SQLite, once beside another process over PostgreSQL.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "server/store/sqlite_store.h"
#include "tests/server/store_fixture.h"
#include "tests/server/store_ledger.h"

namespace lares::store::testing {
namespace {

using ::testing::IsEmpty;

// Of so many kills the writes are counted too.
constexpr int kManyKills = 100;
constexpr int kWriters = 2;
constexpr int kSurvivor = 10;  // the first writer of the process that is not killed
constexpr DocumentKind kRecipe = DocumentKind::kRecipe;

int Kills() {
  const char* kills = std::getenv("LARES_KILLS");
  return kills == nullptr ? 20 : std::max(1, std::atoi(kills));
}

using Opener = std::function<std::unique_ptr<Store>()>;

std::unique_ptr<Store> Open(const std::filesystem::path& folder) {
  Seams seams;
  seams.checkpoint_pages = 40;  // so that kills meet checkpoints too
  return OpenSqliteStore({folder}, seams);
}

// Bytes that a short tag stands for: some short, some of several pages.
std::string Content(const std::string& tag) {
  std::string content;
  for (std::size_t i = 0; i < 1 + std::hash<std::string>()(tag) % 4000; ++i) content += tag;
  return content;
}

// --- The process that is killed: says on the pipe what it begins and what was acknowledged -----

class ChildWriter {
 public:
  ChildWriter(Store& store, int pipe, int writer, unsigned seed)
      : store_(store), pipe_(pipe), writer_(std::to_string(writer)), random_(seed) {}

  void Run() {
    for (int i = 0;; ++i) {
      const std::string tag = writer_ + "-" + std::to_string(random_()) + "-" + std::to_string(i);
      switch (random_() % 4) {
        case 0:
          PutDocument("document-" + writer_, tag);
          break;
        case 1:
          DeleteDocument("document-" + writer_);
          break;
        case 2:
          PutVersion("room-" + writer_, tag, {"semantic", "grid"});
          break;
        default:
          PutVersion("room-" + writer_, tag, {"semantic"});
          break;
      }
    }
  }

 private:
  // One write for each line, so that a line is whole or absent.
  void Say(const std::string& what) {
    const std::string line = writer_ + " " + what + "\n";
    if (::write(pipe_, line.data(), line.size()) < 0) ::_exit(4);
  }
  void PutDocument(const std::string& id, const std::string& tag) {
    Say("begin " + id);
    const DocumentInfo info = store_.PutDocument(Recipe(id, Content(tag)));
    Say("document " + id + " " + std::to_string(info.version) + " " + tag);
  }
  void DeleteDocument(const std::string& id) {
    if (!store_.FindDocument(kRecipe, id)) return;
    Say("begin " + id);
    store_.DeleteDocument(kRecipe, id);
    Say("deleted " + id);
  }
  void PutVersion(const std::string& id, const std::string& tag,
                  const std::vector<std::string>& names) {
    std::vector<LayerInfo> layers;
    for (const std::string& name : names) {
      const auto writer = store_.NewBlob();
      writer->Append(Content(tag + name));
      layers.push_back(Layer(name, writer->Commit()));
      Say("blob " + layers.back().blob.sha256 + " " + tag + name);
    }
    Say("begin " + id);
    const EnvironmentVersion version = store_.PutVersion(Version(id, layers));
    std::string line = "version " + id + " " + std::to_string(version.number);
    for (const LayerInfo& layer : version.layers)
      line += " " + layer.name + " " + layer.blob.sha256;
    Say(line);
  }

  Store& store_;
  int pipe_;
  std::string writer_;
  std::minstd_rand random_;
};

// Its writers are called `first`, `first` + 1, …
[[noreturn]] void RunChild(const Opener& open, int pipe, unsigned seed, int first = 0) {
  try {
    const std::unique_ptr<Store> store = open();
    std::vector<std::thread> threads;
    for (int i = 0; i < kWriters; ++i) {
      threads.emplace_back([&, i] {
        try {
          ChildWriter(*store, pipe, first + i, seed * 100 + static_cast<unsigned>(i)).Run();
        } catch (const std::exception& error) {
          std::fprintf(stderr, "writer %d: %s\n", i, error.what());
          ::_exit(3);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "child: %s\n", error.what());
  }
  ::_exit(2);
}

// --- The process that kills and checks ---------------------------------------------------------

struct Heard {
  Ledger ledger;
  std::map<std::string, std::string> under_way;  // by writer
  int acknowledged = 0;
};

void Hear(const std::string& line, Heard& heard) {
  std::istringstream words(line);
  std::string writer, what, id;
  words >> writer >> what >> id;
  if (what == "begin") {
    heard.under_way[writer] = id;
    return;
  }
  ++heard.acknowledged;
  if (what == "blob") {
    std::string tag;
    words >> tag;
    heard.ledger.blobs[id] = Content(tag);
    return;
  }
  heard.under_way.erase(writer);
  std::size_t number = 0;
  if (what == "document") {
    std::string tag;
    words >> number >> tag;
    auto& versions = heard.ledger.documents[id];
    EXPECT_EQ(number, versions.size() + 1) << line;
    versions.push_back(Content(tag));
    heard.ledger.deleted[id] = false;
  } else if (what == "deleted") {
    heard.ledger.deleted[id] = true;
  } else if (what == "version") {
    words >> number;
    auto& versions = heard.ledger.environments[id];
    EXPECT_EQ(number, versions.size() + 1) << line;
    versions.emplace_back();
    for (std::string name, sha256; words >> name >> sha256;) versions.back()[name] = sha256;
  } else {
    ADD_FAILURE() << "not understood: " << line;
  }
}

// Listens until `enough` acknowledgements, kills, and listens to what was still in the pipe.
void ListenAndKill(pid_t child, int pipe, int enough, std::chrono::microseconds then,
                   Heard& heard) {
  std::string pending;
  bool killed = false;
  const int before = heard.acknowledged;
  const auto kill_when_due = [&] {
    if (killed || heard.acknowledged - before < enough) return;
    std::this_thread::sleep_for(then);
    ::kill(child, SIGKILL);
    killed = true;
  };
  kill_when_due();
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
    if (count <= 0) break;
    pending.append(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end; (end = pending.find('\n')) != std::string::npos;) {
      Hear(pending.substr(0, end), heard);
      pending.erase(0, end + 1);
    }
    kill_when_due();
  }
  EXPECT_EQ(pending, "");
}

struct Child {
  pid_t pid = -1;
  int pipe = -1;
};

Child StartChild(const Opener& open, unsigned seed, int first = 0) {
  int pipe[2];
  if (::pipe(pipe) != 0) throw std::runtime_error("no pipe");
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::close(pipe[0]);
    RunChild(open, pipe[1], seed, first);
  }
  ::close(pipe[1]);
  return {pid, pipe[0]};
}

void ExpectKilled(const Child& child) {
  ::close(child.pipe);
  int status = 0;
  ASSERT_EQ(::waitpid(child.pid, &status, 0), child.pid);
  ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "it ended by itself";
}

std::set<std::string> UnderWay(const Heard& heard) {
  std::set<std::string> ids;
  for (const auto& [writer, id] : heard.under_way) ids.insert(id);
  return ids;
}

TEST(StoreKillTest, EveryAcknowledgedWriteSurvivesKills) {
  const TemporaryFolder folder;
  const Opener open = [&] { return Open(folder.path()); };
  const int kills = Kills();
  Heard heard;
  std::mt19937 random(20);
  for (int round = 0; round < kills; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    // Some are killed while they open.
    const int enough = round % 5 == 0 ? 0 : static_cast<int>(random() % 60);
    const std::chrono::microseconds then(random() % 15000);
    const Child child = StartChild(open, static_cast<unsigned>(round) + 1);
    ListenAndKill(child.pid, child.pipe, enough, then, heard);
    ExpectKilled(child);

    const std::unique_ptr<Store> store = open();
    const std::set<std::string> under_way = UnderWay(heard);
    ASSERT_THAT(Missing(*store, heard.ledger, under_way), IsEmpty());
    // It reads all bytes: with many kills not each time.
    if (kills < kManyKills || round % 25 == 0 || round + 1 == kills) {
      ASSERT_THAT(store->Verify(), IsEmpty());
    }
    Absorb(*store, under_way, heard.ledger);
    heard.under_way.clear();
  }
  EXPECT_GT(heard.acknowledged, kills < kManyKills ? 10 * kills : 20 * kills);
  std::printf("%d kills, %d acknowledged writes\n", kills, heard.acknowledged);
}

// Reads whatever version there is, over and over, until it is told to stop: every one has to be
// whole, its bytes those of its hash.
int ReadAll(Store& store, const std::atomic<bool>& stop) {
  int reads = 0;
  while (!stop) {
    for (const EnvironmentInfo& info : store.ListEnvironments()) {
      const EnvironmentVersion version = store.GetVersion(info.id, 0);
      EXPECT_GE(version.number, info.latest);
      EXPECT_FALSE(version.layers.empty());
      for (const LayerInfo& layer : version.layers) {
        EXPECT_EQ(store.ReadBlob(layer.blob.sha256).size(), layer.blob.size);
        ++reads;
      }
    }
    for (const DocumentInfo& document : store.ListDocuments(kRecipe)) {
      EXPECT_EQ(store.ReadBlob(document.blob.sha256).size(), document.blob.size);
      ++reads;
    }
  }
  return reads;
}

TEST(StoreKillTest, TwoProcessesOverOnePostgresLoseNothingWhenOneIsKilledAgainAndAgain) {
  const TemporaryFolder blobs(FastFolder());
  const std::string connection = SharedPostgres().NewDatabase();
  const Opener open = [&] { return OpenPostgresStore({connection, blobs.path()}); };
  Heard steady;
  Heard killed;
  for (const char* kind : {"document-", "room-"}) {
    for (int i = 0; i < kWriters; ++i) {
      killed.ledger.of_others.insert(kind + std::to_string(kSurvivor + i));
      steady.ledger.of_others.insert(kind + std::to_string(i));
    }
  }
  const Child survivor = StartChild(open, 7777, kSurvivor);
  std::thread listener([&] { ListenAndKill(survivor.pid, survivor.pipe, INT_MAX, {}, steady); });
  std::atomic<bool> stop = false;
  int reads = 0;
  std::thread reader([&] {
    const std::unique_ptr<Store> store = open();
    reads = ReadAll(*store, stop);
  });
  std::mt19937 random(21);
  const int kills = Kills();
  for (int round = 0; round < kills; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const int enough = round % 5 == 0 ? 0 : static_cast<int>(random() % 30);
    const Child child = StartChild(open, static_cast<unsigned>(round) + 1);
    ListenAndKill(child.pid, child.pipe, enough, std::chrono::microseconds(random() % 15000),
                  killed);
    ExpectKilled(child);
    const std::unique_ptr<Store> store = open();
    const std::set<std::string> under_way = UnderWay(killed);
    EXPECT_THAT(Missing(*store, killed.ledger, under_way), IsEmpty());
    Absorb(*store, under_way, killed.ledger);
    killed.under_way.clear();
    if (::testing::Test::HasFailure()) break;
  }
  ::kill(survivor.pid, SIGKILL);
  listener.join();
  ExpectKilled(survivor);
  stop = true;
  reader.join();
  const std::unique_ptr<Store> store = open();
  EXPECT_THAT(Missing(*store, steady.ledger, UnderWay(steady)), IsEmpty());
  EXPECT_THAT(store->Verify(), IsEmpty());
  EXPECT_GT(steady.acknowledged, 100);
  EXPECT_GT(killed.acknowledged, kills);
  EXPECT_GT(reads, 100);
  std::printf("%d kills, %d acknowledged writes, %d reads\n", kills,
              steady.acknowledged + killed.acknowledged, reads);
}

}  // namespace
}  // namespace lares::store::testing
