#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/quote.h"

namespace lares::urdf {
namespace {

using Kind = Sensor::Kind;

constexpr double kVertical = 0.7;

// A camera's body frame where an optical frame hangs on it; -1 when the link is none.
int CarrierOfOptical(const Model& model, int link) {
  const std::string name = ToLower(model.links[At(link)].name);
  if (name.find("optical") == std::string::npos) return -1;
  const int above = model.links[At(link)].parent_joint;
  if (above < 0 || Moves(model.joints[At(above)])) return -1;
  return model.joints[At(above)].parent;
}

std::optional<Sensor> NamedCamera(const Model& model, int optical) {
  const int link = CarrierOfOptical(model, optical);
  if (link < 0) return std::nullopt;
  Sensor sensor;
  sensor.name = model.links[At(link)].name;
  sensor.frame = model.links[At(optical)].name;
  sensor.link = link;
  sensor.line = model.links[At(optical)].line;
  const std::string& name = sensor.frame;
  const bool depth = HasWord(name, {"depth", "ir", "infra", "infra1", "infra2", "tof"});
  const bool rgbd = HasWord(name, {"rgbd", "kinect", "xtion"}) && !depth;
  sensor.kind = depth ? Kind::kDepthCamera : rgbd ? Kind::kRgbdCamera : Kind::kCamera;
  sensor.reason = "the frame " + Quote(name) +
                  " is named as a camera's; the URDF tells neither "
                  "range nor field of view";
  return sensor;
}

std::optional<Sensor> NamedOther(const Model& model, int link) {
  const std::string& name = model.links[At(link)].name;
  if (!model.links[At(link)].child_joints.empty()) return std::nullopt;
  Sensor sensor;
  sensor.name = name;
  sensor.frame = name;
  sensor.link = link;
  sensor.line = model.links[At(link)].line;
  if (HasWord(name, {"laser", "lidar", "hokuyo", "rplidar", "sick", "lms", "scanner"})) {
    sensor.kind = Kind::kLaser2d;
  } else if (HasWord(name, {"imu"})) {
    sensor.kind = Kind::kInertial;
  } else if (HasWord(name, {"sonar", "ultrasound"})) {
    sensor.kind = Kind::kSonar;
  } else if (HasWord(name, {"bumper"})) {
    sensor.kind = Kind::kBumper;
  } else {
    return std::nullopt;
  }
  sensor.reason = "the link " + Quote(name) + " is named so; the URDF tells no range";
  return sensor;
}

// Where the simulator knows a sensor of this sort on the same rigid body, names add nothing.
bool IsKnown(const Model& model, const Kinematics& kinematics, const Sensor& named) {
  return std::any_of(model.sensors.begin(), model.sensors.end(), [&](const Sensor& known) {
    const bool same_sort = known.kind == named.kind ||
                           (IsCamera(known.kind) && IsCamera(named.kind)) ||
                           (IsLaser(known.kind) && IsLaser(named.kind));
    return same_sort && kinematics.body[At(known.link)] == kinematics.body[At(named.link)];
  });
}

bool IsInArm(const Body& body, int joint) {
  return std::any_of(body.arms.begin(), body.arms.end(), [&](const Arm& arm) {
    return std::find(arm.joints.begin(), arm.joints.end(), joint) != arm.joints.end();
  });
}

}  // namespace

std::vector<BodySensor> InferSensors(const Model& model, const Kinematics& kinematics,
                                     int base_frame) {
  std::vector<Sensor> sensors = model.sensors;
  std::set<std::pair<int, Kind>> seen;
  for (const int link : kinematics.order) {
    for (auto& named : {NamedCamera(model, link), NamedOther(model, link)}) {
      if (!named || IsKnown(model, kinematics, *named)) continue;
      if (seen.emplace(named->link, named->kind).second) sensors.push_back(*named);
    }
  }
  std::vector<BodySensor> placed;
  const RigidTransform base_from_root = Inverse(kinematics.root_from_link[At(base_frame)]);
  for (Sensor& sensor : sensors) {
    const RigidTransform base_from_sensor =
        base_from_root * kinematics.root_from_link[At(sensor.link)] * sensor.link_from_sensor;
    placed.push_back({std::move(sensor), base_from_sensor});
  }
  return placed;
}

// The joints outside the arms that turn a camera.
std::vector<Head> InferHeads(const Model& model, const Kinematics& kinematics, const Body& body) {
  std::vector<Head> heads;
  for (const BodySensor& sensor : body.sensors) {
    if (!IsCamera(sensor.sensor.kind)) continue;
    Head head;
    bool in_arm = false;
    for (const int joint : JointsTo(model, sensor.sensor.link)) {
      in_arm = in_arm || IsInArm(body, joint);
      if (!Turns(model.joints[At(joint)])) continue;
      const bool upright = std::abs(AxisInRoot(model, kinematics, joint).z()) > kVertical;
      int& part = upright ? head.pan : head.tilt;
      if (part < 0) part = joint;
      if (head.link < 0) head.link = model.joints[At(joint)].child;
    }
    if (in_arm || head.link < 0) continue;
    const bool is_known = std::any_of(heads.begin(), heads.end(),
                                      [&](const Head& known) { return known.link == head.link; });
    if (is_known) continue;
    const auto part = [&](int joint, const char* does) {
      return joint < 0 ? std::string() : Quote(model.joints[At(joint)].name) + " " + does;
    };
    const std::string pan = part(head.pan, "turns sideways");
    const std::string tilt = part(head.tilt, "nods");
    head.reason = "the camera " + Quote(sensor.sensor.name) + " sits on joints: " + pan +
                  (pan.empty() || tilt.empty() ? "" : ", ") + tilt;
    heads.push_back(std::move(head));
  }
  return heads;
}

// Joints that slide upwards and carry an arm or a head, without being part of an arm.
std::vector<Torso> InferTorsos(const Model& model, const Kinematics& kinematics, const Body& body) {
  std::vector<Torso> torsos;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    const int index = static_cast<int>(i);
    if (joint.kind != Joint::Kind::kPrismatic || IsInArm(body, index)) continue;
    if (std::abs(AxisInRoot(model, kinematics, index).z()) < kVertical) continue;
    const std::vector<int> below = LinksBelow(model, joint.child);
    const auto carries = [&](int link) {
      return std::find(below.begin(), below.end(), link) != below.end();
    };
    const bool arm = std::any_of(body.arms.begin(), body.arms.end(),
                                 [&](const Arm& each) { return carries(each.base_link); });
    const bool head = std::any_of(body.heads.begin(), body.heads.end(),
                                  [&](const Head& each) { return carries(each.link); });
    if (!arm && !head) continue;
    torsos.push_back({index, joint.child,
                      "the joint " + Quote(joint.name) + " slides upwards and carries " +
                          (arm ? "an arm" : "a head")});
  }
  return torsos;
}

}  // namespace lares::urdf
