#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "base/file.h"
#include "tests/ontology/content.h"

namespace lares::testing {
namespace {

using Names = std::set<std::string>;

constexpr char kFlat[] = "https://w3id.org/lares/demo/flat#";

Content WithModules(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files = ModuleFiles();
  files.push_back(SourceFolder() / file);
  return Content(files);
}

const Content& Flat() {
  static const Content content = WithModules("demo/flat.ttl");
  return content;
}

std::string Only(const Content& content, const std::string& subject, const std::string& property) {
  const Names values = content.Values(subject, property);
  EXPECT_EQ(values.size(), 1U) << subject << " " << property;
  return values.empty() ? "0" : *values.begin();
}

Eigen::Matrix4d Matrix(const Content& content, const std::string& name) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const std::string entry = "m" + std::to_string(row) + std::to_string(column);
      matrix(row, column) = std::stod(Only(content, name, entry));
    }
  }
  return matrix;
}

void ExpectRightHandedPoses(const Content& content) {
  const Names poses = content.Declared("RotationMatrix3D");
  EXPECT_GE(poses.size(), 7U);
  for (const std::string& name : poses) {
    const Eigen::Matrix4d pose = Matrix(content, name);
    const Eigen::Matrix3d rotation = pose.topLeftCorner<3, 3>();
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-5) << name;
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-5) << name;
    EXPECT_EQ(pose.row(3), Eigen::RowVector4d(0, 0, 0, 1)) << name;
  }
}

// A box on the floor plan, from a thing's pose and extent in the map.
struct Box {
  Eigen::Vector3d min, max;
  bool Holds(double x, double y, double margin) const {
    return x > min.x() + margin && x < max.x() - margin && y > min.y() + margin &&
           y < max.y() - margin;
  }
};

Box BoxOf(const std::string& name) {
  const std::string iri = kFlat + name;
  const Eigen::Matrix4d pose = Matrix(Flat(), std::string(kFlat) + "pose_of_" + name);
  const Eigen::Vector3d extent(std::stod(Only(Flat(), iri, "depthOfObject")),
                               std::stod(Only(Flat(), iri, "widthOfObject")),
                               std::stod(Only(Flat(), iri, "heightOfObject")));
  const Eigen::Vector3d half = pose.topLeftCorner<3, 3>().cwiseAbs() * extent / 2;
  const Eigen::Vector3d center = pose.topRightCorner<3, 1>();
  return {center - half, center + half};
}

Names LocalNames(const Names& iris) {
  Names names;
  for (const std::string& iri : iris) names.insert(iri.substr(iri.find('#') + 1));
  return names;
}

Names Rooms() { return {"kitchen", "living_room", "bedroom", "hallway"}; }

Names ThingsIn(const std::string& room) {
  return LocalNames(Flat().Values(kFlat + room, "properPhysicalParts"));
}

TEST(FlatTest, EveryPoseIsRightHanded) { ExpectRightHandedPoses(Flat()); }

TEST(FlatTest, TheBuildingLeadsToTheRoomsAndTheirThings) {
  EXPECT_EQ(ThingsIn("building"), (Names{"storey"}));
  EXPECT_EQ(ThingsIn("storey"), (Names{"flat"}));
  EXPECT_EQ(ThingsIn("flat"), Rooms());
  EXPECT_TRUE(ThingsIn("kitchen").contains("bottle"));
  EXPECT_TRUE(ThingsIn("kitchen").contains("cup"));
}

TEST(FlatTest, EveryThingIsPerceivedDescribedAndOfAKnownClass) {
  Names things = Rooms();
  for (const std::string& room : Rooms()) things.merge(ThingsIn(room));
  EXPECT_GE(things.size(), 16U);
  for (const std::string& thing : things) {
    const std::string perception = std::string(kFlat) + "perception_of_" + thing;
    EXPECT_EQ(Only(Flat(), perception, "objectActedOn"), kFlat + thing);
    EXPECT_EQ(Only(Flat(), perception, "eventOccursAt"), std::string(kFlat) + "pose_of_" + thing);
    EXPECT_EQ(Only(Flat(), kFlat + thing, "describedInMap"), std::string(kFlat) + "map");
    Names types = Flat().Values(kFlat + thing, "rdf:type");
    types.erase("http://www.w3.org/2002/07/owl#NamedIndividual");
    ASSERT_EQ(types.size(), 1U) << thing;
    EXPECT_TRUE(Flat().Above(*types.begin()).contains("SpatialThing")) << thing;
  }
}

TEST(FlatTest, ThingsStandInTheirRoomsAndDoNotPierceOneAnother) {
  for (const std::string& room : Rooms()) {
    const Box walls = BoxOf(room);
    for (const std::string& thing : ThingsIn(room)) {
      if (thing == "front_door") continue;  // in the wall
      const Box box = BoxOf(thing);
      EXPECT_TRUE(((box.min - walls.min).array() > -1e-3).all()) << thing;
      EXPECT_TRUE(((walls.max - box.max).array() > -1e-3).all()) << thing;
      for (const std::string& other : ThingsIn(room)) {
        if (other <= thing) continue;
        const Box second = BoxOf(other);
        const Eigen::Array3d overlap = box.max.cwiseMin(second.max) - box.min.cwiseMax(second.min);
        EXPECT_LT(overlap.minCoeff(), 1e-3) << thing << " " << other;
      }
    }
  }
}

TEST(FlatTest, TheBottleStandsOnTheCounterAndTheCupOnTheTable) {
  EXPECT_NEAR(BoxOf("bottle").min.z(), BoxOf("counter").max.z(), 1e-3);
  EXPECT_TRUE(BoxOf("counter").Holds(BoxOf("bottle").min.x(), BoxOf("bottle").max.y(), 0));
  EXPECT_NEAR(BoxOf("cup").min.z(), BoxOf("kitchen_table").max.z(), 1e-3);
  EXPECT_TRUE(BoxOf("kitchen_table").Holds(BoxOf("cup").min.x(), BoxOf("cup").max.y(), 0));
}

// --- The grid of the same flat ----------------------------------------------------------------

struct Grid {
  int width = 0, height = 0;
  double resolution_m = 0.05, origin_x_m = -0.5, origin_y_m = -0.5;
  std::string cells;  // top row first

  int At(double x, double y) const {
    const int column = static_cast<int>(std::floor((x - origin_x_m) / resolution_m));
    const int row = static_cast<int>(std::floor((y - origin_y_m) / resolution_m));
    return static_cast<unsigned char>(cells.at((height - 1 - row) * width + column));
  }
};

Grid ReadGrid() {
  Grid grid;
  std::istringstream yaml(lares::ReadFile(SourceFolder() / "demo/flat.yaml"));
  std::ostringstream expected;
  expected << "origin: [" << grid.origin_x_m << ", " << grid.origin_y_m << ", 0.0]";
  EXPECT_NE(yaml.str().find("resolution: 0.05\n"), std::string::npos);
  EXPECT_NE(yaml.str().find(expected.str()), std::string::npos);
  const std::string bytes = lares::ReadFile(SourceFolder() / "demo/flat.pgm");
  EXPECT_LE(bytes.size(), 60'000U);
  std::istringstream stream(bytes);
  std::string magic;
  int most = 0;
  stream >> magic >> grid.width >> grid.height >> most;
  EXPECT_EQ(magic, "P5");
  EXPECT_EQ(most, 255);
  grid.cells = bytes.substr(static_cast<std::size_t>(stream.tellg()) + 1);
  EXPECT_EQ(grid.cells.size(), static_cast<std::size_t>(grid.width) * grid.height);
  return grid;
}

constexpr int kOccupied = 0, kUnknown = 205, kFree = 254;

TEST(FlatGridTest, FloorsAreFreeExceptUnderWhatStandsOnThem) {
  const Grid grid = ReadGrid();
  for (const std::string& room : Rooms()) {
    const Box walls = BoxOf(room);
    std::vector<Box> standing;
    for (const std::string& thing : ThingsIn(room)) {
      if (BoxOf(thing).min.z() < 0.01) standing.push_back(BoxOf(thing));
    }
    for (double x = walls.min.x() + 0.025; x < walls.max.x(); x += 0.05) {
      for (double y = walls.min.y() + 0.025; y < walls.max.y(); y += 0.05) {
        int expected = kFree;
        for (const Box& box : standing) {
          if (box.Holds(x, y, 0.03)) {
            expected = kOccupied;
          } else if (expected == kFree && box.Holds(x, y, -0.03)) {
            expected = grid.At(x, y);  // a cell at an edge: either
          }
        }
        EXPECT_EQ(grid.At(x, y), expected) << room << " " << x << " " << y;
      }
    }
  }
}

TEST(FlatGridTest, RoomsHaveWallsAroundThemWithDoorways) {
  const Grid grid = ReadGrid();
  for (const std::string& room : Rooms()) {
    const Box walls = BoxOf(room);
    int occupied = 0, open = 0;
    const auto count = [&](double x, double y) {
      EXPECT_NE(grid.At(x, y), kUnknown) << room << " " << x << " " << y;
      (grid.At(x, y) == kOccupied ? occupied : open) += 1;
    };
    for (double x = walls.min.x() + 0.025; x < walls.max.x(); x += 0.05) {
      count(x, walls.min.y() - 0.025);
      count(x, walls.max.y() + 0.025);
    }
    for (double y = walls.min.y() + 0.025; y < walls.max.y(); y += 0.05) {
      count(walls.min.x() - 0.025, y);
      count(walls.max.x() + 0.025, y);
    }
    EXPECT_GE(open, 16) << room << ": no doorway";
    EXPECT_GT(occupied, 4 * open) << room;
  }
  EXPECT_EQ(grid.At(-0.4, -0.4), kUnknown);
}

// --- The robots -------------------------------------------------------------------------------

class RobotDocumentTest : public ::testing::TestWithParam<const char*> {
 protected:
  std::string Iri(const std::string& name) const {
    return std::string("https://w3id.org/lares/robots/") + GetParam() + "#" + name;
  }
  Content content_ = WithModules(std::string("robots/models/") + GetParam() + ".ttl");

  // Everything that hangs on the robot, in any depth.
  Names Parts(const std::string& whole) const {
    Names parts;
    std::vector<std::string> open = {whole};
    while (!open.empty()) {
      const std::string next = open.back();
      open.pop_back();
      for (const char* property : {"subComponent", "succeedingLink", "succeedingJoint"}) {
        for (const std::string& part : content_.Values(next, property)) {
          if (parts.insert(part).second) open.push_back(part);
        }
      }
    }
    return parts;
  }
  bool Has(const std::string& component) const {
    for (const std::string& part : Parts(Iri(std::string(GetParam()) + "1"))) {
      for (const std::string& type : content_.Values(part, "rdf:type")) {
        if (content_.Above(type).contains(component)) return true;
      }
    }
    return false;
  }
};

TEST_P(RobotDocumentTest, EveryPoseIsRightHanded) { ExpectRightHandedPoses(content_); }

TEST_P(RobotDocumentTest, WhatTheMakerClaimsRestsOnComponents) {
  std::string kind = GetParam();
  kind[0] = static_cast<char>(std::toupper(kind[0]));
  std::set<std::string> open = content_.Some(Iri(kind), "hasCapability"), seen;
  EXPECT_GE(open.size(), 3U);
  while (!open.empty()) {
    const std::string capability = *open.begin();
    open.erase(open.begin());
    if (!seen.insert(capability).second) continue;
    open.merge(content_.Some(capability, "dependsOnCapability"));
    for (const std::string& component : content_.Some(capability, "dependsOnComponent")) {
      EXPECT_TRUE(Has(component)) << capability << " needs " << component;
    }
  }
}

TEST_P(RobotDocumentTest, EveryLinkHangsOnTheRobot) {
  const Names parts = Parts(Iri(std::string(GetParam()) + "1"));
  for (const std::string& link : content_.Declared("UrdfLink")) {
    EXPECT_TRUE(parts.contains(link)) << link;
    EXPECT_FALSE(Parts(link).contains(link)) << "a circle through " << link;
  }
}

INSTANTIATE_TEST_SUITE_P(Demonstration, RobotDocumentTest, ::testing::Values("scout", "helper"),
                         [](const auto& param) { return std::string(param.param); });

class ScoutTest : public RobotDocumentTest {};
TEST_P(ScoutTest, HasEyesAndWheelsAndNoArm) {
  EXPECT_TRUE(Has("Camera"));
  EXPECT_TRUE(Has("DepthCamera"));
  EXPECT_TRUE(Has("LaserScanner"));
  EXPECT_TRUE(Has("MobileBase"));
  EXPECT_FALSE(Has("ArmComponent"));
  EXPECT_FALSE(Has("ManipulationEntity"));
  EXPECT_FALSE(Has("ArmMotionController"));
}
INSTANTIATE_TEST_SUITE_P(Demonstration, ScoutTest, ::testing::Values("scout"));

class HelperTest : public RobotDocumentTest {};
TEST_P(HelperTest, HasAnArmAGripperAndWhatMovesThem) {
  EXPECT_TRUE(Has("ArmComponent"));
  EXPECT_TRUE(Has("ManipulationEntity"));
  EXPECT_TRUE(Has("ArmMotionController"));
  EXPECT_TRUE(Has("MobileBase"));
}
INSTANTIATE_TEST_SUITE_P(Demonstration, HelperTest, ::testing::Values("helper"));

}  // namespace
}  // namespace lares::testing
