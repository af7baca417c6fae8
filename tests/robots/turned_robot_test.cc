// A robot on which no two frames are parallel: a flipped transform, swapped axes or the inverse of
// a rotation show. The expected figures were computed from the matrices Rz(yaw)·Ry(pitch)·Rx(roll)
// of URDF, apart from this code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using urdf::Imported;

const urdf::BodySensor& Eye(const Imported& robot) { return robot.body.sensors.at(0); }

void ExpectTransform(const RigidTransform& found, const Eigen::Matrix3d& rotation,
                     const Eigen::Vector3d& translation_m) {
  EXPECT_LT((found.rotation.toRotationMatrix() - rotation).norm(), 1e-9)
      << found.rotation.toRotationMatrix();
  EXPECT_LT((found.translation_m - translation_m).norm(), 1e-9) << found.translation_m;
}

TEST(TurnedRobotTest, TheSensorIsSeenFromTheFootprint) {
  const Imported robot = urdf::Import(TurnedRobot(), "turned.urdf");
  Eigen::Matrix3d rotation;
  rotation << 0.395002356620, -0.836811732627, 0.379103234492,  //
      0.848813013006, 0.490287958846, 0.197823624379,           //
      -0.351410880902, 0.243646960885, 0.903961587256;
  ExpectTransform(Eye(robot).base_from_sensor, rotation,
                  {0.982965919573, 2.456930555717, 0.692252844082});
}

TEST(TurnedRobotTest, TheSensorIsSeenFromTheBaseLink) {
  const Imported robot = urdf::Import(TurnedRobot(), "turned.urdf", "base_link");
  Eigen::Matrix3d rotation;
  rotation << 0.753589816010, -0.499314815397, 0.427536085413,  //
      0.555529280947, 0.831457078613, -0.008145209298,          //
      -0.351410880902, 0.243646960885, 0.903961587256;
  ExpectTransform(Eye(robot).base_from_sensor, rotation,
                  {0.204115365839, 0.409160860875, 0.592252844082});
}

TEST(TurnedRobotTest, TheSimulatorsPoseIsThatOfTheSensorOnItsLink) {
  const Imported robot = urdf::Import(TurnedRobot(), "turned.urdf");
  Eigen::Matrix3d rotation;
  rotation << 0.936293363584, -0.275095847318, 0.218350663146,  //
      0.289629477626, 0.956425085849, -0.036957013525,          //
      -0.198669330795, 0.097843395007, 0.975170327202;
  ExpectTransform(Eye(robot).sensor.link_from_sensor, rotation, {0.1, 0.2, 0.3});
  const urdf::Joint& mount = robot.model.joints.at(1);
  ASSERT_EQ(mount.name, "mount_joint");
  ExpectTransform(mount.parent_from_child, rotation, {0.1, 0.2, 0.3});
}

TEST(TurnedRobotTest, AWheelsAxisIsTurnedByItsJointAndTheBase) {
  const Imported robot = urdf::Import(TurnedRobot(), "turned.urdf");
  const Eigen::Vector3d axis = AxisInRoot(robot.model, robot.kinematics, 2);
  EXPECT_LT((axis - Eigen::Vector3d(-0.479425538604, 0.877582561890, 0)).norm(), 1e-9) << axis;
  EXPECT_EQ(robot.body.base.kind, urdf::BaseKind::kDifferential);
}

TEST(TurnedRobotTest, TheInertiasEntriesKeepTheirPlaces) {
  const Imported robot = urdf::Import(TurnedRobot(), "turned.urdf");
  const auto& inertial = robot.model.links.at(1).inertial;
  ASSERT_TRUE(inertial && inertial->inertia_kg_m2);
  Eigen::Matrix3d wanted;
  wanted << 4, 0.1, 0.2, 0.1, 5, 0.3, 0.2, 0.3, 6;
  EXPECT_EQ(*inertial->inertia_kg_m2, wanted);
  urdf::SrdlOptions options;
  options.id = "turned";
  const std::string srdl = urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
  EXPECT_THAT(srdl, HasSubstr("lares:inertia_kg_m2 \"4 0.1 0.2 5 0.3 6\""));
}

}  // namespace
}  // namespace lares::testing
