#include <gmock/gmock.h>

#include <fstream>

#include "base/error.h"
#include "base/file.h"
#include "server/cli/grid_files.h"
#include "tests/server/cli/cli_fixture.h"

namespace lares::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class CliEnvironmentTest : public CliTest {
 protected:
  fs::path WriteGrid(const std::string& image) {
    const std::string pgm = "P5\n2 2\n255\n" + std::string("\x00\xfe\xcd\xfe", 4);
    fs::create_directories((folder_ / "map.yaml").parent_path() / fs::path(image).parent_path());
    Write(image, pgm);
    return Write("map.yaml", "image: " + image +
                                 "\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                                 "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }
  fs::path Out(const std::string& name) { return folder_ / name; }
};

TEST_F(CliEnvironmentTest, LayersGoThereAndBack) {
  const auto room = Write("room.ttl", kTurtle);
  const auto path = Write("path.txt", kTrajectory);
  const Outcome put = Lares({"environment", "put", "hospital-room", "--type", "HospitalRoom",
                             "--layer", "semantic=" + room.string(), "--layer",
                             "trajectory=" + path.string(), "--note", "first"});
  ASSERT_EQ(put.code, 0) << put.err;
  EXPECT_THAT(put.out, HasSubstr("environment hospital-room, version 1"));

  const Outcome get = Lares(
      {"environment", "get", "hospital-room", "--version", "1", "--out", Out("room").string()});
  ASSERT_EQ(get.code, 0) << get.err;
  EXPECT_EQ(ReadFile(Out("room") / "semantic.ttl"), kTurtle);
  EXPECT_EQ(ReadFile(Out("room") / "trajectory.txt"), kTrajectory);
  const auto manifest = nlohmann::json::parse(ReadFile(Out("room") / "manifest.json"));
  EXPECT_EQ(manifest["number"], 1);
  EXPECT_EQ(manifest["layers"][0]["file"], "semantic.ttl");

  EXPECT_THAT(Lares({"environment", "list"}).out,
              AllOf(HasSubstr("hospital-room"), HasSubstr("HospitalRoom")));
  EXPECT_THAT(Lares({"environment", "log", "hospital-room"}).out,
              AllOf(HasSubstr("version 1"), HasSubstr("first"), HasSubstr("* semantic")));
}

TEST_F(CliEnvironmentTest, AGridIsPackedAndComesBackAsFilesThatMapServerLoads) {
  const auto yaml = WriteGrid("images/floor.pgm");
  const Outcome put = Lares({"environment", "put", "lab", "--layer", "grid=" + yaml.string()});
  ASSERT_EQ(put.code, 0) << put.err;
  ASSERT_EQ(Lares({"environment", "get", "lab", "--out", Out("lab").string()}).code, 0);
  EXPECT_THAT(ReadFile(Out("lab") / "grid" / "map.yaml"),
              AllOf(HasSubstr("image: \"floor.pgm\"\n"), HasSubstr("resolution: 0.05\n")));
  EXPECT_EQ(ReadFile(Out("lab") / "grid" / "floor.pgm"), ReadFile(folder_ / "images/floor.pgm"));
  EXPECT_FALSE(fs::exists(Out("lab") / "grid.tar"));
}

TEST_F(CliEnvironmentTest, AGridWithoutItsImageIsRefused) {
  const auto yaml = WriteGrid("floor.pgm");
  fs::remove(folder_ / "floor.pgm");
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", "grid=" + yaml.string()}).code, 1);
}

TEST_F(CliEnvironmentTest, OneLayerCanBeFetchedAlone) {
  const auto room = Write("room.ttl", kTurtle);
  const auto path = Write("path.txt", kTrajectory);
  Lares({"environment", "put", "lab", "--layer", "semantic=" + room.string(), "--layer",
         "trajectory=" + path.string()});
  Lares({"environment", "get", "lab", "--layer", "semantic", "--out", Out("lab").string()});
  EXPECT_TRUE(fs::exists(Out("lab") / "semantic.ttl"));
  EXPECT_FALSE(fs::exists(Out("lab") / "trajectory.txt"));
  const Outcome missing =
      Lares({"environment", "get", "lab", "--layer", "cloud", "--out", Out("none").string()});
  EXPECT_EQ(missing.code, 4);
  EXPECT_FALSE(fs::exists(Out("none")));
}

TEST_F(CliEnvironmentTest, ADownloadReplacesAnEarlierOneAndNothingElse) {
  const auto room = Write("room.ttl", kTurtle);
  Lares({"environment", "put", "lab", "--layer", "semantic=" + room.string()});
  EXPECT_EQ(Lares({"environment", "get", "lab", "--out", Out("lab").string() + "/"}).code, 0);
  EXPECT_EQ(Lares({"environment", "get", "lab", "--out", Out("lab").string()}).code, 0);
  fs::create_directory(Out("mine"));
  Write("mine/thesis.txt", "years of work");
  EXPECT_EQ(Lares({"environment", "get", "lab", "--out", Out("mine").string()}).code, 5);
  EXPECT_TRUE(fs::exists(Out("mine") / "thesis.txt"));
}

TEST_F(CliEnvironmentTest, ADamagedBlobIsNoticedAndNothingIsLeftBehind) {
  const auto path = Write("path.txt", kTrajectory);
  Lares({"environment", "put", "lab", "--layer", "trajectory=" + path.string()});
  const auto blob = store_->BlobPath(store_->GetVersion("lab", 0).layers[0].blob.sha256);
  fs::permissions(blob, fs::perms::owner_write, fs::perm_options::add);
  std::fstream(blob, std::ios::in | std::ios::out | std::ios::binary) << "9";
  const Outcome get = Lares({"environment", "get", "lab", "--out", Out("lab").string()});
  EXPECT_EQ(get.code, 1);
  EXPECT_THAT(get.err, HasSubstr("damaged"));
  EXPECT_FALSE(fs::exists(Out("lab")));
}

TEST_F(CliEnvironmentTest, AVersionThatIsNoLongerTheNewestIsAConflict) {
  const auto room = Write("room.ttl", kTurtle);
  const std::string layer = "semantic=" + room.string();
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", layer, "--if-match", "none"}).code, 0);
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", layer, "--if-match", "none"}).code, 5);
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", layer, "--if-match", "\"lab-7\""}).code,
            5);
}

TEST_F(CliEnvironmentTest, MalformedLayersAreRefused) {
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", "semantic"}).code, 2);
  EXPECT_EQ(Lares({"environment", "put", "lab"}).code, 2);
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", "semantic=/no/such.ttl"}).code, 1);
  const Outcome nonsense = Lares({"environment", "put", "lab", "--layer", "nonsense=x"});
  EXPECT_EQ(nonsense.code, 2);
  EXPECT_THAT(nonsense.err, HasSubstr("octomap"));
  const auto junk = Write("junk.bt", "no octree");
  EXPECT_EQ(Lares({"environment", "put", "lab", "--layer", "octomap=" + junk.string()}).code, 3);
  EXPECT_EQ(Lares({"environment", "get", "lab", "--out", Out("lab").string()}).code, 4);
}

}  // namespace
}  // namespace lares::testing
