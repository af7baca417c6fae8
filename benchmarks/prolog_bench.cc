// What the Prolog edge costs: a goal's round trip, rdf/3 answers and lookups. Prints one row each.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"
#include "reasoner/prolog/runtime.h"

namespace lares {
namespace {

constexpr int kTriples = 200'000;
constexpr int kGoals = 20'000;

rdf::View MakeView() {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  rdf::Graph graph{"bench", {}, {}};
  const rdf::TermId predicate = dictionary->InternIri("http://x/property");
  for (int i = 0; i < kTriples; ++i) {
    const std::string number = std::to_string(i);
    graph.triples.push_back({dictionary->InternIri("http://x/subject-" + number), predicate,
                             dictionary->InternIri("http://x/object-" + number)});
  }
  std::sort(graph.triples.begin(), graph.triples.end());
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(
          std::vector{std::move(graph)}, std::vector<rdf::Triple>{}, std::vector<rdf::Clash>{}));
}

// Median of 5, in seconds.
double Measure(const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[2];
}

void Run() {
  const auto start = std::chrono::steady_clock::now();
  prolog::EnginePool pool;
  const std::chrono::duration<double> startup = std::chrono::steady_clock::now() - start;
  prolog::LoadRuleFile(LARES_SOURCE_DIR "/benchmarks/prolog_bench.pl");
  const rdf::View view = MakeView();
  const auto goal = [&](const char* predicate) { pool.Once(view, "prolog_bench", predicate, {}); };
  std::printf("start of Prolog from the bundled rules: %.1f ms\n", startup.count() * 1e3);
  const double goals = Measure([&] {
    for (int i = 0; i < kGoals; ++i) goal("nothing");
  });
  std::printf("a trivial goal, there and back: %.2f us\n", goals / kGoals * 1e6);
  std::printf("rdf/3, the first time that its terms are seen: ");
  const auto cold_start = std::chrono::steady_clock::now();
  goal("enumerate");
  const std::chrono::duration<double> cold = std::chrono::steady_clock::now() - cold_start;
  std::printf("%.3f us an answer\n", cold.count() / kTriples * 1e6);
  const double all = Measure([&] { goal("enumerate"); });
  std::printf("rdf/3, enumerating: %.3f us an answer\n", all / kTriples * 1e6);
  const double lookups = Measure([&] { goal("lookups"); });
  std::printf("rdf/3, subject and predicate bound: %.3f us a lookup\n",
              (lookups - all) / kTriples * 1e6);
  const double checks = Measure([&] { goal("objects"); });
  std::printf("rdf/3, all bound: %.3f us a lookup\n", (checks - all) / kTriples * 1e6);
}

}  // namespace
}  // namespace lares

int main() { lares::Run(); }
