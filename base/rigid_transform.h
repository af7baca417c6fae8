// Rigid motions. A variable of this type names both frames: `world_from_camera`.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace lares {

// target_from_source: p_target = rotation * p_source + translation_m.
struct RigidTransform {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
};

inline Eigen::Vector3d operator*(const RigidTransform& target_from_source,
                                 const Eigen::Vector3d& point_in_source) {
  return target_from_source.rotation * point_in_source + target_from_source.translation_m;
}

// a_from_c = a_from_b * b_from_c.
inline RigidTransform operator*(const RigidTransform& a_from_b, const RigidTransform& b_from_c) {
  return {(a_from_b.rotation * b_from_c.rotation).normalized(),
          a_from_b.rotation * b_from_c.translation_m + a_from_b.translation_m};
}

inline RigidTransform Inverse(const RigidTransform& target_from_source) {
  const Eigen::Quaterniond inverse = target_from_source.rotation.conjugate();
  return {inverse, inverse * -target_from_source.translation_m};
}

// From a homogeneous matrix. Each entry may be off by `tolerance`, as rounding to few digits leaves
// it: the rotation is then the nearest one to the 3×3 block. Throws kInvalid naming what is wrong:
// an entry that is not finite, a last row other than 0 0 0 1, a 3×3 block that is further from
// orthogonal (‖R·Rᵀ − 1‖ above 10 tolerances) or mirrors.
RigidTransform FromMatrix(const Eigen::Matrix4d& target_from_source, double tolerance = 1e-3);

// The rotation about +z (REP-103), in radians, (−π, π].
double YawRad(const RigidTransform& target_from_source);

}  // namespace lares
