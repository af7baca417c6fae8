// The robots of RoboEarth, as their URDFs describe them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "robots/urdf/doctor.h"
#include "robots/urdf/import.h"
#include "tests/lares_data.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using urdf::BaseKind;
using urdf::Imported;
using urdf::Sensor;

std::size_t Count(const Imported& robot, Sensor::Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(robot.body.sensors.begin(), robot.body.sensors.end(),
                    [&](const auto& sensor) { return sensor.sensor.kind == kind; }));
}

const urdf::BodySensor& Find(const Imported& robot, const std::string& name) {
  for (const auto& sensor : robot.body.sensors) {
    if (sensor.sensor.name == name) return sensor;
  }
  throw Error(Code::kNotFound, name);
}

TEST(RecordedRobotsTest, Pr2) {
  LARES_REQUIRE_DATA(file, "roboearth/urdf/pr2.urdf");
  const Imported robot = urdf::Import(ReadFile(file), "pr2.urdf");
  EXPECT_EQ(robot.model.links.size(), 95u);
  EXPECT_EQ(robot.model.joints.size(), 94u);
  EXPECT_EQ(robot.body.base.kind, BaseKind::kHolonomic);
  ASSERT_EQ(robot.body.arms.size(), 2u);
  EXPECT_EQ(robot.body.arms[0].joints.size(), 7u);
  EXPECT_NEAR(robot.body.arms[0].reach_m, 0.821, 1e-6);
  EXPECT_EQ(robot.body.grippers.size(), 2u);
  EXPECT_EQ(robot.body.heads.size(), 1u);
  EXPECT_EQ(robot.body.torsos.size(), 1u);
  EXPECT_EQ(Count(robot, Sensor::Kind::kLaser2d), 2u);
  EXPECT_EQ(Count(robot, Sensor::Kind::kRgbdCamera), 2u);
  EXPECT_EQ(Count(robot, Sensor::Kind::kDepthCamera), 1u);
  EXPECT_EQ(Count(robot, Sensor::Kind::kCamera), 8u);
  const urdf::BodySensor& kinect = Find(robot, "head_mount_rgb_sensor");
  EXPECT_NEAR(kinect.base_from_sensor.translation_m.z(), 1.46408, 1e-4);
  EXPECT_NEAR(*kinect.sensor.hfov_rad, 0.994837673637, 1e-9);
  ASSERT_TRUE(robot.body.footprint);
  EXPECT_NEAR(robot.body.footprint->length_m, 0.6, 0.01);
  EXPECT_THAT(robot.body.footprint->reason, HasSubstr("base_link"));
}

TEST(RecordedRobotsTest, AmigoWithItsOldSensors) {
  LARES_REQUIRE_DATA(file, "roboearth/urdf/amigo.urdf");
  const Imported robot = urdf::Import(ReadFile(file), "amigo.urdf");
  EXPECT_EQ(robot.model.links.size(), 113u);
  EXPECT_EQ(robot.body.base.kind, BaseKind::kHolonomic);
  EXPECT_THAT(robot.body.base.reason, HasSubstr("2 directions"));
  EXPECT_EQ(robot.body.arms.size(), 2u);
  EXPECT_EQ(robot.body.grippers.size(), 2u);
  EXPECT_EQ(Find(robot, "openni_camera").sensor.kind, Sensor::Kind::kRgbdCamera);
  EXPECT_NEAR(*Find(robot, "base_ray_sensor").sensor.max_angle_rad, 2.35619, 1e-4);
  ASSERT_EQ(robot.model.findings.size(), 1u);
  EXPECT_EQ(robot.model.findings[0].place.line, 65);
  EXPECT_THAT(robot.model.findings[0].message, HasSubstr("top_laser"));
}

TEST(RecordedRobotsTest, ABareTutorialIsTakenAndSaysWhatItLacks) {
  LARES_REQUIRE_DATA(file, "roboearth/urdf/tutorial.urdf");
  const Imported robot = urdf::Import(ReadFile(file), "tutorial.urdf");
  EXPECT_EQ(robot.body.base.kind, BaseKind::kUnknown);
  EXPECT_EQ(robot.body.notes.size(), 4u);
}

TEST(RecordedRobotsTest, TheDoctorReadsThemAll) {
  for (const char* name : {"pr2", "amigo", "tutorial"}) {
    LARES_REQUIRE_DATA(file, std::string("roboearth/urdf/") + name + ".urdf");
    EXPECT_FALSE(urdf::Examine(ReadFile(file), name).empty()) << name;
  }
}

}  // namespace
}  // namespace lares::testing
