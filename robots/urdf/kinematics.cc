#include "robots/urdf/kinematics.h"

#include <algorithm>

#include "robots/urdf/infer.h"

namespace lares::urdf {

Kinematics MakeKinematics(const Model& model) {
  Kinematics kinematics;
  kinematics.order = LinksBelow(model, model.root);
  kinematics.root_from_link.resize(model.links.size());
  kinematics.body.resize(model.links.size());
  kinematics.moving_on.resize(model.links.size());
  kinematics.moving_below.resize(model.links.size());
  for (const int link : kinematics.order) {
    kinematics.body[At(link)] = link;
    const int above = model.links[At(link)].parent_joint;
    if (above < 0) continue;
    const Joint& joint = model.joints[At(above)];
    kinematics.root_from_link[At(link)] =
        kinematics.root_from_link[At(joint.parent)] * joint.parent_from_child;
    const int carrier = kinematics.body[At(joint.parent)];
    if (Moves(joint)) {
      kinematics.moving_on[At(carrier)].push_back(above);
    } else {
      kinematics.body[At(link)] = carrier;
    }
  }
  for (auto at = kinematics.order.rbegin(); at != kinematics.order.rend(); ++at) {
    const int above = model.links[At(*at)].parent_joint;
    if (above < 0) continue;
    const Joint& joint = model.joints[At(above)];
    kinematics.moving_below[At(joint.parent)] +=
        kinematics.moving_below[At(*at)] + (Moves(joint) ? 1 : 0);
  }
  return kinematics;
}

std::vector<int> JointsTo(const Model& model, int link) {
  std::vector<int> joints;
  for (int above = model.links[At(link)].parent_joint; above >= 0;) {
    joints.push_back(above);
    above = model.links[At(model.joints[At(above)].parent)].parent_joint;
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::vector<int> LinksBelow(const Model& model, int link) {
  std::vector<int> links{link};
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const int joint : model.links[At(links[i])].child_joints) {
      links.push_back(model.joints[At(joint)].child);
    }
  }
  return links;
}

Eigen::Vector3d AxisInRoot(const Model& model, const Kinematics& kinematics, int joint) {
  const Joint& moved = model.joints[At(joint)];
  return kinematics.root_from_link[At(moved.child)].rotation * moved.axis;
}

}  // namespace lares::urdf
