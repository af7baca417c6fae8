#include "mapping/semantic/object_diff.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lares::semantic {
namespace {

MapObject Object(const std::string& iri, const std::string& kind, double x_m,
                 double yaw_rad = 0.3) {
  MapObject object;
  object.iri = iri;
  object.class_iri = kind;
  RigidTransform pose;
  pose.translation_m = {x_m, 2, 0.5};
  pose.rotation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d(0.1, 0.2, 1).normalized());
  object.map_from_object = pose;
  return object;
}

TEST(ObjectDiffTest, NewGoneMovedReclassedAreToldApart) {
  const ObjectDiff diff = DiffObjects(
      {Object("a", "Cup", 1), Object("b", "Bed", 2), Object("c", "Box", 3), Object("d", "Cup", 4)},
      {Object("a", "Cup", 1.005), Object("b", "Bed", 2.5), Object("c", "Cup", 3),
       Object("e", "Lamp", 9)});
  EXPECT_EQ(diff.same, 1u);
  ASSERT_EQ(diff.moved.size(), 1u);
  EXPECT_NEAR(diff.moved[0].distance_m, 0.5, 1e-12);
  ASSERT_EQ(diff.reclassed.size(), 1u);
  EXPECT_EQ(diff.reclassed[0].before.class_iri, "Box");
  ASSERT_EQ(diff.added.size(), 1u);
  EXPECT_EQ(diff.added[0].iri, "e");
  ASSERT_EQ(diff.gone.size(), 1u);
  EXPECT_EQ(diff.gone[0].iri, "d");
}

TEST(ObjectDiffTest, TurningIsMoving) {
  const ObjectDiff diff = DiffObjects({Object("a", "Cup", 1, 0.3)}, {Object("a", "Cup", 1, 0.8)});
  ASSERT_EQ(diff.moved.size(), 1u);
  EXPECT_NEAR(diff.moved[0].angle_rad, 0.5, 1e-9);
  EXPECT_EQ(diff.moved[0].distance_m, 0);
}

TEST(ObjectDiffTest, PoseThatComesOrGoesIsAMoveOfNoLength) {
  MapObject nowhere = Object("a", "Cup", 1);
  nowhere.map_from_object.reset();
  const ObjectDiff diff = DiffObjects({Object("a", "Cup", 1)}, {nowhere});
  ASSERT_EQ(diff.moved.size(), 1u);
  EXPECT_TRUE(std::isnan(diff.moved[0].distance_m));
  EXPECT_TRUE(DiffObjects({nowhere}, {nowhere}).moved.empty());
}

TEST(ObjectDiffTest, NearestOfOneClassUnderAnotherNameIsLikelyTheSame) {
  const ObjectDiff diff =
      DiffObjects({Object("a", "Cup", 1), Object("b", "Cup", 5), Object("c", "Bed", 1)},
                  {Object("x", "Cup", 1.2), Object("y", "Cup", 1.1), Object("z", "Box", 1)});
  ASSERT_EQ(diff.renamed.size(), 1u);
  EXPECT_EQ(diff.renamed[0].before.iri, "a");
  EXPECT_EQ(diff.renamed[0].after.iri, "y");
  EXPECT_EQ(diff.added.size(), 2u);
  EXPECT_EQ(diff.gone.size(), 2u);
}

}  // namespace
}  // namespace lares::semantic
