// Where the links of a model are, and how they hang together.
#pragma once

#include <vector>

#include "base/rigid_transform.h"
#include "robots/urdf/model.h"

namespace lares::urdf {

struct Kinematics {
  std::vector<int> order;                      // links, each after the one that carries it
  std::vector<RigidTransform> root_from_link;  // by link, all joints at zero
  std::vector<int> body;                       // by link: the first link of its rigid body
  std::vector<std::vector<int>> moving_on;     // by first link of a body: moving joints on it
  std::vector<int> moving_below;               // by link: how many joints move further out
};

Kinematics MakeKinematics(const Model& model);

// The joints from the root out to `link`, in that order.
std::vector<int> JointsTo(const Model& model, int link);

// `link` and all links below it.
std::vector<int> LinksBelow(const Model& model, int link);

// The joint's axis as seen from the root, all joints at zero; length 1.
Eigen::Vector3d AxisInRoot(const Model& model, const Kinematics& kinematics, int joint);

}  // namespace lares::urdf
