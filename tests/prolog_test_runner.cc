// Runs a .plt file in the embedded Prolog, over facts from N-Triples files:
//
//     prolog_test_runner FILE.plt [FACTS.nt]…
//
// Each facts file is a graph named after its stem, all in one layer; what is in FACTS.inferred.nt
// counts as inferred. The bundled rule modules are there as rules(NAME). Exits with 0 when all
// tests passed, 1 when one failed, warned or none ran, 2 for a wrong call or an unreadable file.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "reasoner/prolog/runtime.h"
#include "tests/n_triples.h"

namespace lares {
namespace {

rdf::View ReadFacts(const std::vector<std::filesystem::path>& files) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  std::vector<rdf::Graph> graphs;
  std::vector<rdf::Triple> inferred;
  for (const std::filesystem::path& file : files) {
    std::vector<rdf::Triple> triples =
        testing::ReadNTriples(ReadFile(file), file.string(), *dictionary);
    if (file.stem().extension() == ".inferred") {
      inferred.insert(inferred.end(), triples.begin(), triples.end());
    } else {
      graphs.push_back({file.stem().string(), std::move(triples), {}});
    }
  }
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(std::move(graphs), std::move(inferred),
                                               std::vector<rdf::Clash>{}));
}

bool RunTests(const std::filesystem::path& plt, const rdf::View& view) {
  prolog::LoadRuleFile(LARES_SOURCE_DIR "/tests/prolog_test_runner.pl");
  prolog::EnginePool pool(prolog::Options{.engines = 1});
  const prolog::Value file{prolog::Atom{std::filesystem::absolute(plt).string()}};
  return pool
      .Once(view, "prolog_test_runner", "run_plt", {file},
            prolog::Limits{.time = std::chrono::minutes(10)})
      .has_value();
}

}  // namespace
}  // namespace lares

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: prolog_test_runner FILE.plt [FACTS.nt]...\n");
    return 2;
  }
  try {
    return lares::RunTests(argv[1], lares::ReadFacts({argv + 2, argv + argc})) ? 0 : 1;
  } catch (const lares::Error& error) {
    std::fprintf(stderr, "%s\n", error.FullMessage().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 2;
}
