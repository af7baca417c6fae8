#include "mapping/semantic/spatial_relations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace lares::semantic {
namespace {

MapObject Thing(const std::string& iri, const Eigen::Vector3d& middle_m,
                const Eigen::Vector3d& extent_m, double yaw_rad = 0) {
  MapObject object;
  object.iri = iri;
  object.map_from_object = RigidTransform{};
  object.map_from_object->translation_m = middle_m;
  object.map_from_object->rotation =
      Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * Eigen::Quaterniond::Identity();
  object.extent_m = extent_m;
  return object;
}

const MapObject kTable = Thing("table", {0, 0, 0.4}, {2, 1, 0.8});

std::vector<SpatialRelation> Relations(const std::vector<MapObject>& objects) {
  return FindSpatialRelations(objects).relations;
}

TEST(SpatialRelationsTest, ACupOnATableIsOnItAndNotTheOtherWayRound) {
  const std::vector<SpatialRelation> expected = {{SpatialRelation::Kind::kOn, "cup", "table"}};
  EXPECT_EQ(Relations({kTable, Thing("cup", {0.9, 0.4, 0.85}, {0.1, 0.1, 0.1})}), expected);
  EXPECT_EQ(Relations({kTable, Thing("cup", {0.9, 0.4, 0.87}, {0.1, 0.1, 0.1})}), expected)
      << "two centimetres are noise";
}

TEST(SpatialRelationsTest, WhatHangsAboveOrStandsBesideIsNotOn) {
  EXPECT_TRUE(Relations({kTable, Thing("lamp", {0, 0, 1.5}, {0.1, 0.1, 0.1})}).empty());
  EXPECT_TRUE(Relations({kTable, Thing("cup", {1.2, 0, 0.85}, {0.1, 0.1, 0.1})}).empty());
  EXPECT_TRUE(Relations({kTable, Thing("cup", {0, 0.7, 0.85}, {0.1, 0.1, 0.1})}).empty());
}

TEST(SpatialRelationsTest, ATurnedTableIsWhereItIsTurnedTo) {
  const MapObject cup = Thing("cup", {0, 0.9, 0.85}, {0.1, 0.1, 0.1});
  EXPECT_TRUE(Relations({kTable, cup}).empty());
  EXPECT_EQ(Relations({Thing("table", {0, 0, 0.4}, {2, 1, 0.8}, M_PI / 2), cup}).size(), 1U);
}

TEST(SpatialRelationsTest, ABottleInACupboardIsInItAndTheCupboardIsNotInTheBottle) {
  const std::vector<SpatialRelation> expected = {
      {SpatialRelation::Kind::kIn, "bottle", "cupboard"}};
  EXPECT_EQ(Relations({Thing("bottle", {0, 0, 1}, {0.1, 0.1, 0.3}),
                       Thing("cupboard", {0, 0, 1}, {0.4, 0.8, 2})}),
            expected);
  EXPECT_TRUE(Relations({Thing("bottle", {0.25, 0, 1}, {0.1, 0.1, 0.3}),
                         Thing("cupboard", {0, 0, 1}, {0.4, 0.8, 2})})
                  .empty());
}

TEST(SpatialRelationsTest, TwoBoxesThatAreEqualAreNotInOneAnother) {
  EXPECT_TRUE(
      Relations({Thing("a", {0, 0, 1}, {1, 1, 1}), Thing("b", {0, 0, 1}, {1, 1, 1})}).empty());
}

TEST(SpatialRelationsTest, WithoutPoseOrExtentThereIsNoRelation) {
  MapObject nowhere = kTable;
  nowhere.map_from_object.reset();
  MapObject point = kTable;
  point.extent_m.reset();
  EXPECT_TRUE(Relations({nowhere, point, Thing("cup", {0, 0, 0.85}, {0.1, 0.1, 0.1})}).empty());
  EXPECT_TRUE(Relations({}).empty());
}

TEST(SpatialRelationsTest, BeyondALimitNothingIsSaidRatherThanSomeOfIt) {
  RelationOptions options;
  options.max_pairs = 3;
  const RelationsFound found = FindSpatialRelations(
      {kTable, kTable, kTable, Thing("cup", {0, 0, 0.85}, {0.1, 0.1, 0.1})}, options);
  EXPECT_FALSE(found.complete);
  EXPECT_TRUE(found.relations.empty());
}

TEST(SpatialRelationsTest, AToleranceThatIsNoneIsRefusedByName) {
  RelationOptions options;
  options.touch_m = std::nan("");
  EXPECT_THROW(FindSpatialRelations({}, options), Error);
}

}  // namespace
}  // namespace lares::semantic
