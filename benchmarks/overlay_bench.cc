// An environment version of 700 objects (15 000 triples) beside 1 000 stored environments:
// milliseconds, median of five, until it is visible, and what of that is the durable write and the
// reading.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "server/knowledge/knowledge.h"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace lares;

constexpr int kStored = 1000;
constexpr int kObjects = 700;

double Ms(const std::function<void()>& work) {
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void Row(const char* what, const char* to_reach, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::printf("%-52s %-8s %9.2f ms\n", what, to_reach, values[values.size() / 2]);
}

// Objects with a class, a label and a pose as the maps of Lares have it: 22 triples each.
std::string Map(int number, int objects) {
  std::string text =
      "@prefix lares: <https://w3id.org/lares#> .\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
      "@prefix : <http://example.org/map" +
      std::to_string(number) + "#> .\n:map a lares:SemanticEnvironmentMap .\n";
  for (int i = 0; i < objects; ++i) {
    const std::string name = ":o" + std::to_string(i);
    text += name + " a lares:Cup ; lares:describedInMap :map ; rdfs:label \"cup " +
            std::to_string(i) + "\" .\n" + name + "_p a lares:SemanticMapPerception ; " +
            "lares:objectActedOn " + name + " ; lares:eventOccursAt " + name + "_m .\n" + name +
            "_m a lares:RotationMatrix3D";
    for (int k = 0; k < 16; ++k) {
      const char digit = k % 4 == 3 && k < 12 ? static_cast<char>('0' + i % 7)
                         : k % 5 == 0         ? '1'
                                              : '0';
      text += std::string(" ; lares:m") + std::to_string(k / 4) + std::to_string(k % 4) + " " +
              digit + ".0";
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

void Measure(const std::string& folder) {
  const auto store = store::OpenSqliteStore({folder});
  prolog::EnginePool engines;
  server::Knowledge knowledge(*store, engines);
  for (int i = 0; i < kStored; ++i) {
    store->PutVersion(Version(*store, "flat-" + std::to_string(i), Map(i, 1)));
  }
  std::vector<double> write, read, put, ask, empty;
  for (int i = 0; i < 5; ++i) {
    const std::string map = Map(kStored + i, kObjects);
    const std::string name = "new-" + std::to_string(i);
    store::NewVersion version;
    write.push_back(Ms([&] { version = Version(*store, name, map); }));
    read.push_back(Ms([&] { rdf::ReadRdf(map, rdf::Format::kTurtle, {}); }));
    put.push_back(Ms([&] { knowledge.PutVersion(version); }));
    ask.push_back(Ms([&] { knowledge.ViewFor({"", "", name, 0}); }));
    const store::NewVersion bare = Version(*store, name, Map(kStored + i, 1));
    empty.push_back(Ms([&] { knowledge.PutVersion(bare); }));
  }
  Row("the durable write of its blob", "-", write);
  Row("put: read, closed, understood, written, visible", "< 50", put);
  Row("  of which parsing", "-", read);
  Row("the first question's view", "-", ask);
  Row("taken back: a version without these objects put", "< 20", empty);
}

}  // namespace

int main() {
  try {
    std::string folder = (fs::temp_directory_path() / "lares-bench-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) throw Error(Code::kIo, "no temporary folder");
    Measure(folder);
    fs::remove_all(folder);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "overlay_bench: %s\n", error.what());
    return 2;
  }
}
