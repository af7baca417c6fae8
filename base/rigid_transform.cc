#include "base/rigid_transform.h"

#include <Eigen/SVD>
#include <cmath>
#include <string>

#include "base/error.h"

namespace lares {
namespace {

// In the Frobenius norm (Schönemann, Psychometrika 1966). `near` must be close to a rotation.
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& near) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(near, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

}  // namespace

RigidTransform FromMatrix(const Eigen::Matrix4d& target_from_source, double tolerance) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!std::isfinite(target_from_source(row, column))) {
        throw Error(Code::kInvalid, "entry m" + std::to_string(row) + std::to_string(column) +
                                        " of the pose matrix is not a finite number");
      }
    }
  }
  const Eigen::RowVector4d last_row(0, 0, 0, 1);
  if ((target_from_source.row(3) - last_row).norm() > tolerance) {
    throw Error(Code::kInvalid, "the last row of the pose matrix is not 0 0 0 1");
  }
  const Eigen::Matrix3d rotation = target_from_source.topLeftCorner<3, 3>();
  const double departure = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(departure <= tolerance * 10)) {
    throw Error(Code::kInvalid, "the upper left 3×3 block of the pose matrix is no rotation");
  }
  if (rotation.determinant() < 0) {
    throw Error(Code::kInvalid, "the upper left 3×3 block of the pose matrix mirrors");
  }
  return {Eigen::Quaterniond(NearestRotation(rotation)), target_from_source.topRightCorner<3, 1>()};
}

double YawRad(const RigidTransform& target_from_source) {
  const Eigen::Matrix3d r = target_from_source.rotation.toRotationMatrix();
  return std::atan2(r(1, 0), r(0, 0));
}

}  // namespace lares
