// The one door to urdfdom, which reads only what was scanned and written anew.
#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <exception>
#include <map>

#include "base/error.h"
#include "robots/urdf/clean_text.h"
#include "robots/urdf/model.h"
#include "robots/urdf/scan.h"

namespace lares::urdf {
namespace {

::urdf::ModelInterfaceSharedPtr Parse(const std::string& clean, const std::string& source) {
  // It would print what it finds; the scan has said all of it already.
  console_bridge::noOutputHandler();
  std::string reason = "it gives no reason";
  try {
    if (auto parsed = ::urdf::parseURDF(clean)) return parsed;
  } catch (const std::exception& error) {
    reason = error.what();
  }
  throw Error(Code::kInvalid, "urdfdom refuses the robot: " + reason, {source, 0, 0});
}

RigidTransform ToTransform(const ::urdf::Pose& pose) {
  Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  if (rotation.norm() > 0) rotation.normalize();
  return {rotation, {pose.position.x, pose.position.y, pose.position.z}};
}

Shape ToShape(const ::urdf::GeometrySharedPtr& geometry, const ::urdf::Pose& origin,
              const RawShape& raw) {
  Shape shape;
  shape.link_from_shape = ToTransform(origin);
  shape.mesh = raw.mesh;
  if (geometry == nullptr) return shape;
  switch (geometry->type) {
    case ::urdf::Geometry::BOX: {
      const auto& box = static_cast<const ::urdf::Box&>(*geometry);
      shape.kind = Shape::Kind::kBox;
      shape.size_m = {box.dim.x, box.dim.y, box.dim.z};
      break;
    }
    case ::urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const ::urdf::Cylinder&>(*geometry);
      shape.kind = Shape::Kind::kCylinder;
      shape.radius_m = cylinder.radius;
      shape.length_m = cylinder.length;
      break;
    }
    case ::urdf::Geometry::SPHERE:
      shape.kind = Shape::Kind::kSphere;
      shape.radius_m = static_cast<const ::urdf::Sphere&>(*geometry).radius;
      break;
    case ::urdf::Geometry::MESH:
      shape.kind = Shape::Kind::kMesh;
      break;
  }
  return shape;
}

template <typename Parsed>
std::vector<Shape> ToShapes(const Parsed& parsed, const std::vector<RawShape>& raw) {
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < parsed.size() && i < raw.size(); ++i) {
    shapes.push_back(ToShape(parsed[i]->geometry, parsed[i]->origin, raw[i]));
  }
  return shapes;
}

Link ToLink(const ::urdf::Link& parsed, const RawLink& raw) {
  Link link;
  link.name = raw.name;
  link.line = raw.line;
  link.collision = ToShapes(parsed.collision_array, raw.collision);
  link.visual = ToShapes(parsed.visual_array, raw.visual);
  if (parsed.inertial == nullptr || !raw.inertial) return link;
  Inertial inertial;
  inertial.line = raw.inertial->line;
  inertial.mass_kg = parsed.inertial->mass;
  inertial.link_from_inertial = ToTransform(parsed.inertial->origin);
  if (raw.inertial->inertia) {
    const auto& i = *parsed.inertial;
    Eigen::Matrix3d matrix;
    matrix << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    inertial.inertia_kg_m2 = matrix;
  }
  link.inertial = inertial;
  return link;
}

Joint::Kind ToKind(int type) {
  switch (type) {
    case ::urdf::Joint::REVOLUTE:
      return Joint::Kind::kRevolute;
    case ::urdf::Joint::CONTINUOUS:
      return Joint::Kind::kContinuous;
    case ::urdf::Joint::PRISMATIC:
      return Joint::Kind::kPrismatic;
    case ::urdf::Joint::FLOATING:
      return Joint::Kind::kFloating;
    case ::urdf::Joint::PLANAR:
      return Joint::Kind::kPlanar;
    default:
      return Joint::Kind::kFixed;
  }
}

Joint ToJoint(const ::urdf::Joint& parsed, const RawJoint& raw) {
  Joint joint;
  joint.kind = ToKind(parsed.type);
  joint.name = raw.name;
  joint.line = raw.line;
  joint.mimic = raw.mimic;
  joint.parent_from_child = ToTransform(parsed.parent_to_joint_origin_transform);
  const Eigen::Vector3d axis(parsed.axis.x, parsed.axis.y, parsed.axis.z);
  if (axis.stableNorm() > 1e-9) joint.axis = axis.stableNormalized();
  if (raw.limit) {
    // Other joints have no ends, and urdfdom says 0 of what is not written.
    const bool has_ends =
        joint.kind == Joint::Kind::kRevolute || joint.kind == Joint::Kind::kPrismatic;
    if (has_ends && (raw.limit->lower || raw.limit->upper)) {
      joint.lower = raw.limit->lower.value_or(0);
      joint.upper = raw.limit->upper.value_or(0);
    }
    joint.effort = raw.limit->effort;
    joint.velocity = raw.limit->velocity;
  }
  return joint;
}

void Connect(const RawRobot& raw, Model& model) {
  std::map<std::string_view, int> links, joints;
  for (const Link& link : model.links) links.emplace(link.name, static_cast<int>(links.size()));
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    Joint& joint = model.joints[i];
    joints.emplace(joint.name, static_cast<int>(i));
    joint.parent = links.at(raw.joints[i].parent);
    joint.child = links.at(raw.joints[i].child);
    joint.actuated = std::binary_search(raw.actuated.begin(), raw.actuated.end(), joint.name);
    model.says_what_is_driven = model.says_what_is_driven || joint.actuated;
    model.links[static_cast<std::size_t>(joint.parent)].child_joints.push_back(static_cast<int>(i));
    model.links[static_cast<std::size_t>(joint.child)].parent_joint = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].parent_joint < 0) model.root = static_cast<int>(i);
  }
  for (const RawSensor& sensor : raw.sensors) {
    int link = -1;
    if (const auto found = links.find(sensor.link); found != links.end()) link = found->second;
    if (const auto joint = joints.find(sensor.link); link < 0 && joint != joints.end()) {
      link = model.joints[static_cast<std::size_t>(joint->second)].child;
    }
    if (link < 0) continue;
    model.sensors.push_back(sensor.sensor);
    model.sensors.back().link = link;
  }
}

}  // namespace

std::string_view ToString(Joint::Kind kind) {
  constexpr std::string_view kNames[] = {"fixed",     "revolute", "continuous",
                                         "prismatic", "floating", "planar"};
  return kNames[static_cast<std::size_t>(kind)];
}

int Model::FindLink(std::string_view link) const {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].name == link) return static_cast<int>(i);
  }
  return -1;
}

Model ReadUrdf(std::string_view bytes, const std::string& source, const Limits& limits) {
  Scanned scanned = Scan(bytes, source, limits);
  if (HasErrors(scanned.findings)) throw ToError(scanned.findings);
  const RawRobot& raw = scanned.robot;
  const auto parsed = Parse(CleanText(raw), source);
  if (parsed->links_.size() != raw.links.size() || parsed->joints_.size() != raw.joints.size()) {
    throw Error(Code::kInternal, "urdfdom read another number of links or joints than there are");
  }
  Model model;
  model.name = raw.name;
  model.findings = std::move(scanned.findings);
  model.plugins = raw.plugins;
  for (std::size_t i = 0; i < raw.links.size(); ++i) {
    model.links.push_back(ToLink(*parsed->links_.at("l" + std::to_string(i)), raw.links[i]));
  }
  for (std::size_t i = 0; i < raw.joints.size(); ++i) {
    model.joints.push_back(ToJoint(*parsed->joints_.at("j" + std::to_string(i)), raw.joints[i]));
  }
  Connect(raw, model);
  return model;
}

}  // namespace lares::urdf
