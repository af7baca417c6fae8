// Rows (measure.h tells their form) of an environment version of 1 000 objects (15 000 triples)
// beside 1 000 stored environments like it: until it is visible, until it is taken back, what of
// that is the durable write and the reading, and what a reader notices meanwhile.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "benchmarks/measure.h"
#include "ontology/rdf/reader.h"
#include "server/knowledge/knowledge.h"

namespace {

namespace fs = std::filesystem;
using namespace lares;
using bench::SecondsOf;

constexpr int kStored = 1000;
constexpr int kObjects = 1000;

// 600 of 1 000 objects have a pose (19 triples each), the others a size and a place that they are
// part of (9 each): 15 triples an object.
std::string Map(int number, int objects) {
  std::string text =
      "@prefix lares: <https://w3id.org/lares#> .\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
      "@prefix : <http://example.org/map" +
      std::to_string(number) + "#> .\n:map a lares:SemanticEnvironmentMap .\n";
  for (int i = 0; i < objects; ++i) {
    const std::string name = ":o" + std::to_string(i);
    text += name + " a lares:Cup ; lares:describedInMap :map ; ";
    if (i % 5 >= 3) {
      text += "rdfs:label \"cup " + std::to_string(i) +
              "\" ; lares:depthOfObject 0.1 ; lares:widthOfObject 0.1 ; lares:heightOfObject 0.12 "
              "; lares:existenceProbability 0.9 ; lares:roomNumber \"" +
              std::to_string(i % 50) + "\" ; lares:properPhysicalPartOf :o" +
              std::to_string(i - i % 5) + " .\n";
      continue;
    }
    text += "lares:orientation " + name + "_m .\n" + name + "_m lares:m00 1.0";
    for (int k = 1; k < 16; ++k) {
      const std::string value = k % 4 == 3 && k < 12
                                    ? std::to_string(i % 97) + "." + std::to_string(k)
                                : k % 5 == 0 ? "1.0"
                                             : "0.0";
      text += " ; lares:m" + std::to_string(k / 4) + std::to_string(k % 4) + " " + value;
    }
    text += " .\n";
  }
  return text;
}

store::NewVersion Version(store::Store& store, const std::string& name, const std::string& map) {
  const auto writer = store.NewBlob();
  writer->Append(map);
  store::NewVersion version;
  version.environment = name;
  version.layers.push_back({"semantic", "map.ttl", "", writer->Commit(), {}});
  return version;
}

// A reader that asks on and on; when it ends, the longest that an answer took, in ms.
class Reader {
 public:
  explicit Reader(server::Knowledge& knowledge)
      : thread_([this, &knowledge] {
          while (!stop_) {
            longest_ = std::max(longest_, 1e3 * SecondsOf([&] {
                                            knowledge.ViewFor({"", "", "flat-0", 0});
                                          }));
            std::this_thread::sleep_for(std::chrono::microseconds(200));
          }
        }) {}
  double Longest() {
    stop_ = true;
    thread_.join();
    return longest_;
  }

 private:
  std::atomic<bool> stop_ = false;
  double longest_ = 0;
  std::thread thread_;
};

void Measure(const std::string& folder) {
  const auto store = store::OpenSqliteStore({folder});
  prolog::EnginePool engines;
  server::Knowledge knowledge(*store, engines);
  for (int i = 0; i < kStored; ++i) {
    store->PutVersion(Version(*store, "flat-" + std::to_string(i), Map(i, kObjects)));
  }
  knowledge.ViewFor({"", "", "flat-0", 0});
  std::vector<double> write, read, put, ask, back, readers;
  for (int i = 0; i < 5; ++i) {
    const std::string map = Map(kStored + i, kObjects);
    const std::string name = "new-" + std::to_string(i);
    store::NewVersion version;
    const auto ms = [](const std::function<void()>& work) { return 1e3 * SecondsOf(work); };
    write.push_back(ms([&] { version = Version(*store, name, map); }));
    read.push_back(ms([&] { rdf::ReadRdf(map, rdf::Format::kTurtle, {}); }));
    Reader reader(knowledge);
    put.push_back(ms([&] { knowledge.PutVersion(version); }));
    ask.push_back(ms([&] { knowledge.ViewFor({"", "", name, 0}); }));
    const store::NewVersion bare = Version(*store, name, Map(kStored + i, 1));
    back.push_back(ms([&] { knowledge.PutVersion(bare); }));
    readers.push_back(reader.Longest());
  }
  bench::Row("an overlay of 1 000 objects beside 1 000 such, to visible", "<", 50, "ms",
             bench::MedianOf(put));
  bench::Note("  … of which parsing 15 000 triples", "ms", bench::MedianOf(read));
  bench::Note("  … the durable write of its blob, apart", "ms", bench::MedianOf(write));
  bench::Note("  … the first question's view", "ms", bench::MedianOf(ask));
  bench::Row("  … removed", "<", 20, "ms", bench::MedianOf(back));
  bench::Row("  … a reader of another, the longest answer meanwhile", "<", 10, "ms",
             bench::MedianOf(readers));
}

}  // namespace

int main() {
  try {
    const bench::TemporaryFolder folder;
    Measure(folder.path());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "overlay_bench: %s\n", error.what());
    return 2;
  }
}
