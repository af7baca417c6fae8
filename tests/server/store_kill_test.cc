// A process that writes is killed at any moment, twenty times; what it had acknowledged is there.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <random>
#include <sstream>
#include <thread>

#include "server/store/sqlite_store.h"
#include "tests/server/store_fixture.h"
#include "tests/server/store_ledger.h"

namespace lares::store::testing {
namespace {

using ::testing::IsEmpty;

constexpr int kKills = 20;
constexpr int kWriters = 2;
constexpr DocumentKind kRecipe = DocumentKind::kRecipe;

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

[[noreturn]] void RunChild(const std::filesystem::path& folder, int pipe, unsigned seed) {
  try {
    const std::unique_ptr<Store> store = Open(folder);
    std::vector<std::thread> threads;
    for (int i = 0; i < kWriters; ++i) {
      threads.emplace_back([&, i] {
        try {
          ChildWriter(*store, pipe, i, seed * 100 + static_cast<unsigned>(i)).Run();
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

TEST(StoreKillTest, EveryAcknowledgedWriteSurvivesTwentyKills) {
  const TemporaryFolder folder;
  Heard heard;
  std::mt19937 random(20);
  for (int round = 0; round < kKills; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    // Some are killed while they open.
    const int enough = round % 5 == 0 ? 0 : static_cast<int>(random() % 40);
    const std::chrono::microseconds then(random() % 15000);
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(pipe[0]);
      RunChild(folder.path(), pipe[1], static_cast<unsigned>(round) + 1);
    }
    ::close(pipe[1]);
    ListenAndKill(child, pipe[0], enough, then, heard);
    ::close(pipe[0]);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "it ended by itself";

    const std::unique_ptr<Store> store = Open(folder.path());
    std::set<std::string> under_way;
    for (const auto& [writer, id] : heard.under_way) under_way.insert(id);
    ASSERT_THAT(Missing(*store, heard.ledger, under_way), IsEmpty());
    ASSERT_THAT(store->Verify(), IsEmpty());
    Absorb(*store, under_way, heard.ledger);
    heard.under_way.clear();
  }
  EXPECT_GT(heard.acknowledged, 200);
}

}  // namespace
}  // namespace lares::store::testing
