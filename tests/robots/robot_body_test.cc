#include "robots/body/robot_body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "robots/urdf/import.h"
#include "tests/robots/robot_texts.h"

namespace lares::robots {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kRobot[] = "https://example.org/r";

rdf::View ViewOf(const std::string& turtle, std::vector<rdf::Triple> inferred = {}) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  rdf::ReadOptions options;
  options.source = "robot.ttl";
  std::vector<rdf::Graph> graphs;
  graphs.push_back(rdf::MakeGraph(rdf::ReadRdf(turtle, rdf::Format::kTurtle, options), "robot:r",
                                  rdf::AliasTable{}, *dictionary));
  return rdf::View(dictionary)
      .With(std::make_shared<const rdf::Layer>(std::move(graphs), std::move(inferred),
                                               std::vector<rdf::Clash>()));
}

RobotBody BodyOf(const std::string& statements) {
  return ReadRobotBody(
      ViewOf(
          "@prefix lares: <https://w3id.org/lares#> . @prefix rdfs: "
          "<http://www.w3.org/2000/01/rdf-schema#> . <https://example.org/r> rdfs:label \"R\" . " +
          statements),
      kRobot);
}

TEST(RobotBodyTest, ScoutStatesEverything) {
  const RobotBody body =
      ReadRobotBody(ViewOf(ReadFile(std::string(LARES_SOURCE_DIR) + "/robots/models/scout.ttl")),
                    "https://w3id.org/lares/robots/scout#scout1");
  EXPECT_EQ(body.footprint_radius_m, 0.29);
  EXPECT_EQ(body.footprint_length_m, 0.42);
  EXPECT_EQ(body.footprint_width_m, 0.38);
  EXPECT_EQ(body.body_height_m, 1.15);
  EXPECT_THAT(body.notes, IsEmpty());
  const Clearance clearance = ClearanceOf(body);
  EXPECT_EQ(clearance.radius_m, 0.29);
  EXPECT_EQ(clearance.high_m, 1.15);
  EXPECT_THAT(clearance.reasons, Contains(HasSubstr("0.29 m, the footprint radius")));
}

TEST(RobotBodyTest, SilenceIsSaidAndAssumed) {
  const RobotBody body = BodyOf("");
  EXPECT_FALSE(body.footprint_radius_m || body.footprint_length_m || body.footprint_width_m ||
               body.body_height_m);
  const Clearance clearance = ClearanceOf(body);
  EXPECT_EQ(clearance.radius_m, 0);
  EXPECT_EQ(clearance.high_m, kAssumedHeight_m);
  EXPECT_THAT(clearance.reasons,
              ElementsAre(HasSubstr("footprint of R is not stated"), HasSubstr("roll over"),
                          HasSubstr("height of R is not stated: 1.8 m")));
}

TEST(RobotBodyTest, RadiusIsHalfTheDiagonalWhenOnlySidesAreStated) {
  const RobotBody body = BodyOf(
      "<https://example.org/r> lares:footprintLength_m 0.8 ; "
      "lares:footprintWidth_m 0.6 .");
  EXPECT_DOUBLE_EQ(ClearanceOf(body).radius_m, 0.5);
}

TEST(RobotBodyTest, ARadiusThatTheSidesDoNotFitIntoGivesWay) {
  const Clearance clearance =
      ClearanceOf(BodyOf("<https://example.org/r> lares:footprintLength_m 0.8 ; "
                         "lares:footprintWidth_m 0.6 ; lares:footprintRadius_m 0.1 ."));
  EXPECT_DOUBLE_EQ(clearance.radius_m, 0.5);
  EXPECT_THAT(clearance.reasons, Contains(HasSubstr("does not fit into the stated radius")));
}

TEST(RobotBodyTest, WhatTheHeightIsAtLeastCutsNoMapLowerThanTheAssumedHeight) {
  const Clearance low = ClearanceOf(BodyOf("<https://example.org/r> lares:minBodyHeight_m 0.3 ."));
  EXPECT_EQ(low.high_m, kAssumedHeight_m);
  EXPECT_THAT(low.reasons, Contains(HasSubstr("at least 0.3 m and may be larger: 1.8 m")));
  const Clearance tall = ClearanceOf(BodyOf("<https://example.org/r> lares:minBodyHeight_m 2.5 ."));
  EXPECT_EQ(tall.high_m, 2.5);
  const Clearance stated = ClearanceOf(
      BodyOf("<https://example.org/r> lares:minBodyHeight_m 0.3 ; lares:bodyHeight_m 1.2 ."));
  EXPECT_EQ(stated.high_m, 1.2);
}

TEST(RobotBodyTest, WhatTheFootprintIsAtLeastIsInflatedByAndSaidToBeMorePerhaps) {
  const Clearance clearance =
      ClearanceOf(BodyOf("<https://example.org/r> lares:minFootprintRadius_m 0.4 ."));
  EXPECT_EQ(clearance.radius_m, 0.4);
  EXPECT_THAT(clearance.reasons, Contains(HasSubstr("is at least: it may be larger")));
  EXPECT_EQ(ClearanceOf(BodyOf("<https://example.org/r> lares:minFootprintRadius_m 0.4 ; "
                               "lares:footprintRadius_m 0.5 ."))
                .radius_m,
            0.5);
}

TEST(RobotBodyTest, OneSideAloneMakesNoRadius) {
  EXPECT_EQ(ClearanceOf(BodyOf("<https://example.org/r> lares:footprintLength_m 0.8 .")).radius_m,
            0);
}

TEST(RobotBodyTest, WhatIsNoLengthIsPassedOverAndNoted) {
  for (const char* value : {"\"tall\"", "0", "-1", "\"NaN\"", "\"INF\"", "1380", "<urn:x>"}) {
    const RobotBody body =
        BodyOf(std::string("<https://example.org/r> lares:bodyHeight_m ") + value + " .");
    EXPECT_FALSE(body.body_height_m) << value;
    EXPECT_THAT(body.notes, ElementsAre(HasSubstr("bodyHeight_m of R"))) << value;
  }
}

TEST(RobotBodyTest, OfSeveralValuesTheLargestCounts) {
  const RobotBody body = BodyOf("<https://example.org/r> lares:footprintRadius_m 0.2 , 0.3 .");
  EXPECT_EQ(body.footprint_radius_m, 0.3);
  EXPECT_THAT(body.notes, ElementsAre(HasSubstr("stated 2 times")));
}

TEST(RobotBodyTest, WhatIsOnlyInferredDoesNotCount) {
  rdf::View view = ViewOf("<https://example.org/r> <https://w3id.org/lares#bodyHeight_m> 1.0 .");
  rdf::Dictionary& dictionary = view.dictionary();
  const rdf::Triple inferred{
      dictionary.InternIri(kRobot),
      dictionary.InternIri("https://w3id.org/lares#footprintRadius_m"),
      dictionary.Intern(
          {rdf::TermKind::kLiteral, "0.5", "http://www.w3.org/2001/XMLSchema#decimal", {}})};
  view = view.With(std::make_shared<const rdf::Layer>(
      std::vector<rdf::Graph>(), std::vector<rdf::Triple>{inferred}, std::vector<rdf::Clash>()));
  const RobotBody body = ReadRobotBody(view, kRobot);
  EXPECT_EQ(body.body_height_m, 1.0);
  EXPECT_FALSE(body.footprint_radius_m);
}

Clearance ClearanceOfUrdf(const std::string& urdf) {
  const urdf::Imported robot = urdf::Import(urdf, "r.urdf");
  urdf::SrdlOptions options;
  options.id = "r";
  return ClearanceOf(
      ReadRobotBody(ViewOf(urdf::ToSrdl(robot.model, robot.kinematics, robot.body, options)),
                    "https://w3id.org/lares/robots/r#r_robot"));
}

// A low plate, and what stands on it with `shape`.
std::string OnAPlate(const std::string& shape) {
  using testing::JointText, testing::LinkText, testing::Origin, testing::Robot, testing::Shape;
  return Robot(LinkText("base_link", Shape("<box size=\"0.4 0.3 0.1\"/>")) +
               LinkText("trunk", Shape(shape)) +
               JointText("j", "fixed", "base_link", "trunk", Origin("0 0 0.2")));
}

TEST(RobotBodyTest, AUrdfOfMeshesCutsTheMapAtTheAssumedHeight) {
  const Clearance mesh = ClearanceOfUrdf(OnAPlate("<mesh filename=\"a.stl\"/>"));
  EXPECT_EQ(mesh.high_m, kAssumedHeight_m);
  EXPECT_THAT(mesh.reasons, Contains(HasSubstr("at least 0.2 m and may be larger")));
  EXPECT_NEAR(mesh.radius_m, 0.25, 1e-9);
  EXPECT_THAT(mesh.reasons, Contains(HasSubstr("is at least: it may be larger")));
  const Clearance box = ClearanceOfUrdf(OnAPlate("<box size=\"0.1 0.1 0.6\"/>"));
  EXPECT_NEAR(box.high_m, 0.5, 1e-9);
  EXPECT_NEAR(box.radius_m, 0.25, 1e-9);
  EXPECT_THAT(box.reasons, Contains(HasSubstr("the footprint radius that")));
}

}  // namespace
}  // namespace lares::robots
