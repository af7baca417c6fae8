// What a robot's URDF costs. Usage: urdf_bench PR2.urdf; rows as rows.sh reads them.
#include <cstdio>

#include "base/file.h"
#include "benchmarks/measure.h"
#include "reasoner/prolog/engine_pool.h"
#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "server/knowledge/knowledge.h"

namespace lares {
namespace {

std::string ToSrdl(const std::string& urdf) {
  const urdf::Imported robot = urdf::Import(urdf, "pr2.urdf");
  urdf::SrdlOptions options;
  options.id = "pr2";
  return urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
}

void Run(const std::string& file) {
  const std::string urdf = ReadFile(file);
  ToSrdl(urdf);
  const double converted =
      bench::MedianOfFive([&] { return bench::SecondsOf([&] { ToSrdl(urdf); }); });
  bench::Row("PR2: URDF to SRDL", "<", 200, "ms", converted * 1e3);
  const bench::TemporaryFolder folder;
  prolog::EnginePool engines;
  const auto store = store::OpenSqliteStore({folder.path()});
  server::Knowledge knowledge(*store, engines);
  int version = 0;
  const double put = bench::MedianOfFive([&] {
    return bench::SecondsOf([&] {
      server::PutRequest request;
      request.kind = store::DocumentKind::kRobot;
      request.id = "pr2";
      request.file_name = "pr2.ttl";
      request.bytes = ToSrdl(urdf) + "# " + std::to_string(++version) + "\n";
      knowledge.Put(request);
    });
  });
  bench::Row("PR2: import whole (convert, close, check, store)", "<", 200, "ms", put * 1e3);
}

}  // namespace
}  // namespace lares

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s PR2.urdf\n", argv[0]);
    return 2;
  }
  lares::Run(argv[1]);
}
