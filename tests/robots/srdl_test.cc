#include "robots/urdf/srdl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ontology/rdf/reader.h"
#include "robots/urdf/import.h"
#include "tests/robots/robot_texts.h"

namespace lares::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Srdl(const std::string& urdf, urdf::SrdlOptions options = {}) {
  options.id = "cart";
  const urdf::Imported robot = urdf::Import(urdf, "cart.urdf");
  return urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options);
}

TEST(SrdlTest, IsTurtleThatCanBeReadAndIsTheSameEachTime) {
  const std::string srdl = Srdl(Cart());
  rdf::ReadOptions options;
  options.base_iri = "urn:x";
  const rdf::Document document = rdf::ReadRdf(srdl, rdf::Format::kTurtle, options);
  EXPECT_GT(document.statements.size(), 200u);
  EXPECT_EQ(srdl, Srdl(Cart()));
}

TEST(SrdlTest, ComponentsHaveTheirClassesValuesAndReasons) {
  const std::string srdl = Srdl(Cart());
  EXPECT_THAT(srdl, HasSubstr(":Cart a owl:Class"));
  EXPECT_THAT(srdl, HasSubstr("rdfs:subClassOf lares:MobileRobot"));
  EXPECT_THAT(srdl, HasSubstr(":base_link a owl:NamedIndividual , lares:UrdfLink , "
                              "lares:DifferentialBase"));
  EXPECT_THAT(srdl, HasSubstr("base, differential: 2 wheels"));
  EXPECT_THAT(srdl, HasSubstr(":laser a owl:NamedIndividual , lares:UrdfLink , "
                              "lares:TwoDimensionalLaserScanner"));
  EXPECT_THAT(srdl, HasSubstr(":camera a owl:NamedIndividual , lares:UrdfLink , lares:RGBDCamera"));
  EXPECT_THAT(srdl, HasSubstr("lares:hfov_rad \"1\"^^xsd:double"));
  EXPECT_THAT(srdl, HasSubstr("lares:vfov_rad \"0.7777"));
  EXPECT_THAT(srdl, HasSubstr("lares:footprintPolygon_m \""));
  EXPECT_THAT(srdl, HasSubstr("lares:relativeTo :pose_of_base_link"));
  EXPECT_THAT(srdl, Not(HasSubstr("hasCapability")));
}

TEST(SrdlTest, WhatIsStatedBecomesAPartWithAReason) {
  urdf::SrdlOptions options;
  options.stated = {{"https://w3id.org/lares#NavigationComponent", "navigation component"},
                    {"http://example.org/my parts", "odd"}};
  const std::string srdl = Srdl(Cart(), options);
  EXPECT_THAT(srdl, AllOf(HasSubstr("lares:NavigationComponent"),
                          HasSubstr("stated by whoever put the robot here")));
}

TEST(SrdlTest, ASecondSensorOrOneBesideTheLinkGetsALinkOfItsOwn) {
  const std::string two =
      Robot(LinkText("a") + LinkText("b") + JointText("j", "fixed", "a", "b", Origin("0 0 1")) +
            "<gazebo reference=\"b\"><sensor name=\"one\" type=\"camera\"/><sensor name=\"two\" "
            "type=\"ray\"><pose>0 0 0.5 0 0 0</pose></sensor></gazebo>");
  const std::string srdl = Srdl(two);
  EXPECT_THAT(srdl, HasSubstr(":b a owl:NamedIndividual , lares:UrdfLink , lares:ColorCamera"));
  EXPECT_THAT(srdl, HasSubstr("lares:succeedingJoint :two_sensor_joint"));
  EXPECT_THAT(srdl, HasSubstr(":pose_of_two_sensor a owl:NamedIndividual , lares:RotationMatrix3D "
                              ";\n    lares:relativeTo :pose_of_b"));
}

TEST(SrdlTest, ALinkAndAJointMayShareAName) {
  const std::string srdl =
      Srdl(Robot(LinkText("a") + LinkText("arm") + JointText("arm", "fixed", "a", "arm")));
  EXPECT_THAT(srdl, HasSubstr(":arm_2 a owl:NamedIndividual , lares:FixedUrdfJoint"));
}

}  // namespace
}  // namespace lares::testing
