// In-process rows of `benchmarks/run knowledge` (measure.h tells their form). Each figure is the
// median of five runs. Real data is used where LARES_DATA names it.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "base/file.h"
#include "benchmarks/measure.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"
#include "server/knowledge/knowledge.h"

namespace {

namespace fs = std::filesystem;
using namespace lares;

using bench::MedianOfFive;
using bench::Row;
using bench::SecondsOf;

// 300 000 triples with the mixture of a map: many subjects, few predicates, shared objects.
std::string SyntheticNTriples() {
  std::mt19937 random(1);
  std::string text;
  for (int i = 0; i < 300'000; ++i) {
    text += "<http://example.org/thing/" + std::to_string(i / 6) + "> <http://example.org/p" +
            std::to_string(i % 12) + "> ";
    text += i % 3 == 0 ? "\"value " + std::to_string(i) + "\" .\n"
                       : "<http://example.org/thing/" + std::to_string(random() % 50'000) + "> .\n";
  }
  return text;
}

rdf::View Load(const std::string& text) {
  auto dictionary = std::make_shared<rdf::Dictionary>();
  rdf::ReadOptions options;
  options.source = "synthetic.nt";
  const rdf::Document document = rdf::ReadRdf(text, rdf::Format::kNTriples, options);
  std::vector<rdf::Graph> graphs;
  graphs.push_back(rdf::MakeGraph(document, "bench", rdf::AliasTable(), *dictionary));
  return rdf::View(dictionary)
      .With(std::make_shared<rdf::Layer>(std::move(graphs), std::vector<rdf::Triple>{},
                                         std::vector<rdf::Clash>{}));
}

void MeasureTriples() {
  const std::string text = SyntheticNTriples();
  rdf::View view = Load(text);
  const double count = static_cast<double>(view.size());
  Row("N-Triples parsed and indexed", ">", 300'000, "1/s",
      MedianOfFive([&] { return count / SecondsOf([&] { view = Load(text); }); }));

  std::mt19937 random(2);
  const std::vector<rdf::Triple> all = view.Match({});
  std::vector<rdf::Pattern> patterns;
  for (int i = 0; i < 100'000; ++i) {
    const rdf::Triple& triple = all[random() % all.size()];
    patterns.push_back(i % 2 == 0 ? rdf::Pattern{triple.subject, triple.predicate, {}}
                                  : rdf::Pattern{triple.subject, {}, triple.object});
  }
  std::size_t found = 0;
  Row("pattern lookup with its answers (1 to 2 of them)", "<", 2, "us", MedianOfFive([&] {
        return 1e6 / static_cast<double>(patterns.size()) * SecondsOf([&] {
                 for (const rdf::Pattern& pattern : patterns) {
                   view.ForEach(pattern, [&](const rdf::Triple&) { return ++found > 0; });
                 }
               });
      }));
}

server::PutRequest FileRequest(store::DocumentKind kind, const fs::path& file) {
  server::PutRequest request;
  request.kind = kind;
  request.file_name = file.filename().string();
  request.bytes = ReadFile(file);
  return request;
}

void MeasureQuestions() {
  const bench::TemporaryFolder folder;
  const auto store = store::OpenSqliteStore({folder.path()});
  prolog::EnginePool engines;
  server::Knowledge knowledge(*store, engines);
  const char* data = std::getenv("LARES_DATA");
  const fs::path source = LARES_SOURCE_DIR;
  std::string task = "object-search";
  std::string robot = "helper";
  if (data != nullptr) {
    task = "FindBottle";
    robot = "PR2";
    knowledge.Put(FileRequest(store::DocumentKind::kRecipe,
                              fs::path(data) / "roboearth/recipes/object-search-recipe.owl"));
    knowledge.Put(
        FileRequest(store::DocumentKind::kRobot, fs::path(data) / "roboearth/robots/PR2.owl"));
  } else {
    knowledge.Put(
        FileRequest(store::DocumentKind::kRecipe, source / "recipes/library/object-search.ttl"));
    knowledge.Put(FileRequest(store::DocumentKind::kRobot, source / "robots/models/helper.ttl"));
  }
  const auto plan = [&] {
    if (!knowledge.MakePlan({task, robot}).result.plan) throw Error(Code::kInternal, "no plan");
  };
  plan();
  const std::string what = "matching and planning " + task + " for " + robot + ", warm";
  Row(what, "<", 10, "ms", MedianOfFive([&] { return 1e3 * SecondsOf(plan); }));
  const auto where = [&] {
    if (knowledge.Where({"Cup", "", "", 0}).rooms.empty()) {
      throw Error(Code::kInternal, "no place");
    }
  };
  where();
  Row("where Cup, warm", "<", 1, "ms", MedianOfFive([&] { return 1e3 * SecondsOf(where); }));
}

}  // namespace

int main() {
  try {
    MeasureTriples();
    MeasureQuestions();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "knowledge_bench: %s\n", error.what());
    return 2;
  }
}
