#include "robots/urdf/body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "robots/urdf/import.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using urdf::BaseKind;
using urdf::Imported;

Imported Import(const std::string& text, const std::string& base_frame = "") {
  return urdf::Import(text, "test.urdf", base_frame);
}

std::string Wheel(const std::string& name) {
  return LinkText(name,
                  "<collision><geometry><cylinder radius=\"0.05\" "
                  "length=\"0.02\"/></geometry></collision>");
}

std::string Turning(const std::string& name, const std::string& parent, const std::string& child,
                    const std::string& xyz, const std::string& axis) {
  return JointText(name, "continuous", parent, child, Origin(xyz) + "<axis xyz=\"" + axis + "\"/>");
}

TEST(BodyTest, TwoParallelWheelsOnBothSidesAreADifferentialBase) {
  const Imported robot = Import(Cart());
  EXPECT_EQ(robot.body.base.kind, BaseKind::kDifferential);
  EXPECT_EQ(robot.model.links[static_cast<std::size_t>(robot.body.base.link)].name, "base_link");
  EXPECT_THAT(robot.body.base.reason, HasSubstr("'left_wheel', 'right_wheel'"));
}

TEST(BodyTest, WheelsWhoseAxesPointInSeveralDirectionsAreHolonomic) {
  const Imported robot =
      Import(Robot(LinkText("base_link") + Wheel("wheel_1") + Wheel("wheel_2") + Wheel("wheel_3") +
                   Turning("j1", "base_link", "wheel_1", "0.2 0 0", "1 0 0") +
                   Turning("j2", "base_link", "wheel_2", "-0.1 0.17 0", "-0.5 0.87 0") +
                   Turning("j3", "base_link", "wheel_3", "-0.1 -0.17 0", "-0.5 -0.87 0")));
  EXPECT_EQ(robot.body.base.kind, BaseKind::kHolonomic);
  EXPECT_THAT(robot.body.base.reason, HasSubstr("3 directions"));
}

std::string Driven(const std::vector<std::string>& joints) {
  std::string text;
  for (const std::string& joint : joints) {
    text += "<transmission name=\"t\"><joint name=\"" + joint + "\"/></transmission>";
  }
  return text;
}

// A wheel on a joint of its own that turns it about the vertical.
std::string SteeredWheel(const std::string& name, const std::string& xyz,
                         const std::string& type = "continuous", const std::string& limit = "") {
  return LinkText(name + "_caster") + Wheel(name) +
         JointText(name + "_caster_joint", type, "base_link", name + "_caster",
                   Origin(xyz) + "<axis xyz=\"0 0 1\"/>" + limit) +
         Turning(name + "_joint", name + "_caster", name, "0 0 0", "0 1 0");
}

std::string RearWheels() {
  return LinkText("base_link") + Wheel("left_wheel") + Wheel("right_wheel") +
         Turning("left_wheel_joint", "base_link", "left_wheel", "0 0.2 0", "0 1 0") +
         Turning("right_wheel_joint", "base_link", "right_wheel", "0 -0.2 0", "0 1 0");
}

TEST(BodyTest, WheelsThatDrivenJointsSteerAreHolonomicAndCastersThatOnlyFollowAreNot) {
  const std::string casters =
      SteeredWheel("wheel_a", "0.2 0.1 0") + SteeredWheel("wheel_b", "0.2 -0.1 0");
  const auto followed = Import(Robot(RearWheels() + casters)).body.base;
  EXPECT_EQ(followed.kind, BaseKind::kDifferential);
  EXPECT_THAT(followed.reason, HasSubstr("'wheel_a', 'wheel_b' only follow"));
  EXPECT_EQ(Import(Robot(LinkText("base_link") + casters +
                         Driven({"wheel_a_caster_joint", "wheel_b_caster_joint"})))
                .body.base.kind,
            BaseKind::kHolonomic);
}

TEST(BodyTest, ACarWithSteeredWheelsBeforeFixedOnesCannotMoveSideways) {
  const auto driven = Import(Robot(RearWheels() + SteeredWheel("wheel_a", "0.2 0.1 0") +
                                   SteeredWheel("wheel_b", "0.2 -0.1 0") +
                                   Driven({"left_wheel_joint", "right_wheel_joint",
                                           "wheel_a_caster_joint", "wheel_b_caster_joint"})))
                          .body.base;
  EXPECT_EQ(driven.kind, BaseKind::kWheeled);
  EXPECT_EQ(ToString(driven.kind), "wheeled");
  EXPECT_THAT(driven.reason, HasSubstr("cannot move sideways"));
  // As most cars are written: no transmissions, and hinges with limits.
  const std::string limit = "<limit lower=\"-0.6\" upper=\"0.6\" effort=\"1\" velocity=\"1\"/>";
  const auto hinge = [&](const std::string& side, const std::string& xyz) {
    const std::string name = "front_" + side;
    return LinkText(name + "_hinge") + Wheel(name + "_wheel") +
           JointText(name + "_hinge_joint", "revolute", "base_link", name + "_hinge",
                     Origin(xyz) + "<axis xyz=\"0 0 1\"/>" + limit) +
           Turning(name + "_axle", name + "_hinge", name + "_wheel", "0 0 0", "0 1 0");
  };
  const std::string front = hinge("left", "0.2 0.2 0") + hinge("right", "0.2 -0.2 0");
  EXPECT_EQ(Import(Robot(RearWheels() + front)).body.base.kind, BaseKind::kWheeled);
  // Steered all of them, and none far enough.
  EXPECT_EQ(Import(Robot(LinkText("base_link") + front)).body.base.kind, BaseKind::kWheeled);
}

TEST(BodyTest, NonholonomicIsNotHolonomic) {
  const auto kind = [](const std::string& file) {
    return Import(Robot(LinkText("a") + "<gazebo><plugin name=\"p\" filename=\"" + file +
                        "\"/></gazebo>"))
        .body.base.kind;
  };
  EXPECT_EQ(kind("libholonomic_drive.so"), BaseKind::kHolonomic);
  for (const char* file : {"libnonholonomic_drive.so", "libnon_holonomic.so", "Non-Holonomic.so"}) {
    EXPECT_EQ(kind(file), BaseKind::kUnknown) << file;
  }
  EXPECT_EQ(kind("libgazebo_ros_ackermann_drive.so"), BaseKind::kWheeled);
}

TEST(BodyTest, AGantryIsNoBaseAndSlidesThatTurnAsWellAreOne) {
  const auto slide = [](const std::string& name, const std::string& parent,
                        const std::string& axis) {
    return LinkText(name) + JointText(name + "_joint", "prismatic", parent, name,
                                      "<axis xyz=\"" + axis +
                                          "\"/><limit lower=\"0\" upper=\"2\" effort=\"1\" "
                                          "velocity=\"1\"/>");
  };
  const std::string across =
      LinkText("world") + slide("x", "world", "1 0 0") + slide("y", "x", "0 1 0");
  EXPECT_NE(Import(Robot(across)).body.base.kind, BaseKind::kHolonomic);
  const std::string tool = slide("z", "y", "0 0 1") + LinkText("tool") +
                           Turning("tool_joint", "z", "tool", "0 0 0", "0 0 1");
  EXPECT_EQ(Import(Robot(across + tool)).body.base.kind, BaseKind::kFixed);
  const std::string base =
      LinkText("base_link") + Turning("yaw", "y", "base_link", "0 0 0", "0 0 1");
  EXPECT_EQ(Import(Robot(across + base)).body.base.kind, BaseKind::kHolonomic);
  // Two that slide along each other are a telescope.
  EXPECT_NE(Import(Robot(LinkText("world") + slide("x", "world", "1 0 0") +
                         slide("y", "x", "1 0 0") + base))
                .body.base.kind,
            BaseKind::kHolonomic);
}

TEST(BodyTest, APluginAPlanarJointOrTracksTellHowTheBaseMoves) {
  const std::string plugin = "<gazebo><plugin name=\"p\" filename=\"";
  EXPECT_EQ(Import(Robot(LinkText("a") + plugin + "libgazebo_ros_planar_move.so\"/></gazebo>"))
                .body.base.kind,
            BaseKind::kHolonomic);
  EXPECT_EQ(Import(Robot(LinkText("a") + plugin + "libgazebo_ros_diff_drive.so\"/></gazebo>"))
                .body.base.kind,
            BaseKind::kDifferential);
  EXPECT_EQ(
      Import(Robot(LinkText("world") + LinkText("a") + JointText("j", "planar", "world", "a")))
          .body.base.kind,
      BaseKind::kHolonomic);
  EXPECT_EQ(Import(Robot(LinkText("a") + LinkText("left_track") + LinkText("right_track") +
                         JointText("l", "fixed", "a", "left_track") +
                         JointText("r", "fixed", "a", "right_track")))
                .body.base.kind,
            BaseKind::kTracked);
}

TEST(BodyTest, WithoutAnySignTheBaseIsUnknownAndTheAnswerSaysSo) {
  const Imported robot = Import(Robot(LinkText("thing")));
  EXPECT_EQ(robot.body.base.kind, BaseKind::kUnknown);
  EXPECT_FALSE(robot.body.footprint);
  EXPECT_THAT(robot.body.notes, ::testing::Contains(HasSubstr("how the base drives")));
  EXPECT_EQ(Import(Robot(LinkText("world") + LinkText("a") + JointText("j", "fixed", "world", "a")))
                .body.base.kind,
            BaseKind::kFixed);
}

TEST(BodyTest, TheFootprintIsTheHullOfTheShapesNearTheFloor) {
  const Imported robot = Import(Cart());
  ASSERT_TRUE(robot.body.footprint);
  EXPECT_NEAR(robot.body.footprint->length_m, 0.5, 1e-9);
  EXPECT_NEAR(robot.body.footprint->width_m, 0.48, 1e-3);
  EXPECT_NEAR(robot.body.footprint->radius_m, std::hypot(0.25, 0.2), 1e-3);
  EXPECT_NEAR(robot.body.floor_m, 0, 1e-9);
  ASSERT_TRUE(robot.body.height);
  EXPECT_NEAR(robot.body.height->height_m, 1.0, 1e-9);  // the camera on its mast
}

// How far the footprint reaches beyond a circle about the origin, and how far within it stays.
struct Around {
  double nearest_side_m = 1e9, furthest_corner_m = 0;
};
Around MeasureAround(const urdf::Footprint& footprint) {
  Around around;
  for (std::size_t i = 0; i < footprint.polygon_m.size(); ++i) {
    const Eigen::Vector2d& from = footprint.polygon_m[i];
    const Eigen::Vector2d& to = footprint.polygon_m[(i + 1) % footprint.polygon_m.size()];
    const double area = from.x() * to.y() - from.y() * to.x();
    around.nearest_side_m = std::min(around.nearest_side_m, area / (to - from).norm());
    around.furthest_corner_m = std::max(around.furthest_corner_m, from.norm());
  }
  return around;
}

std::string RoundRobot(const std::string& shape, const std::string& rpy) {
  return Robot(LinkText("base_link", "<collision>" + Origin("0 0 0", rpy) + "<geometry>" + shape +
                                         "</geometry></collision>"));
}

TEST(BodyTest, ASphereIsHeldHoweverItIsTurned) {
  for (const char* rpy : {"0 0 0", "0.785 0 0", "0.3 0.785 0.1", "1.5707963 0 0"}) {
    const auto body = Import(RoundRobot("<sphere radius=\"0.25\"/>", rpy)).body;
    ASSERT_TRUE(body.footprint && body.height) << rpy;
    EXPECT_NEAR(body.footprint->width_m, 0.5, 1e-9) << rpy;
    EXPECT_NEAR(body.footprint->length_m, 0.5, 1e-9) << rpy;
    EXPECT_GE(MeasureAround(*body.footprint).nearest_side_m, 0.25 - 1e-9) << rpy;
    EXPECT_NEAR(body.height->height_m, 0.25, 1e-9) << rpy;
  }
}

TEST(BodyTest, ACylinderIsHeldHoweverItIsTurned) {
  const std::string upright = "<cylinder radius=\"0.25\" length=\"0.2\"/>";
  for (const char* rpy : {"0 0 0", "0 0 0.1308996939", "0 0 0.7"}) {
    const auto body = Import(RoundRobot(upright, rpy)).body;
    ASSERT_TRUE(body.footprint) << rpy;
    EXPECT_GE(MeasureAround(*body.footprint).nearest_side_m, 0.25 - 1e-9) << rpy;
    EXPECT_LE(MeasureAround(*body.footprint).furthest_corner_m, 0.25 * 1.009) << rpy;
  }
  const auto body = Import(RoundRobot(upright, "0 0 0")).body;
  EXPECT_NEAR(body.footprint->width_m, 0.5, 1e-9);
  // Lying, and turned about its own axis: the top is no lower than the radius.
  for (const char* rpy : {"1.5707963268 0 0", "1.5707963268 0.13 0", "1.5707963268 0.4 0"}) {
    const auto lying = Import(RoundRobot(upright, rpy)).body;
    ASSERT_TRUE(lying.height) << rpy;
    EXPECT_GE(lying.height->height_m, 0.25 - 1e-9) << rpy;
  }
}

TEST(BodyTest, MeshesAreNotOpenedAndTheFootprintSaysSo) {
  const Imported robot = Import(Robot(LinkText(
      "base_link", Shape("<mesh filename=\"a.stl\"/>") + Shape("<box size=\"0.4 0.2 0.1\"/>"))));
  ASSERT_TRUE(robot.body.footprint);
  EXPECT_NEAR(robot.body.footprint->length_m, 0.4, 1e-9);
  EXPECT_THAT(robot.body.footprint->reason, HasSubstr("meshes are not opened"));
}

// Base, shoulder, elbow, wrist, palm with two fingers; a head beside it.
std::string Manipulator() {
  const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  const auto joint = [&](const std::string& name, const std::string& parent,
                         const std::string& child, const std::string& xyz,
                         const std::string& axis) {
    return JointText(name, "revolute", parent, child,
                     Origin(xyz) + "<axis xyz=\"" + axis + "\"/>" + limit);
  };
  return Robot(
      LinkText("base_link") + LinkText("torso") + LinkText("upper_arm") + LinkText("forearm") +
      LinkText("wrist") + LinkText("l_palm") + LinkText("finger_1") + LinkText("finger_2") +
      LinkText("pan") + LinkText("tilt") + LinkText("cam") + LinkText("cam_optical") +
      JointText("lift", "prismatic", "base_link", "torso",
                Origin("0 0 0.5") +
                    "<axis xyz=\"0 0 1\"/><limit lower=\"0\" upper=\"0.3\" effort=\"1\" "
                    "velocity=\"1\"/>") +
      joint("shoulder", "torso", "upper_arm", "0.1 0 0.2", "0 0 1") +
      joint("elbow", "upper_arm", "forearm", "0.3 0 0", "0 1 0") +
      joint("wrist", "forearm", "wrist", "0.2 0 0", "0 1 0") +
      JointText("palm", "fixed", "wrist", "l_palm", Origin("0.1 0 0")) +
      joint("finger_1_joint", "l_palm", "finger_1", "0.05 0.02 0", "0 0 1") +
      joint("finger_2_joint", "l_palm", "finger_2", "0.05 -0.02 0", "0 0 1") +
      joint("pan", "torso", "pan", "0 0 0.4", "0 0 1") +
      joint("tilt", "pan", "tilt", "0 0 0.1", "0 1 0") +
      JointText("cam", "fixed", "tilt", "cam", Origin("0.05 0 0")) +
      JointText("opt", "fixed", "cam", "cam_optical", Origin("0 0 0", "-1.5708 0 -1.5708")));
}

TEST(BodyTest, ArmsEndInFingersAndBeginWhereTheBodyBranches) {
  const Imported robot = Import(Manipulator());
  ASSERT_EQ(robot.body.arms.size(), 1u);
  const urdf::Arm& arm = robot.body.arms[0];
  const auto name = [&](int link) {
    return robot.model.links[static_cast<std::size_t>(link)].name;
  };
  EXPECT_EQ(name(arm.base_link), "upper_arm");
  EXPECT_EQ(name(arm.end_link), "l_palm");
  EXPECT_EQ(arm.joints.size(), 3u);
  EXPECT_NEAR(arm.reach_m, 0.3 + 0.2 + 0.1, 1e-9);
  EXPECT_EQ(arm.side, "left");
  ASSERT_EQ(robot.body.grippers.size(), 1u);
  EXPECT_EQ(name(robot.body.grippers[0].palm), "l_palm");
  EXPECT_EQ(robot.body.grippers[0].fingers.size(), 2u);
  ASSERT_EQ(robot.body.heads.size(), 1u);
  EXPECT_EQ(name(robot.body.heads[0].link), "pan");
  ASSERT_EQ(robot.body.torsos.size(), 1u);
  EXPECT_EQ(name(robot.body.torsos[0].link), "torso");
}

TEST(BodyTest, WhereTheSimulatorKnowsNoSensorsNamesTellThem) {
  const Imported robot = Import(Manipulator());
  ASSERT_EQ(robot.body.sensors.size(), 1u);
  EXPECT_EQ(robot.body.sensors[0].sensor.kind, urdf::Sensor::Kind::kCamera);
  EXPECT_EQ(robot.body.sensors[0].sensor.frame, "cam_optical");
  EXPECT_NEAR(robot.body.sensors[0].base_from_sensor.translation_m.z(), 1.0, 1e-9);
  EXPECT_THAT(robot.body.sensors[0].sensor.reason, HasSubstr("neither range nor field of view"));
}

TEST(BodyTest, TheBaseFrameIsChosenOrNamed) {
  EXPECT_NEAR(Import(Cart()).body.sensors[0].base_from_sensor.translation_m.z(), 0.25, 1e-9);
  const Imported seen = Import(Cart(), "base_link");
  EXPECT_NEAR(seen.body.sensors[0].base_from_sensor.translation_m.z(), 0.15, 1e-9);
  EXPECT_NEAR(seen.body.floor_m, -0.1, 1e-6);
  try {
    Import(Cart(), "base_lonk");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kNotFound);
    EXPECT_THAT(error.candidates(), ::testing::Contains("base_link"));
  }
}

}  // namespace
}  // namespace lares::testing
