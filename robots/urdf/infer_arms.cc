#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/text.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/quote.h"

namespace lares::urdf {
namespace {

constexpr std::size_t kFewestArmJoints = 3;

bool IsFingerName(std::string_view name) {
  static const std::vector<std::string> kWords = {"finger",  "fingers", "thumb",  "jaw",  "claw",
                                                  "knuckle", "index",   "middle", "ring", "pinky"};
  return HasWord(name, kWords) || ToLower(name).find("finger") != std::string::npos;
}

// Few joints outside it, and named so; or two of a kind where a gripper is named.
bool IsFingerJoint(const Model& model, const Kinematics& kinematics, const Joint& joint) {
  if (joint.kind != Joint::Kind::kRevolute && joint.kind != Joint::Kind::kPrismatic) return false;
  if (kinematics.moving_below[At(joint.child)] > 3) return false;
  const std::string& link = model.links[At(joint.child)].name;
  if (IsFingerName(joint.name) || IsFingerName(link)) return true;
  const bool in_gripper =
      HasWord(link, {"gripper", "hand"}) || HasWord(joint.name, {"gripper", "hand"});
  const bool sided = HasWord(link, {"left", "right", "l", "r"});
  const auto& siblings = model.links[At(joint.parent)].child_joints;
  const auto alike = std::count_if(siblings.begin(), siblings.end(), [&](int other) {
    return model.joints[At(other)].kind == joint.kind;
  });
  return in_gripper && sided && alike >= 2;
}

std::string SideOf(const Model& model, int link) {
  const std::string& name = model.links[At(link)].name;
  if (HasWord(name, {"left", "l"})) return "left";
  if (HasWord(name, {"right", "r"})) return "right";
  return "";
}

// From the hand inwards, until the body carries something else that moves as well.
std::vector<int> ChainUp(const Model& model, const Kinematics& kinematics, int link,
                         const Base& base) {
  std::vector<int> joints;
  const std::vector<int> all = JointsTo(model, link);
  for (auto at = all.rbegin(); at != all.rend(); ++at) {
    const Joint& joint = model.joints[At(*at)];
    if (!Moves(joint)) continue;
    joints.insert(joints.begin(), *at);
    const int carrier = kinematics.body[At(joint.parent)];
    if (carrier == kinematics.body[At(base.link)]) break;
    // A second, passive joint at the elbow does not end the arm; a second limb does.
    const std::vector<int>& others = kinematics.moving_on[At(carrier)];
    const bool branches = std::any_of(others.begin(), others.end(), [&](int other) {
      return other != *at && model.joints[At(other)].mimic.empty();
    });
    if (branches) break;
  }
  return joints;
}

double ReachOf(const Model& model, const Kinematics& kinematics, const Arm& arm) {
  double reach = 0;
  Eigen::Vector3d from =
      kinematics.root_from_link[At(model.joints[At(arm.joints.front())].child)].translation_m;
  for (const int joint : arm.joints) {
    const Joint& moved = model.joints[At(joint)];
    const Eigen::Vector3d to = kinematics.root_from_link[At(moved.child)].translation_m;
    reach += (to - from).norm();
    if (moved.kind == Joint::Kind::kPrismatic) reach += moved.upper.value_or(0);
    from = to;
  }
  return reach + (kinematics.root_from_link[At(arm.end_link)].translation_m - from).norm();
}

std::optional<Arm> ArmTo(const Model& model, const Kinematics& kinematics, int end_link,
                         const Base& base) {
  Arm arm;
  arm.joints = ChainUp(model, kinematics, end_link, base);
  // What lifts the whole upper body is a torso, though nothing else hangs on it.
  if (arm.joints.size() > kFewestArmJoints &&
      HasWord(model.joints[At(arm.joints.front())].name, {"torso"})) {
    arm.joints.erase(arm.joints.begin());
  }
  if (arm.joints.size() < kFewestArmJoints) return std::nullopt;
  arm.base_link = model.joints[At(arm.joints.front())].child;
  arm.end_link = end_link;
  arm.side = SideOf(model, end_link);
  arm.reach_m = ReachOf(model, kinematics, arm);
  arm.reason = "a chain of " + std::to_string(arm.joints.size()) + " joints from " +
               Quote(model.joints[At(arm.joints.front())].name) + " to " +
               Quote(model.links[At(end_link)].name);
  return arm;
}

// Chains that end without fingers, where names say that they are arms.
void AddHandlessArms(const Model& model, const Kinematics& kinematics, const Base& base,
                     std::vector<Arm>& arms) {
  std::set<int> taken;
  for (const Arm& arm : arms) taken.insert(arm.joints.begin(), arm.joints.end());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.kind != Joint::Kind::kRevolute && joint.kind != Joint::Kind::kContinuous) continue;
    if (taken.contains(static_cast<int>(i)) || kinematics.moving_below[At(joint.child)] > 0)
      continue;
    auto arm = ArmTo(model, kinematics, joint.child, base);
    if (!arm || arm->joints.size() < 4) continue;
    const bool is_free = std::none_of(arm->joints.begin(), arm->joints.end(),
                                      [&](int other) { return taken.contains(other); });
    const bool is_named = std::any_of(arm->joints.begin(), arm->joints.end(), [&](int other) {
      return HasWord(model.joints[At(other)].name,
                     {"arm", "shoulder", "elbow", "wrist", "forearm", "manipulator"});
    });
    if (!is_free || !(is_named || base.kind == BaseKind::kFixed)) continue;
    taken.insert(arm->joints.begin(), arm->joints.end());
    arm->reason += "; no fingers were found at its end";
    arms.push_back(std::move(*arm));
  }
}

}  // namespace

std::vector<Gripper> InferGrippers(const Model& model, const Kinematics& kinematics) {
  std::map<int, std::vector<int>> fingers_of;  // by the palm's rigid body
  std::vector<bool> is_finger;
  for (const Joint& joint : model.joints) {
    is_finger.push_back(IsFingerJoint(model, kinematics, joint));
  }
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (!is_finger[i]) continue;
    // The outermost segments of a finger belong to the finger.
    const std::vector<int> above = JointsTo(model, joint.parent);
    const bool is_segment =
        std::any_of(above.begin(), above.end(), [&](int other) { return is_finger[At(other)]; });
    if (!is_segment) fingers_of[kinematics.body[At(joint.parent)]].push_back(static_cast<int>(i));
  }
  std::vector<Gripper> grippers;
  for (const auto& [body, joints] : fingers_of) {
    Gripper gripper;
    gripper.palm = model.joints[At(joints.front())].parent;
    std::vector<std::string> names;
    for (const int joint : joints) {
      gripper.fingers.push_back(model.joints[At(joint)].child);
      names.push_back(Quote(model.joints[At(joint)].name));
    }
    if (joints.size() < 2 && kinematics.moving_below[At(gripper.palm)] < 2) continue;
    gripper.side = SideOf(model, gripper.palm);
    gripper.reason = std::string(joints.size() > 1 ? "the finger joints " : "the finger joint ") +
                     Join(names, ", ") + " at " + Quote(model.links[At(gripper.palm)].name);
    grippers.push_back(std::move(gripper));
  }
  return grippers;
}

std::vector<Arm> InferArms(const Model& model, const Kinematics& kinematics,
                           std::vector<Gripper>& grippers, const Base& base) {
  std::vector<Arm> arms;
  for (std::size_t i = 0; i < grippers.size(); ++i) {
    auto arm = ArmTo(model, kinematics, grippers[i].palm, base);
    if (!arm) continue;
    arm->gripper = static_cast<int>(i);
    arms.push_back(std::move(*arm));
  }
  AddHandlessArms(model, kinematics, base, arms);
  return arms;
}

}  // namespace lares::urdf
