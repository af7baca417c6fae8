// In-process rows of `benchmarks/run reasoner` (measure.h tells their form): closures, proofs,
// queries, and the same file beside SWI-Prolog. The argument tells which; `memory` needs a process
// of its own. Data is what LARES_DATA names; what needs it is left out, visibly, without it.
#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/search_path.h"
#include "benchmarks/measure.h"
#include "benchmarks/university.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/prover.h"
#include "reasoner/sparql/query.h"
#include "tests/reasoner/lubm.h"

namespace lares::bench {
namespace {

namespace fs = std::filesystem;
using LayerPtr = std::shared_ptr<const rdf::Layer>;

std::optional<fs::path> Data(const char* folder) {
  const char* data = std::getenv("LARES_DATA");
  if (data != nullptr) return fs::path(data) / folder;
  std::cerr << "LARES_DATA is not set: what needs " << folder << " is left out\n";
  return std::nullopt;
}

rdf::Graph GraphOf(const std::string& bytes, const std::string& name, rdf::Dictionary& dictionary,
                   const rdf::AliasTable& aliases = {}) {
  rdf::ReadOptions options;
  options.source = name;
  options.base_iri = "http://example.org/" + name;
  const rdf::Format format = rdf::GuessFormat("", name, bytes);
  return rdf::MakeGraph(rdf::ReadRdf(bytes, format, options), name, aliases, dictionary);
}

// ---- Closures -----------------------------------------------------------------------------------

struct Universities {
  std::shared_ptr<rdf::Dictionary> dictionary;
  std::vector<rdf::Graph> graphs;

  explicit Universities(
      int count, std::shared_ptr<rdf::Dictionary> terms = std::make_shared<rdf::Dictionary>())
      : dictionary(std::move(terms)) {
    graphs.push_back(GraphOf(UniversityOntology(), "ontology.ttl", *dictionary));
    for (int i = 0; i < count; ++i) {
      graphs.push_back(
          GraphOf(University(i), "university-" + std::to_string(i) + ".nt", *dictionary));
    }
  }
  LayerPtr Close() const { return owl::Materialise(rdf::View(dictionary), graphs); }
};

// Microseconds for each triple, explicit or inferred.
double TimePerTriple(const Universities& all) {
  LayerPtr layer;
  const double seconds = SecondsOf([&] { layer = all.Close(); });
  return 1e6 * seconds / static_cast<double>(layer->size());
}

void MeasureLubmClosure(const fs::path& lubm) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const std::string ontology = ReadFile(lubm / "ontology/univ-bench.ttl");
  const std::string data = testing::LubmData(lubm);
  const std::vector<rdf::Graph> graphs = {GraphOf(ontology, "univ-bench.ttl", *dictionary),
                                          GraphOf(data, "lubm.nt", *dictionary)};
  LayerPtr layer;
  const auto close = [&] { layer = owl::Materialise(rdf::View(dictionary), graphs); };
  const double seconds = MedianOfFive([&] { return SecondsOf(close); });
  Row("LUBM(1): closure of " + std::to_string(graphs[1].triples.size()) + " triples", "<", 0.5, "s",
      seconds);
  Note("  … triples explicit and inferred", "triples", static_cast<double>(layer->size()));
}

void MeasureChain() {
  std::string text = "<http://e/p> a <http://www.w3.org/2002/07/owl#TransitiveProperty> .\n";
  for (int i = 0; i < 500; ++i) {
    text += "<http://e/x" + std::to_string(i) + "> <http://e/p> <http://e/x" +
            std::to_string(i + 1) + "> .\n";
  }
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::Graph graph = GraphOf(text, "chain.ttl", *dictionary);
  Row("a chain of 500 transitive links, closed", "<", 100, "ms", MedianOfFive([&] {
        return 1e3 * SecondsOf([&] { owl::Materialise(rdf::View(dictionary), {graph}); });
      }));
}

void MeasureRobots(const fs::path& roboearth) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const rdf::AliasTable aliases =
      rdf::AliasTable::FromTsv(ReadFile(FindShared("ontology/aliases.tsv")), "aliases.tsv");
  const auto read = [&](const char* path) {
    const std::string name = fs::path(path).filename().string();
    return GraphOf(ReadFile(roboearth / path), name, *dictionary, aliases);
  };
  std::vector<rdf::Graph> graphs;
  for (const char* path : {"ontology/knowrob.owl", "ontology/roboearth.owl", "srdl/srdl2.owl",
                           "srdl/srdl2-comp.owl", "srdl/srdl2-cap.owl", "srdl/srdl2-action.owl"}) {
    graphs.push_back(read(path));
  }
  const rdf::View empty(dictionary);
  const rdf::View catalogue = empty.With(owl::Materialise(empty, graphs));
  for (const char* robot : {"amigo", "PR2"}) {
    const rdf::Graph graph = read((std::string("robots/") + robot + ".owl").c_str());
    Row(std::string(robot) + ".owl over RoboEarth's ontologies, closed", "<", 100, "ms",
        MedianOfFive(
            [&] { return 1e3 * SecondsOf([&] { owl::Materialise(catalogue, {graph}); }); }));
  }
}

void MeasureClosures() {
  if (const auto lubm = Data("conformance/lubm")) MeasureLubmClosure(*lubm);
  const Universities small(1), large(10);
  std::vector<double> ones, tens;  // by turns, so that both see the same machine
  for (int i = 0; i < 5; ++i) {
    ones.push_back(TimePerTriple(small));
    tens.push_back(TimePerTriple(large));
  }
  const double one = MedianOf(ones), ten = MedianOf(tens);
  Note("our universities: closure of 1", "us/triple", one);
  Note("our universities: closure of 10", "us/triple", ten);
  Row("  … time per triple, 10 against 1", "<", 1.5, "times", ten / one);
  MeasureChain();
  if (const auto roboearth = Data("roboearth")) MeasureRobots(*roboearth);
}

// ---- Memory -------------------------------------------------------------------------------------

double ResidentBytes() {
  ::malloc_trim(0);
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// Prints bytes for each triple, explicit or inferred, dictionary included.
void MeasureMemory() {
  Universities(0).Close();  // what starts with the first use is not a triple's
  const double before = ResidentBytes();
  rdf::View view(std::make_shared<rdf::Dictionary>());
  {
    std::vector<rdf::Graph> graphs = Universities(10, view.shared_dictionary()).graphs;
    view = view.With(owl::Materialise(view, std::move(graphs)));
  }
  std::printf("%.6g\n", (ResidentBytes() - before) / static_cast<double>(view.size()));
}

// ---- Proofs -------------------------------------------------------------------------------------

void MeasureProofs() {
  const auto lubm = Data("conformance/lubm");
  if (!lubm) return;
  const rdf::View view = testing::ReadLubm(*lubm, std::make_shared<rdf::Dictionary>());
  std::vector<std::pair<double, rdf::Triple>> times;
  const auto prove = [&](const rdf::Triple& triple) {
    return 1e3 * SecondsOf([&] {
             if (!owl::Prover(view).Why(triple)) throw Error(Code::kInternal, "no proof");
           });
  };
  view.ForEach({}, [&](const rdf::Triple& triple) {
    if (!view.IsAsserted(triple)) times.emplace_back(prove(triple), triple);
    return true;
  });
  std::sort(times.begin(), times.end(), [](auto& a, auto& b) { return a.first > b.first; });
  Note("why: inferred triples of LUBM(1) asked, each once", "proofs",
       static_cast<double>(times.size()));
  Note("  … median", "ms", times[times.size() / 2].first);
  double slowest = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(50, times.size()); ++i) {
    slowest = std::max(slowest, MedianOfFive([&] { return prove(times[i].second); }));
  }
  Row("why, the slowest of them", "<", 10, "ms", slowest);
}

// ---- Queries ------------------------------------------------------------------------------------

void MeasureQueries() {
  const auto lubm = Data("conformance/lubm");
  if (!lubm) return;
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  const sparql::Dataset dataset{testing::ReadLubm(*lubm, dictionary), {}};
  int exact = 0;
  double slowest = 0;
  for (int number = 1; number <= 14; ++number) {
    const std::string text = testing::LubmQuery(*lubm, number);
    std::vector<std::string> found;
    const auto ask = [&] {
      found.clear();
      sparql::Select(sparql::Parse(text), dataset, {}, {}, [&](sparql::Cells cells) {
        std::string line;
        for (const auto& cell : cells) line.append(line.empty() ? "" : ",").append(cell->value);
        found.push_back(std::move(line));
        return true;
      });
    };
    ask();
    slowest = std::max(slowest, MedianOfFive([&] { return 1e3 * SecondsOf(ask); }));
    std::sort(found.begin(), found.end());
    exact += found == testing::LubmAnswers(*lubm, number) ? 1 : 0;
  }
  Row("LUBM(1): queries whose answers are exact", ">=", 14, "of 14", exact);
  Row("SPARQL: the slowest of the 14, warm, parsed and planned anew", "<", 50, "ms", slowest);
  const std::string lookup =
      "PREFIX ub: <http://www.lehigh.edu/~zhp2/2004/0401/univ-bench.owl#>\n"
      "SELECT ?name WHERE { "
      "<http://www.Department0.University0.edu/FullProfessor7> ub:name ?name }";
  constexpr int kTimes = 1000;
  Row("SPARQL: a lookup, parsed, planned and answered", "<", 0.2, "ms", MedianOfFive([&] {
        return 1e3 / kTimes * SecondsOf([&] {
                 for (int i = 0; i < kTimes; ++i) sparql::Evaluate(sparql::Parse(lookup), dataset);
               });
      }));
}

// ---- Beside SWI-Prolog --------------------------------------------------------------------------

// Seconds to load the N-Triples `file` (explicit triples alone, as rdf_db has them), seconds to
// match, and the answers found: what benchmarks/rdf_db_bench.pl does.
void MeasureLoadAndMatch(const std::string& file) {
  const std::string bytes = ReadFile(file);
  std::vector<double> load, match;
  std::size_t found = 0;
  for (int i = 0; i < 5; ++i) {
    const auto dictionary = std::make_shared<rdf::Dictionary>();
    rdf::View view(dictionary);
    load.push_back(SecondsOf([&] {
      std::vector<rdf::Graph> graphs;
      graphs.push_back(GraphOf(bytes, "data.nt", *dictionary));
      view = view.With(std::make_shared<rdf::Layer>(std::move(graphs), std::vector<rdf::Triple>{},
                                                    std::vector<rdf::Clash>{}));
    }));
    const std::vector<rdf::Triple> all = view.Match({});
    found = 0;
    match.push_back(SecondsOf([&] {
      for (const rdf::Triple& triple : all) {
        const auto count = [&](const rdf::Triple&) { return ++found > 0; };
        view.ForEach({triple.subject, triple.predicate, {}}, count);
        view.ForEach({triple.subject, {}, triple.object}, count);
      }
    }));
  }
  std::printf("%.6g %.6g %zu\n", MedianOf(load), MedianOf(match), found);
}

}  // namespace
}  // namespace lares::bench

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string what = words.empty() ? "" : words[0];
  try {
    if (what == "closures") {
      lares::bench::MeasureClosures();
    } else if (what == "memory") {
      lares::bench::MeasureMemory();
    } else if (what == "proofs") {
      lares::bench::MeasureProofs();
    } else if (what == "queries") {
      lares::bench::MeasureQueries();
    } else if (what == "load-and-match" && words.size() == 2) {
      lares::bench::MeasureLoadAndMatch(words[1]);
    } else if (what == "university" && words.size() == 2) {
      std::cout << lares::bench::University(std::stoi(words[1]));
    } else {
      std::cerr << "reasoner_bench closures|memory|proofs|queries|load-and-match FILE|"
                   "university NUMBER\n";
      return 2;
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "reasoner_bench: " << error.what() << '\n';
    return 2;
  }
}
