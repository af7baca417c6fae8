// In-process rows of matching (measure.h tells their form):
//
//     planning_bench match|plans|ranking|repairs
//
// Real recipes and robots are used where LARES_DATA names them.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "benchmarks/measure.h"
#include "benchmarks/robots.h"
#include "server/knowledge/knowledge.h"
#include "tests/recipes/random_repair.h"

namespace {

namespace fs = std::filesystem;
using namespace lares;

using bench::MedianOfFive;
using bench::Note;
using bench::Row;
using bench::SecondsOf;
using store::DocumentKind;

constexpr int kRobots = 100;

struct Service {
  bench::TemporaryFolder folder;
  std::unique_ptr<store::Store> store = store::OpenSqliteStore({folder.path()});
  prolog::EnginePool engines;
  server::Knowledge knowledge{*store, engines};

  void Put(DocumentKind kind, const fs::path& file) {
    server::PutRequest request;
    request.kind = kind;
    request.file_name = file.filename().string();
    request.bytes = ReadFile(file);
    request.recover = kind == DocumentKind::kRecipe && file.extension() == ".owl";
    knowledge.Put(request);
  }
  void PutAll(DocumentKind kind, const fs::path& from, const char* extension) {
    for (const auto& entry : fs::directory_iterator(from)) {
      if (entry.path().extension() == extension) Put(kind, entry.path());
    }
  }
  std::vector<std::string> Ids(DocumentKind kind) const {
    std::vector<std::string> ids;
    for (const auto& document : store->ListDocuments(kind)) ids.push_back(document.id);
    return ids;
  }
};

const fs::path kSource = LARES_SOURCE_DIR;

void PutRecipesAndRobots(Service& service) {
  service.PutAll(DocumentKind::kRecipe, kSource / "recipes/library", ".ttl");
  service.PutAll(DocumentKind::kRobot, kSource / "robots/models", ".ttl");
  const char* data = std::getenv("LARES_DATA");
  if (data == nullptr) return;
  service.PutAll(DocumentKind::kRecipe, fs::path(data) / "roboearth/recipes", ".owl");
  service.PutAll(DocumentKind::kRobot, fs::path(data) / "roboearth/robots", ".owl");
}

// As the server answers; and, without a limit, over a view that is there with needs and robot read
// anew.
void MeasureMatch() {
  Service service;
  PutRecipesAndRobots(service);
  double slowest_ms = 0;
  double slowest_anew_ms = 0;
  std::string which;
  int pairs = 0;
  for (const std::string& recipe : service.Ids(DocumentKind::kRecipe)) {
    for (const std::string& robot : service.Ids(DocumentKind::kRobot)) {
      const auto match = [&] { service.knowledge.MatchTask({recipe, robot}); };
      match();
      const double ms = MedianOfFive([&] { return 1e3 * SecondsOf(match); });
      const auto task = service.knowledge.Resolve(DocumentKind::kRecipe, recipe).target_iri;
      const auto who = service.knowledge.Resolve(DocumentKind::kRobot, robot).target_iri;
      const rdf::View view = service.knowledge.ViewFor({recipe, robot, "", 0});
      const auto anew = [&] { recipes::Match(service.engines, view, task, who); };
      anew();
      slowest_anew_ms =
          std::max(slowest_anew_ms, MedianOfFive([&] { return 1e3 * SecondsOf(anew); }));
      ++pairs;
      if (ms <= slowest_ms) continue;
      slowest_ms = ms;
      which = recipe + " for " + robot;
    }
  }
  Row("matching, warm, slowest of " + std::to_string(pairs) + " pairs: " + which, "<", 5, "ms",
      slowest_ms);
  Note("  … with needs and robot read anew, slowest", "ms", slowest_anew_ms);
}

// What our recipes leave to whoever asks; a recipe that has no such parameter is asked without.
std::map<std::string, std::string> ValuesFor(Service& service, const std::string& recipe,
                                             const std::string& robot) {
  const std::map<std::string, std::string> kValues = {
      {"object", "Cup"},
      {"to", "1 2 0"},
      {"places", service.knowledge.Resolve(DocumentKind::kRobot, robot).target_iri},
      {"environment_type", "Kitchen"}};
  std::map<std::string, std::string> set;
  const auto document = service.store->FindDocument(DocumentKind::kRecipe, recipe);
  const auto details = nlohmann::json::parse(document->details_json);
  for (const auto& task : details.at("tasks")) {
    for (const auto& parameter : task.at("parameters")) {
      const auto value = kValues.find(parameter.at("name").get<std::string>());
      if (value != kValues.end()) set.insert(*value);
    }
  }
  return set;
}

// As the server answers; and, without a limit, over a view that is there with recipe, needs and
// robot read anew.
void MeasurePlans() {
  Service service;
  PutRecipesAndRobots(service);
  double slowest_ms = 0;
  double slowest_anew_ms = 0;
  std::string which;
  int plans = 0;
  int refusals = 0;
  for (const std::string& recipe : service.Ids(DocumentKind::kRecipe)) {
    for (const std::string& robot : service.Ids(DocumentKind::kRobot)) {
      server::PlanRequest request;
      request.task = recipe;
      request.robot = robot;
      request.set = ValuesFor(service, recipe, robot);
      const auto plan = [&] { return service.knowledge.MakePlan(request); };
      ++(plan().result.plan ? plans : refusals);
      const double ms = MedianOfFive([&] { return 1e3 * SecondsOf([&] { plan(); }); });
      const auto task = service.knowledge.Resolve(DocumentKind::kRecipe, recipe).target_iri;
      const auto who = service.knowledge.Resolve(DocumentKind::kRobot, robot).target_iri;
      const rdf::View view = service.knowledge.ViewFor({recipe, robot, "", 0});
      recipes::PlanOptions options;
      options.set = request.set;
      const auto anew = [&] { recipes::MakePlan(service.engines, view, task, who, options); };
      slowest_anew_ms =
          std::max(slowest_anew_ms, MedianOfFive([&] { return 1e3 * SecondsOf(anew); }));
      if (ms <= slowest_ms) continue;
      slowest_ms = ms;
      which = recipe + " for " + robot;
    }
  }
  Row("match and plan, warm, slowest of " + std::to_string(plans) + " plans and " +
          std::to_string(refusals) + " refusals: " + which,
      "<", 5, "ms", slowest_ms);
  Note("  … with recipe, needs and robot read anew, slowest", "ms", slowest_anew_ms);
}

void MeasureRanking() {
  Service service;
  PutRecipesAndRobots(service);
  const std::string models[] = {ReadFile(kSource / "robots/models/scout.ttl"),
                                ReadFile(kSource / "robots/models/helper.ttl")};
  int stored = static_cast<int>(service.Ids(DocumentKind::kRobot).size());
  for (std::uint32_t seed = 0; stored < kRobots; ++seed, ++stored) {
    server::PutRequest request;
    request.kind = DocumentKind::kRobot;
    request.id = "robot" + std::to_string(seed);
    request.file_name = request.id + ".ttl";
    request.bytes = bench::VariedRobot(models[seed % 2], seed);
    service.knowledge.Put(request);
  }
  double slowest_ms = 0;
  std::string which;
  for (const std::string& recipe : service.Ids(DocumentKind::kRecipe)) {
    const auto rank = [&] {
      if (service.knowledge.RankRobots({recipe, "", 0, false}).robots.size() < kRobots) {
        throw Error(Code::kInternal, "robots are lacking");
      }
    };
    const double cold_ms = 1e3 * SecondsOf(rank);
    const double ms = MedianOfFive([&] { return 1e3 * SecondsOf(rank); });
    if (which.empty()) {
      Note("ranking " + std::to_string(kRobots) + " robots for the first time", "ms", cold_ms);
    }
    if (ms <= slowest_ms) continue;
    slowest_ms = ms;
    which = recipe;
  }
  Row("ranking " + std::to_string(kRobots) + " robots, warm, slowest recipe: " + which, "<", 50,
      "ms", slowest_ms);
}

void MeasureRepairs() {
  constexpr std::uint32_t kProblems = 1000;
  int equal = 0;
  double seconds = 0;
  for (std::uint32_t seed = 0; seed < kProblems; ++seed) {
    const recipes::RepairProblem problem = testing::RandomRepairProblem(seed);
    recipes::RepairSets found;
    seconds += SecondsOf([&] { found = recipes::SmallestRepairs(problem); });
    const auto all = testing::AllRepairs(problem);
    if (found.sets.empty() != all.empty()) continue;
    if (all.empty() || found.sets.front().additions == all.front().additions) ++equal;
  }
  Row("smallest repairs equal to those of trying every set, of 1000", "==", kProblems, "cases",
      equal);
  Note("  … mean time of one", "ms", 1e3 * seconds / kProblems);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what == "match") {
    MeasureMatch();
  } else if (what == "plans") {
    MeasurePlans();
  } else if (what == "ranking") {
    MeasureRanking();
  } else if (what == "repairs") {
    MeasureRepairs();
  } else {
    std::fprintf(stderr, "planning_bench match|plans|ranking|repairs\n");
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "planning_bench: %s\n", error.what());
  return 1;
}
