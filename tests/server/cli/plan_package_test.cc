#include <gmock/gmock.h>

#include <fstream>

#include "base/file.h"
#include "base/hash.h"
#include "tests/server/cli/cli_fixture.h"

namespace lares::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class PlanPackageTest : public CliTest {
 protected:
  PlanPackageTest() {
    Lares({"environment", "put", "room", "--layer",
           "trajectory=" + Write("path.txt", kTrajectory).string()});
    Lares({"object-model", "put", Write("cup.ttl", kTurtle).string(),
           Write("face.ply", "points").string()});
  }
  Outcome Pack(std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"plan",          "t",    "--robot",   "scout",
                                       "--environment", "room", "--package", out_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Lares(arguments);
  }
  // Names below the test's folder that a download leaves when it does not clean up.
  int Leftovers() {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      count += entry.path().filename().string().starts_with(".lares-package-") ? 1 : 0;
    }
    return count;
  }

  fs::path out_ = folder_ / "mission";
};

TEST_F(PlanPackageTest, EverythingIsInOneFolder) {
  const Outcome outcome = Pack();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("models/cup"), HasSubstr("grid/map.yaml"),
                                 HasSubstr("layers/trajectory.txt"), HasSubstr("- because")));
  EXPECT_EQ(ReadFile(out_ / "models/cup/face.ply"), "points");
  EXPECT_EQ(ReadFile(out_ / "models/cup/cup.ttl"), kTurtle);
  EXPECT_EQ(ReadFile(out_ / "layers/trajectory.txt"), kTrajectory);
  EXPECT_THAT(ReadFile(out_ / "grid/map.yaml"), HasSubstr("image: map.pgm\n"));
  EXPECT_TRUE(fs::exists(out_ / "grid/map.pgm"));
  EXPECT_EQ(ReadFile(out_ / "plan.xml"), "<root task=\"t\"/>");
  const auto plan = nlohmann::json::parse(ReadFile(out_ / "plan.json"));
  EXPECT_EQ(plan["robot"], "scout");
  EXPECT_FALSE(plan.contains("package"));
  const auto package = nlohmann::json::parse(ReadFile(out_ / "package.json"));
  for (const auto& file : package["object_models"][0]["files"]) {
    EXPECT_EQ(Sha256Hex(ReadFile(out_ / std::string(file["file"]))), file["sha256"]);
  }
  EXPECT_EQ(Sha256Hex(ReadFile(out_ / std::string(package["grid"]["image"]["file"]))),
            package["grid"]["image"]["sha256"]);
  EXPECT_EQ(Leftovers(), 0);
}

TEST_F(PlanPackageTest, JsonPrintsThePackage) {
  const Outcome outcome = Pack({"--json"});
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["format"], "lares-package");
}

TEST_F(PlanPackageTest, AFolderThatIsNotEmptyIsLeftAlone) {
  fs::create_directories(out_);
  std::ofstream(out_ / "mine") << "mine";
  const Outcome outcome = Pack();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("not empty"));
  EXPECT_EQ(ReadFile(out_ / "mine"), "mine");
  EXPECT_FALSE(fs::exists(out_ / "plan.json"));
}

TEST_F(PlanPackageTest, AnEmptyFolderIsFilled) {
  fs::create_directories(out_);
  EXPECT_EQ(Pack().code, 0);
  EXPECT_TRUE(fs::exists(out_ / "plan.json"));
}

TEST_F(PlanPackageTest, ADamagedFileLeavesNothing) {
  // The layer's blob changes on the server's disk: its hash is no longer the announced one.
  const auto layer = store_->GetVersion("room", 1).layers.at(0);
  const fs::path blob = store_->BlobPath(layer.blob.sha256);
  fs::permissions(blob, fs::perms::owner_write, fs::perm_options::add);
  std::fstream(blob, std::ios::in | std::ios::out | std::ios::binary).write("9", 1);
  const Outcome outcome = Pack();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("layer trajectory arrived damaged"));
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_EQ(Leftovers(), 0);
}

TEST_F(PlanPackageTest, AMissingFileLeavesNothing) {
  const auto details = nlohmann::json::parse(
      store_->FindDocument(store::DocumentKind::kObjectModel, "cup")->details_json);
  fs::remove(store_->BlobPath(details["files"][0]["sha256"]));
  EXPECT_NE(Pack().code, 0);
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_EQ(Leftovers(), 0);
}

TEST_F(PlanPackageTest, WithoutEnvironmentThereAreThePlanAndItsReasons) {
  ASSERT_EQ(Lares({"plan", "t", "--robot", "scout", "--package", out_.string()}).code, 0);
  EXPECT_TRUE(fs::exists(out_ / "plan.xml"));
  EXPECT_FALSE(fs::exists(out_ / "grid"));
}

TEST_F(PlanPackageTest, OutAndAsGoWithoutIt) {
  EXPECT_EQ(Pack({"--as", "dot"}).code, 2);
  EXPECT_EQ(Pack({"--out", "x"}).code, 2);
}

}  // namespace
}  // namespace lares::testing
