#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "robots/urdf/kinematics.h"
#include "robots/urdf/model.h"
#include "robots/urdf/xml_tree.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Optional;
using urdf::Joint;
using urdf::Model;
using urdf::Sensor;

Model Read(const std::string& text) { return urdf::ReadUrdf(text, "test.urdf"); }

TEST(ReadUrdfTest, LinksJointsLimitsAndMassesAreRead) {
  const Model model = Read(
      Robot(LinkText("a",
                     "<inertial><origin xyz=\"1 2 3\"/><mass value=\"2.5\"/><inertia ixx=\"1\" "
                     "ixy=\"0\" ixz=\"0\" iyy=\"2\" iyz=\"0\" izz=\"2\"/></inertial>") +
            LinkText("b") +
            JointText("j", "revolute", "a", "b",
                      Origin("0.1 0.2 0.3", "0 0 1.5707963267948966") +
                          "<axis xyz=\"0 0 2\"/><limit lower=\"-1\" upper=\"2\" effort=\"3\" "
                          "velocity=\"4\"/><mimic joint=\"j\"/>")));
  EXPECT_EQ(model.name, "test");
  EXPECT_EQ(model.links[static_cast<std::size_t>(model.root)].name, "a");
  ASSERT_TRUE(model.links[0].inertial);
  EXPECT_EQ(model.links[0].inertial->mass_kg, 2.5);
  EXPECT_EQ(model.links[0].inertial->link_from_inertial.translation_m, Eigen::Vector3d(1, 2, 3));
  const Joint& joint = model.joints.at(0);
  EXPECT_EQ(joint.kind, Joint::Kind::kRevolute);
  EXPECT_EQ(joint.axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_THAT(joint.lower, Optional(-1.0));
  EXPECT_THAT(joint.upper, Optional(2.0));
  EXPECT_THAT(joint.effort, Optional(3.0));
  EXPECT_THAT(joint.velocity, Optional(4.0));
  EXPECT_EQ(joint.mimic, "j");
  const Eigen::Vector3d moved = joint.parent_from_child * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((moved - Eigen::Vector3d(0.1, 1.2, 0.3)).norm(), 1e-9);
}

TEST(ReadUrdfTest, OnlyTurningAndSlidingJointsThatStateEndsHaveThem) {
  const auto joint = [](const std::string& type, const std::string& limit) {
    return Read(Robot(LinkText("a") + LinkText("b") +
                      JointText("j", type, "a", "b",
                                "<limit effort=\"1\" velocity=\"2\"" + limit + "/>")))
        .joints[0];
  };
  const std::string ends = " lower=\"-1\" upper=\"2\"";
  for (const char* type : {"planar", "fixed", "floating", "continuous"}) {
    for (const std::string& limit : {std::string(), ends}) {
      EXPECT_FALSE(joint(type, limit).lower || joint(type, limit).upper) << type << limit;
      EXPECT_THAT(joint(type, limit).velocity, Optional(2.0)) << type;
    }
  }
  for (const char* type : {"revolute", "prismatic"}) {
    EXPECT_THAT(joint(type, ends).lower, Optional(-1.0)) << type;
    EXPECT_THAT(joint(type, ends).upper, Optional(2.0)) << type;
    EXPECT_THAT(joint(type, " upper=\"2\"").lower, Optional(0.0)) << type;
    EXPECT_FALSE(joint(type, "").lower || joint(type, "").upper) << type;
  }
}

TEST(ReadUrdfTest, NumbersArriveExactly) {
  const Model model =
      Read(Robot(LinkText("a") + LinkText("b") +
                 JointText("j", "fixed", "a", "b", Origin("0.1 -1e-7 3.3333333333333335"))));
  EXPECT_EQ(model.joints[0].parent_from_child.translation_m,
            Eigen::Vector3d(0.1, -1e-7, 3.3333333333333335));
}

TEST(ReadUrdfTest, PosesAreChainedFromTheRoot) {
  const Model model = Read(Cart());
  const urdf::Kinematics kinematics = urdf::MakeKinematics(model);
  const auto camera = static_cast<std::size_t>(model.FindLink("camera"));
  EXPECT_LT((kinematics.root_from_link[camera].translation_m - Eigen::Vector3d(0.1, 0, 1.0)).norm(),
            1e-9);
  // Pitched down: forward looks below the horizon.
  EXPECT_LT((kinematics.root_from_link[camera].rotation * Eigen::Vector3d::UnitX()).z(), -0.19);
}

TEST(ReadUrdfTest, SensorsOfTheSimulatorAreReadInSdfsForm) {
  const Model model = Read(Cart());
  ASSERT_EQ(model.sensors.size(), 2u);
  const Sensor& scan = model.sensors[0];
  EXPECT_EQ(scan.kind, Sensor::Kind::kLaser2d);
  EXPECT_THAT(scan.min_range_m, Optional(0.1));
  EXPECT_THAT(scan.max_range_m, Optional(12.0));
  EXPECT_THAT(scan.min_angle_rad, Optional(-2.3));
  EXPECT_THAT(scan.beam_count, Optional(270.0));
  EXPECT_THAT(scan.rate_hz, Optional(15.0));
  EXPECT_THAT(scan.noise, Optional(0.01));
  const Sensor& camera = model.sensors[1];
  EXPECT_EQ(camera.kind, Sensor::Kind::kRgbdCamera);
  EXPECT_THAT(camera.hfov_rad, Optional(1.0));
  EXPECT_THAT(camera.width_px, Optional(640.0));
  EXPECT_THAT(camera.max_range_m, Optional(6.0));
}

TEST(ReadUrdfTest, TheOldFormIsInDegreesAndItsPrefixNeedNotBeDeclared) {
  const Model model = Read(Robot(
      LinkText("a") +
      "<gazebo reference=\"a\"><sensor:ray name=\"r\"><rangeCount>683</rangeCount><minAngle>-90"
      "</minAngle><maxAngle>90</maxAngle><minRange>0.05</minRange><maxRange>10</maxRange>"
      "<updateRate>100</updateRate><controller:gazebo_ros_laser plugin=\"lib.so\"><updateRate>15"
      "</updateRate><topicName>scan</topicName></controller:gazebo_ros_laser></sensor:ray>"
      "</gazebo>\n<gazebo reference=\"a\"><sensor:camera name=\"c\"><imageFormat>R8G8B8"
      "</imageFormat><imageSize>640 480</imageSize><hfov>60</hfov></sensor:camera></gazebo>\n"));
  ASSERT_EQ(model.sensors.size(), 2u);
  EXPECT_EQ(model.sensors[0].kind, Sensor::Kind::kLaser2d);
  EXPECT_THAT(model.sensors[0].min_angle_rad, Optional(DoubleNear(-std::numbers::pi / 2, 1e-9)));
  EXPECT_THAT(model.sensors[0].rate_hz, Optional(15.0));
  EXPECT_EQ(model.sensors[0].topic, "scan");
  EXPECT_EQ(model.sensors[1].kind, Sensor::Kind::kCamera);
  EXPECT_THAT(model.sensors[1].hfov_rad, Optional(DoubleNear(std::numbers::pi / 3, 1e-9)));
  EXPECT_THAT(model.sensors[1].height_px, Optional(480.0));
}

TEST(ReadUrdfTest, UrdfsOwnSensorElementIsRead) {
  const Model model =
      Read(Robot(LinkText("a") +
                 "<sensor name=\"s\" update_rate=\"20\"><parent link=\"a\"/><origin xyz=\"0 0 "
                 "1\"/><camera><image width=\"320\" height=\"240\" hfov=\"1.2\" near=\"0.1\" "
                 "far=\"9\" format=\"L8\"/></camera></sensor>"));
  ASSERT_EQ(model.sensors.size(), 1u);
  EXPECT_EQ(model.sensors[0].link_from_sensor.translation_m.z(), 1);
  EXPECT_TRUE(model.sensors[0].monochrome);
  EXPECT_THAT(model.sensors[0].width_px, Optional(320.0));
}

TEST(ReadUrdfTest, ASensorOnALinkThatIsNotThereIsLeftOutWithAWarning) {
  const Model model = Read(Robot(LinkText("top") + "<gazebo reference=\"topp\"><sensor name=\"s\" "
                                                   "type=\"camera\"/></gazebo>"));
  EXPECT_TRUE(model.sensors.empty());
  ASSERT_EQ(model.findings.size(), 1u);
  EXPECT_EQ(model.findings[0].code, "sensor-nowhere");
  EXPECT_THAT(model.findings[0].remedy, HasSubstr("top"));
}

TEST(ReadUrdfTest, MeshesAreNamesAndThoseThatPointOutsideAreWarnedOf) {
  const Model model =
      Read(Robot(LinkText("a", Shape("<mesh filename=\"package://p/../../../etc/passwd\"/>") +
                                   Shape("<mesh filename=\"package://p/m..esh/a.stl\"/>"))));
  EXPECT_EQ(model.links[0].collision[0].mesh, "package://p/../../../etc/passwd");
  ASSERT_EQ(model.findings.size(), 1u);
  EXPECT_EQ(model.findings[0].code, "mesh-outside");
  EXPECT_EQ(model.findings[0].place.line, 3);
}

TEST(ReadUrdfTest, TheNamespaceOfXacroAloneIsFine) {
  EXPECT_NO_THROW(
      Read("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link "
           "name=\"a\"/></robot>"));
}

TEST(ReadUrdfTest, AUrdfIsKnownByItsRoot) {
  EXPECT_TRUE(urdf::IsUrdf("<?xml version=\"1.0\"?>\n<!-- <rdf:RDF> -->\n<robot name=\"x\"/>"));
  EXPECT_TRUE(urdf::IsUrdf("\xEF\xBB\xBF<robot/>"));
  EXPECT_FALSE(urdf::IsUrdf("<rdf:RDF><robot/></rdf:RDF>"));
  EXPECT_TRUE(urdf::IsUrdf("<robot\n name=\"x\"/>"));
  EXPECT_TRUE(urdf::IsUrdf("<robot><link/></robot>"));
  EXPECT_FALSE(urdf::IsUrdf("<robots/>"));
  EXPECT_FALSE(urdf::IsUrdf("<robot#scout1> a <urn:Robot> ."));
  EXPECT_FALSE(urdf::IsUrdf("<robot/scout1> a <urn:Robot> ."));
  EXPECT_FALSE(urdf::IsUrdf("@prefix robot: <urn:x> ."));
  EXPECT_FALSE(urdf::IsUrdf(""));
}

}  // namespace
}  // namespace lares::testing
