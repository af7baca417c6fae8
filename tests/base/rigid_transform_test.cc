#include "base/rigid_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"

namespace lares {
namespace {

RigidTransform QuarterTurn() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ())), {1, 2, 3}};
}

TEST(RigidTransformTest, QuarterTurnAboutZTakesXToY) {
  const Eigen::Vector3d moved = QuarterTurn() * Eigen::Vector3d(1, 0, 0);
  EXPECT_TRUE(moved.isApprox(Eigen::Vector3d(1, 3, 3), 1e-12));
  EXPECT_NEAR(YawRad(QuarterTurn()), M_PI / 2, 1e-12);
}

TEST(RigidTransformTest, InverseUndoes) {
  const Eigen::Vector3d point(0.3, -2, 5);
  EXPECT_TRUE((Inverse(QuarterTurn()) * (QuarterTurn() * point)).isApprox(point, 1e-12));
  EXPECT_TRUE((QuarterTurn() * Inverse(QuarterTurn())).translation_m.isZero(1e-12));
}

TEST(RigidTransformTest, MatrixRoundTrips) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = QuarterTurn().rotation.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = QuarterTurn().translation_m;
  const RigidTransform read = FromMatrix(matrix);
  EXPECT_TRUE((read * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, 3, 3), 1e-12));
}

TEST(RigidTransformTest, RoundedMatrixGivesTheNearestRotation) {
  const Eigen::Matrix3d exact = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(-1.1, Eigen::Vector3d(1, 2, 2) / 3))
                                    .toRotationMatrix();
  Eigen::Matrix4d rounded = Eigen::Matrix4d::Identity();
  rounded.topLeftCorner<3, 3>() = (exact * 100).array().round() / 100;
  EXPECT_THROW(FromMatrix(rounded, 1e-4), Error);
  const RigidTransform read = FromMatrix(rounded, 5e-3);
  EXPECT_NEAR(read.rotation.norm(), 1, 1e-12);
  EXPECT_TRUE(read.rotation.toRotationMatrix().isApprox(exact, 1e-2));
}

TEST(RigidTransformTest, NanIsRefusedByTheNameOfItsEntry) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(1, 3) = std::numeric_limits<double>::quiet_NaN();
  try {
    FromMatrix(matrix);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("m13"), std::string::npos);
  }
}

TEST(RigidTransformTest, ReflectionAndScaleAreNoRotation) {
  Eigen::Matrix4d mirrored = Eigen::Matrix4d::Identity();
  mirrored(2, 2) = -1;
  EXPECT_THROW(FromMatrix(mirrored), Error);
  Eigen::Matrix4d scaled = Eigen::Matrix4d::Identity() * 2;
  scaled(3, 3) = 1;
  EXPECT_THROW(FromMatrix(scaled), Error);
}

}  // namespace
}  // namespace lares
