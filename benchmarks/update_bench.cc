// Keeping a closure up against making it anew. A row says what is taken back, then milliseconds of
// the processor (median of five) to take it back, to put it back, and to make the layer anew
// without it, and how many triples the layer has before and after. Data is what LARES_DATA names;
// without it only the chain is measured. Fails when a layer kept up differs in size.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/search_path.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/update.h"
#include "tests/reasoner/lubm.h"

namespace {

namespace fs = std::filesystem;
using namespace lares;
using Layer = std::shared_ptr<const rdf::Layer>;

double MedianMs(const std::function<void()>& work) {
  std::vector<double> values;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t begin = std::clock();
    work();
    values.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::sort(values.begin(), values.end());
  return values[2];
}

class Bench {
 public:
  rdf::Graph Read(const fs::path& path, const std::string& bytes) {
    rdf::ReadOptions options;
    options.source = path.filename().string();
    options.base_iri = "http://example.org/" + options.source;
    const rdf::Format format = rdf::GuessFormat("", options.source, bytes);
    return rdf::MakeGraph(rdf::ReadRdf(bytes, format, options), options.source, aliases_,
                          *dictionary_);
  }
  rdf::Graph Read(const fs::path& path) { return Read(path, ReadFile(path)); }
  rdf::View Empty() const { return rdf::View(dictionary_); }
  rdf::TermId Iri(const std::string& iri) { return dictionary_->InternIri(iri); }

  // Takes `gone` back from `before`, then adds it again.
  void Measure(const std::string& what, const rdf::View& below, const Layer& before,
               const std::vector<rdf::Triple>& gone) {
    std::vector<rdf::Graph> graphs = before->graphs();
    for (rdf::Graph& graph : graphs) {
      std::erase_if(graph.triples, [&](const rdf::Triple& triple) {
        return std::find(gone.begin(), gone.end(), triple) != gone.end();
      });
    }
    Layer after, anew, again;
    const double out = MedianMs([&] { after = owl::Update(below, *before, graphs); });
    const double new_out = MedianMs([&] { anew = owl::Materialise(below, graphs); });
    const double in = MedianMs([&] { again = owl::Update(below, *after, before->graphs()); });
    if (after->size() != anew->size() || again->size() != before->size()) {
      throw Error(Code::kInternal, what + ": the update differs from the recomputation");
    }
    std::printf("%-44s %9.2f %9.2f %9.2f   %zu -> %zu\n", what.c_str(), out, in, new_out,
                before->size(), after->size());
    std::fflush(stdout);
  }

  std::vector<rdf::Triple> Draw(const Layer& layer, std::size_t count) {
    std::vector<rdf::Triple> drawn;
    std::mt19937 random(static_cast<unsigned>(count));
    std::vector<rdf::Triple> all;
    for (const rdf::Graph& graph : layer->graphs()) {
      all.insert(all.end(), graph.triples.begin(), graph.triples.end());
    }
    std::shuffle(all.begin(), all.end(), random);
    all.resize(std::min(count, all.size()));
    return all;
  }

  void Chain() {
    rdf::Graph graph;
    graph.name = "chain";
    const rdf::TermId part = Iri("http://example.org/partOf");
    const auto link = [&](int i) { return Iri("http://example.org/link" + std::to_string(i)); };
    graph.triples.push_back({part, Iri(std::string(rdf::kRdf) + "type"),
                             Iri(std::string(rdf::kOwl) + "TransitiveProperty")});
    for (int i = 0; i < 500; ++i) graph.triples.push_back({link(i), part, link(i + 1)});
    const Layer layer = owl::Materialise(Empty(), {graph});
    for (const int at : {0, 5, 50, 250, 499}) {
      Measure("chain of 500, link " + std::to_string(at), Empty(), layer,
              {{link(at), part, link(at + 1)}});
    }
  }

  void Lubm(const fs::path& folder) {
    const rdf::Graph schema = Read(folder / "ontology/univ-bench.ttl");
    const rdf::Graph data = Read("lubm.nt", testing::LubmData(folder));
    const Layer layer = owl::Materialise(Empty(), {schema, data});
    for (const std::size_t count : {1, 10, 100, 1000}) {
      Measure("LUBM(1), " + std::to_string(count) + " triples at random", Empty(), layer,
              Draw(layer, count));
    }
    const std::string ub = "http://www.lehigh.edu/~zhp2/2004/0401/univ-bench.owl#";
    const rdf::TermId sub = Iri(std::string(rdf::kRdfs) + "subClassOf");
    Measure("LUBM(1), Dean below Professor", Empty(), layer,
            {{Iri(ub + "Dean"), sub, Iri(ub + "Professor")}});
    Measure("LUBM(1), FullProfessor below Professor", Empty(), layer,
            {{Iri(ub + "FullProfessor"), sub, Iri(ub + "Professor")}});
    Measure("LUBM(1), Student below Person", Empty(), layer,
            {{Iri(ub + "Student"), sub, Iri(ub + "Person")}});
  }

  void RoboEarth(const fs::path& folder) {
    std::vector<rdf::Graph> graphs;
    for (const char* name :
         {"ontology/knowrob.owl", "ontology/roboearth.owl", "srdl/srdl2.owl", "srdl/srdl2-comp.owl",
          "srdl/srdl2-cap.owl", "srdl/srdl2-action.owl"}) {
      graphs.push_back(Read(folder / name));
    }
    const Layer catalogue = owl::Materialise(Empty(), graphs);
    const rdf::View below = Empty().With(catalogue);
    for (const std::size_t count : {1, 10, 100}) {
      Measure("RoboEarth's ontologies, " + std::to_string(count) + " at random", Empty(), catalogue,
              Draw(catalogue, count));
    }
    Measure("RoboEarth's ontologies, srdl2-action.owl", Empty(), catalogue, graphs[5].triples);
    const Layer pr2 = owl::Materialise(below, {Read(folder / "robots/PR2.owl")});
    for (const std::size_t count : {1, 10, 100}) {
      Measure("PR2, " + std::to_string(count) + " triples at random", below, pr2, Draw(pr2, count));
    }
    const rdf::TermId part = Iri(std::string(rdf::kLares) + "subComponent");
    std::vector<rdf::Triple> parts;
    for (const rdf::Triple& triple : pr2->graphs()[0].triples) {
      if (triple.predicate == part) parts.push_back(triple);
    }
    if (!parts.empty()) Measure("PR2, one part", below, pr2, {parts[parts.size() / 2]});
  }

 private:
  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  rdf::AliasTable aliases_ =
      rdf::AliasTable::FromTsv(ReadFile(FindShared("ontology/aliases.tsv")), "aliases.tsv");
};

}  // namespace

int main() {
  try {
    std::printf("%-44s %9s %9s %9s   %s\n", "what is taken back (ms)", "taken", "put back", "anew",
                "triples");
    Bench bench;
    bench.Chain();
    const char* data = std::getenv("LARES_DATA");
    if (data == nullptr) return 0;
    bench.Lubm(fs::path(data) / "conformance/lubm");
    bench.RoboEarth(fs::path(data) / "roboearth");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "update_bench: %s\n", error.what());
    return 2;
  }
}
