#include "mapping/environment/trajectory_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lares_data.h"
#include "tests/mapping/layer_bytes.h"

namespace lares::environment {
namespace {

using testing::Check;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Refusal;

std::string Refused(const std::string& bytes) { return Refusal(CheckTrajectory, bytes); }

TEST(TrajectoryFormatTest, PosesAreCountedAndMeasured) {
  const LayerFacts facts = Check(CheckTrajectory,
                                 "# timestamp tx ty tz qx qy qz qw\r\n"
                                 "\n"
                                 "10.0 0 0 0 0 0 0 1\r\n"
                                 "10.5 3 -4 0 0 0 0.7071 0.7071\n"
                                 "11.5\t3 -4  2 1e0 0 0 +0");
  EXPECT_EQ(facts.facts.at("poses"), "3");
  EXPECT_EQ(facts.facts.at("duration_s"), "1.5");
  EXPECT_EQ(facts.facts.at("length_m"), "7");
  EXPECT_THAT(*facts.bounds_m, ElementsAre(0, -4, 0, 3, 0, 2));
}

TEST(TrajectoryFormatTest, RecordedGroundTruthIsAccepted) {
  LARES_REQUIRE_DATA(file, "rgbd/tum-fr1-rpy-80/groundtruth.txt");
  ByteReader reader = ByteReader::OfFile(file, "groundtruth.txt");
  const LayerFacts facts = CheckTrajectory(reader);
  EXPECT_GT(std::stoi(facts.facts.at("poses")), 80);
  EXPECT_GT(std::stod(facts.facts.at("duration_s")), 1);
}

TEST(TrajectoryFormatTest, FaultsNameTheirLine) {
  const std::string good = "# c\n1 0 0 0 0 0 0 1\n";
  EXPECT_THAT(Refused(good + "2 0 0 0 0 0 1\n"), HasSubstr("file:3: a row has eight numbers"));
  EXPECT_THAT(Refused(good + "2 0 0 0 0 0 0 1 9\n"), HasSubstr("file:3: a row has eight"));
  EXPECT_THAT(Refused(good + "2 0 nan 0 0 0 0 1\n"), HasSubstr("file:3: ty is not a finite"));
  EXPECT_THAT(Refused(good + "2 0 0 1e999 0 0 0 1\n"), HasSubstr("file:3: tz is not a finite"));
  EXPECT_THAT(Refused(good + "2,0,0,0,0,0,0,1\n"), HasSubstr("file:3: timestamp is not"));
  EXPECT_THAT(Refused(good + "1 0 0 0 0 0 0 1\n"), HasSubstr("file:3: the time does not rise"));
  EXPECT_THAT(Refused(good + "2 0 0 0 0 0 0 1.02\n"), HasSubstr("file:3: the quaternion's length"));
  EXPECT_THAT(Refused(good + "2 0 0 0 0 0 0 0\n"), HasSubstr("file:3: the quaternion's length"));
}

TEST(TrajectoryFormatTest, QuaternionMayBeRounded) {
  EXPECT_EQ(Refused("1 0 0 0 0 0 0 1.009\n"), "");
  EXPECT_EQ(Refused("1 0 0 0 0.71 0 0 0.71\n"), "");
}

TEST(TrajectoryFormatTest, FileWithoutPosesIsRefused) {
  EXPECT_THAT(Refused("# nothing\n\n"), HasSubstr("no pose"));
  EXPECT_THAT(Refused(""), HasSubstr("it is empty"));
}

TEST(TrajectoryFormatTest, OtherFilesAreRefusedByWhatTheyLookLike) {
  EXPECT_THAT(Refused("# Octomap OcTree binary file\n"), HasSubstr("it looks like an OctoMap"));
}

TEST(TrajectoryFormatTest, EndlessLineIsRefused) {
  EXPECT_THAT(Refused("1 0 0 0 0 0 0 1" + std::string(4000, ' ')), HasSubstr("longer than 1024"));
}

}  // namespace
}  // namespace lares::environment
