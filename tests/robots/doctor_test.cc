#include "robots/urdf/doctor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ontology/rdf/aliases.h"
#include "ontology/rdf/reader.h"
#include "robots/urdf/import.h"
#include "robots/urdf/srdl.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;
using urdf::Finding;

std::vector<std::string> Codes(const std::vector<Finding>& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

std::vector<std::string> CodesOf(const std::string& text) {
  return Codes(urdf::Examine(text, "test.urdf"));
}

std::string Inertial(const std::string& mass, const std::string& ixx, const std::string& ixy,
                     const std::string& izz = "1") {
  return "<inertial><mass value=\"" + mass + "\"/><inertia ixx=\"" + ixx + "\" ixy=\"" + ixy +
         "\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"" + izz + "\"/></inertial>";
}

std::string OneLink(const std::string& body) { return Robot(LinkText("base_link", body)); }

TEST(DoctorTest, ASoundRobotHasNoFindings) {
  EXPECT_THAT(CodesOf(Robot(LinkText("base_link"))), IsEmpty());
}

TEST(DoctorTest, InertiaIsExamined) {
  EXPECT_THAT(CodesOf(OneLink(Inertial("1", "1", "0"))), Not(Contains("not-positive-definite")));
  EXPECT_THAT(CodesOf(OneLink(Inertial("1", "1", "5"))), Contains("not-positive-definite"));
  EXPECT_THAT(CodesOf(OneLink(Inertial("1", "1", "0", "9"))), Contains("impossible-inertia"));
  EXPECT_THAT(CodesOf(OneLink(Inertial("0", "1", "0"))), Contains("zero-mass"));
  EXPECT_THAT(CodesOf(OneLink(Inertial("-1", "1", "0"))), Contains("negative-mass"));
  EXPECT_THAT(CodesOf(OneLink("<inertial><mass value=\"1\"/></inertial>")), Contains("no-tensor"));
  EXPECT_THAT(CodesOf(OneLink(Shape("<sphere radius=\"1\"/>"))), Contains("no-inertia"));
}

TEST(DoctorTest, FramesAreExamined) {
  EXPECT_THAT(CodesOf(Robot(LinkText("a"))), Contains("no-base-link"));
  const auto optical = [](const std::string& rpy) {
    return CodesOf(
        Robot(LinkText("base_link") + LinkText("camera_optical_frame") +
              JointText("j", "fixed", "base_link", "camera_optical_frame", Origin("0 0 1", rpy))));
  };
  EXPECT_THAT(optical("-1.5708 0 -1.5708"), Not(Contains("optical-frame")));
  EXPECT_THAT(optical("0 0 0"), Contains("optical-frame"));
  EXPECT_THAT(optical("-1.5708 0 1.5708"), Contains("optical-frame"));
  EXPECT_THAT(CodesOf(Robot(LinkText("base_footprint") + LinkText("base_link") +
                            JointText("j", "fixed", "base_footprint", "base_link",
                                      Origin("0 0 -0.1", "0 0 1")))),
              ::testing::IsSupersetOf({"base-turned", "base-below-floor"}));
}

TEST(DoctorTest, UnitsAreSuspected) {
  EXPECT_THAT(CodesOf(OneLink(Inertial("5000", "1", "0"))), Contains("unit-grams"));
  const auto joint = [](const std::string& body) {
    return CodesOf(Robot(LinkText("base_link") + LinkText("b") +
                         JointText("j", "revolute", "base_link", "b", body)));
  };
  const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  EXPECT_THAT(joint(Origin("0 0 1") + limit), Not(Contains("unit-degrees")));
  EXPECT_THAT(joint(Origin("0 0 1", "0 90 0") + limit), Contains("unit-degrees"));
  EXPECT_THAT(joint(Origin("0 0 350") + limit), Contains("unit-millimetres"));
  EXPECT_THAT(joint("<limit lower=\"-90\" upper=\"90\" effort=\"1\" velocity=\"1\"/>"),
              Contains("unit-degrees"));
}

TEST(DoctorTest, LimitsAreExamined) {
  const auto limit = [](const std::string& text) {
    return CodesOf(Robot(LinkText("base_link") + LinkText("b") +
                         JointText("j", "revolute", "base_link", "b", "<limit " + text + "/>")));
  };
  EXPECT_THAT(limit("lower=\"1\" upper=\"-1\" effort=\"1\" velocity=\"1\""),
              Contains("limits-swapped"));
  EXPECT_THAT(limit("lower=\"1\" upper=\"1\" effort=\"1\" velocity=\"1\""),
              Contains("limits-equal"));
  EXPECT_THAT(limit("lower=\"0\" upper=\"1\""),
              ::testing::IsSupersetOf({"no-effort", "no-velocity"}));
}

TEST(DoctorTest, JointsWithoutEndsAreNotSaidToStandStill) {
  const auto codes = [](const std::string& type) {
    return CodesOf(
        Robot(LinkText("base_link") + LinkText("b") +
              JointText("j", type, "base_link", "b", "<limit effort=\"1\" velocity=\"1\"/>")));
  };
  for (const char* type : {"planar", "floating", "fixed"}) {
    EXPECT_THAT(codes(type), Not(Contains("limits-equal"))) << type;
    EXPECT_THAT(codes(type), Not(Contains("no-ends"))) << type;
  }
  EXPECT_THAT(codes("revolute"), Contains("no-ends"));
}

TEST(DoctorTest, WhatCannotBeReadIsAFindingWithItsLine) {
  const auto findings = urdf::Examine("<robot name=\"r\">\n<link", "bad.urdf");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Finding::Severity::kError);
  EXPECT_EQ(findings[0].place.line, 2);
  EXPECT_THAT(CodesOf(Robot(LinkText("a") + LinkText("b"))), Contains("two-roots"));
}

std::vector<Finding> Compared(const std::string& urdf, const std::string& srdl) {
  rdf::Dictionary dictionary;
  rdf::ReadOptions options;
  options.base_iri = "urn:x";
  const rdf::Graph graph = rdf::MakeGraph(rdf::ReadRdf(srdl, rdf::Format::kTurtle, options), "srdl",
                                          rdf::AliasTable{}, dictionary);
  const urdf::SrdlToCompare compared{graph, dictionary, "cart"};
  return urdf::Examine(urdf, "test.urdf", &compared);
}

std::string CartSrdl() {
  const urdf::Imported robot = urdf::Import(Cart(), "test.urdf");
  urdf::SrdlOptions options;
  options.id = "cart";
  return urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
}

TEST(DoctorTest, AUrdfAgreesWithItsOwnSrdl) {
  for (const std::string& code : Codes(Compared(Cart(), CartSrdl()))) {
    EXPECT_EQ(code.find("only-in"), std::string::npos) << code;
    EXPECT_NE(code, "pose-differs");
    EXPECT_NE(code, "joint-kind-differs");
  }
}

TEST(DoctorTest, WhatDiffersFromTheSrdlIsNamed) {
  std::string moved = Cart();
  moved.replace(moved.find("0.2 0 0.15"), 10, "0.2 0 0.16");
  EXPECT_THAT(Codes(Compared(moved, CartSrdl())), Contains("pose-differs"));
  std::string slight = Cart();
  slight.replace(slight.find("0.2 0 0.15"), 10, "0.2 0 .1505");
  EXPECT_THAT(Codes(Compared(slight, CartSrdl())), Not(Contains("pose-differs")));
  EXPECT_THAT(Codes(Compared(Robot(LinkText("base_link")), CartSrdl())),
              ::testing::IsSupersetOf({"link-only-in-srdl", "joint-only-in-srdl"}));
  std::string other = Cart();
  while (other.find("\"laser\"") != std::string::npos) {
    other.replace(other.find("\"laser\""), 7, "\"lidar\"");
  }
  EXPECT_THAT(Codes(Compared(other, CartSrdl())),
              ::testing::IsSupersetOf({"link-only-in-urdf", "link-only-in-srdl"}));
}

}  // namespace
}  // namespace lares::testing
