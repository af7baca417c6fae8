#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "robots/urdf/doctor.h"
#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "robots/urdf/structure.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::HasSubstr;

Error Refused(const std::string& text, const urdf::Limits& limits = {}) {
  try {
    urdf::ReadUrdf(text, "bad.urdf", limits);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "it was read: " << text.substr(0, 200);
  return Error(Code::kInternal, "");
}

// The fault names its line and says what is wrong.
void ExpectFault(const std::string& text, int line, const std::string& what) {
  const Error error = Refused(text);
  EXPECT_EQ(error.code(), Code::kInvalid) << error.what();
  ASSERT_TRUE(error.place()) << error.what();
  EXPECT_EQ(error.place()->line, line) << error.what();
  EXPECT_THAT(error.what(), HasSubstr(what));
}

TEST(HostileUrdfTest, TwoRootsAreNamed) {
  ExpectFault(Robot(LinkText("a") + LinkText("b")), 4, "'a', 'b'");
}

TEST(HostileUrdfTest, ACircleIsNamed) {
  ExpectFault(Robot(LinkText("root") + LinkText("a") + LinkText("b") +
                    JointText("ab", "fixed", "a", "b") + JointText("ba", "fixed", "b", "a")),
              6, "circle: 'a' on 'b' on 'a'");
}

TEST(HostileUrdfTest, ALinkOnItselfIsACircle) {
  const Error error = Refused(Robot(LinkText("a") + JointText("j", "fixed", "a", "a")));
  EXPECT_THAT(error.what(), HasSubstr("circle"));
}

TEST(HostileUrdfTest, ALinkOnTwoJointsIsNamed) {
  ExpectFault(Robot(LinkText("a") + LinkText("b") + JointText("j", "fixed", "a", "b") +
                    JointText("k", "fixed", "a", "b")),
              6, "'j' and 'k'");
}

TEST(HostileUrdfTest, NamesThatAreThereTwiceAreNamed) {
  ExpectFault(Robot(LinkText("a") + LinkText("a")), 4, "first in line 3");
  ExpectFault(Robot(LinkText("a") + LinkText("b") + LinkText("c") +
                    JointText("j", "fixed", "a", "b") + JointText("j", "fixed", "a", "c")),
              7, "the joint 'j' is there twice");
}

TEST(HostileUrdfTest, AMissingLinkIsNamedWithWhatItMayBe) {
  const Error error =
      Refused(Robot(LinkText("base_link") + JointText("j", "fixed", "base_lonk", "base_link")));
  EXPECT_THAT(error.what(), HasSubstr("'base_lonk'"));
  EXPECT_THAT(error.hint(), HasSubstr("base_link"));
}

// How many findings say what a name may have stood for.
std::size_t Suggested(const std::vector<urdf::Finding>& findings) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [](const urdf::Finding& finding) {
        return finding.remedy.find("did you mean") != std::string::npos;
      }));
}

TEST(HostileUrdfTest, OnlyTheFirstMissingNamesAreComparedWithAllOthers) {
  std::string text;
  for (int i = 10; i < 60; ++i) {
    const std::string link = "link_" + std::to_string(i);
    text +=
        LinkText(link) + JointText("joint_" + std::to_string(i), "fixed", link + "_", link + "0");
  }
  const auto findings = urdf::Examine(Robot(text), "bad.urdf");
  EXPECT_GE(findings.size(), 100u);
  EXPECT_EQ(Suggested(findings), urdf::kMostSuggested);
}

TEST(HostileUrdfTest, ThousandsOfLongWrongNamesAreRefusedWithoutComparingThem) {
  std::string text;
  for (int i = 10'000; i < 12'000; ++i) {
    const std::string link = std::string(250, 'a' + i % 26) + std::to_string(i);
    text += LinkText(link) + JointText("j" + std::to_string(i), "fixed", "x" + link.substr(1),
                                       "y" + link.substr(1), "<mimic joint=\"z" + link + "\"/>");
  }
  const auto findings = urdf::Examine(Robot(text), "bad.urdf");
  EXPECT_GE(findings.size(), 200u);
  // One suggestion for such a name alone compares a hundred million pairs of characters.
  EXPECT_EQ(Suggested(findings), 0u);
}

TEST(HostileUrdfTest, AJointWithoutParentChildOrTypeIsNamed) {
  ExpectFault(Robot(LinkText("a") + "<joint name=\"j\" type=\"fixed\"><child link=\"a\"/></joint>"),
              4, "has no <parent>");
  ExpectFault(
      Robot(LinkText("a") + "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>"), 4,
      "has no <child>");
  ExpectFault(Robot(LinkText("a") + LinkText("b") + JointText("j", "hinge", "a", "b")), 5,
              "unknown type 'hinge'");
}

TEST(HostileUrdfTest, LimitsAreMissedOnTurningAndSlidingJoints) {
  ExpectFault(Robot(LinkText("a") + LinkText("b") + JointText("j", "revolute", "a", "b")), 5,
              "has no <limit>");
}

TEST(HostileUrdfTest, WhatIsNoNumberIsNamedWithElementAttributeAndLine) {
  for (const char* value : {"nan", "inf", "-INF", "1e999", "1,5", "0x10", "", "1e20", "1 2"}) {
    const std::string text =
        Robot(LinkText("a", "<inertial><mass value=\"" + std::string(value) + "\"/></inertial>"));
    ExpectFault(text, 3, "attribute 'value' of <mass>");
  }
  for (const char* value : {"0 0", "0 0 0 0", "0 0 nan", "0 zero 0", "1,0,0"}) {
    ExpectFault(
        Robot(LinkText("a") + LinkText("b") + JointText("j", "fixed", "a", "b", Origin(value))), 5,
        "attribute 'xyz' of <origin>");
  }
}

TEST(HostileUrdfTest, ANegativeSizeIsNamed) {
  ExpectFault(Robot(LinkText("a", Shape("<sphere radius=\"-1\"/>"))), 3, "negative");
  ExpectFault(Robot(LinkText("a", Shape("<box size=\"1 -1 1\"/>"))), 3, "negative");
  ExpectFault(Robot(LinkText("a", Shape("<cylinder radius=\"1\"/>"))), 3, "'length'");
}

TEST(HostileUrdfTest, XacroThatWasNotExpandedIsRefusedWithTheCommandToRun) {
  const Error element = Refused(
      "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<xacro:property "
      "name=\"a\"/></robot>");
  EXPECT_THAT(element.what(), HasSubstr("<xacro:property>"));
  EXPECT_THAT(element.hint(), HasSubstr("xacro FILE > robot.urdf"));
  EXPECT_THAT(element.hint(), HasSubstr("ros2 run xacro xacro"));
  EXPECT_EQ(element.place()->line, 2);
  const Error undeclared = Refused(Robot("<xacro:include filename=\"a\"/>"));
  EXPECT_THAT(undeclared.hint(), HasSubstr("xacro FILE"));
  const Error value = Refused(Robot(LinkText("${name}_link")));
  EXPECT_THAT(value.what(), HasSubstr("${name}_link"));
  EXPECT_THAT(value.hint(), HasSubstr("xacro FILE"));
  const Error text = Refused(
      Robot(LinkText("a") +
            "<gazebo><plugin><robotNamespace>$(arg ns)</robotNamespace></plugin></gazebo>"));
  EXPECT_THAT(text.what(), HasSubstr("$(arg ns)"));
}

TEST(HostileUrdfTest, DocumentTypesAndEntitiesAreRefused) {
  const Error error = Refused(
      "<?xml version=\"1.0\"?>\n<!DOCTYPE robot [<!ENTITY a \"b\">]>\n<robot name=\"&a;\"/>");
  EXPECT_EQ(error.code(), Code::kUnsupported);
  EXPECT_EQ(error.place()->line, 2);
  EXPECT_EQ(Refused("<robot name=\"&a;\"/>").code(), Code::kInvalid);
}

TEST(HostileUrdfTest, WhatIsNoUrdfIsRefused) {
  EXPECT_THAT(Refused("<sdf version=\"1.6\"/>").what(), HasSubstr("<sdf>, not <robot>"));
  Refused("");
  Refused("   \n");
  Refused("<robot");
  Refused("<robot name=\"r\"><link name=\"a\"></robot>");
  Refused("<robot name=\"r\"/>");
  Refused("<robot><link name=\"a\"/></robot>");
  Refused(std::string("<robot name=\"a\0b\"/>", 18));
  Refused("<robot name=\"\xFF\xFE\"><link name=\"a\"/></robot>");
  Refused(Robot(LinkText("")));
}

TEST(HostileUrdfTest, AMillionJointsAreRefusedByTheLimitsName) {
  std::string text = "<robot name=\"r\">";
  for (int i = 0; i < 1'000'000; ++i) text += "<joint/>";
  const Error error = Refused(text + "</robot>");
  EXPECT_EQ(error.code(), Code::kTooLarge);
  EXPECT_THAT(error.what(), HasSubstr("max_joints"));
}

TEST(HostileUrdfTest, EachLimitIsNamed) {
  urdf::Limits limits;
  limits.max_bytes = 10;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_bytes"));
  limits = {};
  limits.max_links = 3;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_links"));
  limits = {};
  limits.max_elements = 20;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_elements"));
  limits = {};
  limits.max_sensors = 1;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_sensors"));
  limits = {};
  limits.max_chain = 2;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_chain"));
  limits = {};
  limits.max_value_bytes = 5;
  EXPECT_THAT(Refused(Cart(), limits).what(), HasSubstr("max_value_bytes"));
  std::string deep = "<robot name=\"r\">";
  for (int i = 0; i < 100; ++i) deep += "<a>";
  EXPECT_EQ(Refused(deep).code(), Code::kTooLarge);
}

TEST(HostileUrdfTest, NamesWithMarkupInThemStayNames) {
  const std::string name = "a&lt;b&gt; &quot;c&quot; é/#%";
  const urdf::Imported robot = urdf::Import(Robot(LinkText(name)), "test.urdf");
  EXPECT_EQ(robot.model.links[0].name, "a<b> \"c\" é/#%");
  urdf::SrdlOptions options;
  options.id = "r";
  const std::string srdl = urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
  EXPECT_THAT(srdl, HasSubstr(":a%3Cb%3E%20%22c%22%20%C3%A9%2F%23%25 a owl:NamedIndividual"));
}

TEST(HostileUrdfTest, TheLargestRobotThatIsTakenIsReadInTime) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += LinkText("l" + std::to_string(i));
  for (int i = 1; i < 2000; ++i) {
    const int parent = i % 199 == 1 ? 0 : i - 1;
    text += JointText("finger_joint" + std::to_string(i), "revolute", "l" + std::to_string(parent),
                      "l" + std::to_string(i), "<limit effort=\"1\" velocity=\"1\"/>");
  }
  EXPECT_NO_THROW(urdf::Import(Robot(text), "large.urdf"));
}

}  // namespace
}  // namespace lares::testing
