// A robot as its URDF describes it: one tree of links and joints, and what senses on it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/rigid_transform.h"
#include "robots/urdf/finding.h"
#include "robots/urdf/limits.h"
#include "robots/urdf/sensor.h"

namespace lares::urdf {

struct Shape {
  enum class Kind { kBox, kCylinder, kSphere, kMesh };
  Kind kind = Kind::kBox;
  RigidTransform link_from_shape;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // of a box
  double radius_m = 0;
  double length_m = 0;  // of a cylinder, along its z
  std::string mesh;     // the path as written; never opened
};

struct Inertial {
  RigidTransform link_from_inertial;
  double mass_kg = 0;
  std::optional<Eigen::Matrix3d> inertia_kg_m2;  // about the centre of mass; absent if not written
  int line = 0;
};

struct Link {
  std::string name;
  int line = 0;
  std::optional<Inertial> inertial;
  std::vector<Shape> collision, visual;
  int parent_joint = -1;          // of Model::joints; -1 for the root
  std::vector<int> child_joints;  // in the document's order
};

struct Joint {
  enum class Kind { kFixed, kRevolute, kContinuous, kPrismatic, kFloating, kPlanar };
  Kind kind = Kind::kFixed;
  std::string name;
  int line = 0;
  int parent = -1, child = -1;                      // of Model::links
  RigidTransform parent_from_child;                 // with the joint at zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // in the child's frame; length 1
  std::optional<double> lower, upper;      // radians or metres; of revolute and prismatic ones
  std::optional<double> effort, velocity;  // N m or N; rad/s or m/s
  std::string mimic;                       // the joint that it follows; may be empty
  bool actuated = false;                   // a transmission or ros2_control drives it
};
std::string_view ToString(Joint::Kind kind);  // "fixed", "revolute", …
inline bool Moves(const Joint& joint) { return joint.kind != Joint::Kind::kFixed; }
// Revolute or continuous.
inline bool Turns(const Joint& joint) {
  return joint.kind == Joint::Kind::kRevolute || joint.kind == Joint::Kind::kContinuous;
}

struct Model {
  std::string name;
  std::vector<Link> links;    // in the document's order
  std::vector<Joint> joints;  // likewise
  int root = -1;              // of links
  std::vector<Sensor> sensors;
  std::vector<Plugin> plugins;
  bool says_what_is_driven = false;  // there are transmissions or ros2_control
  std::vector<Finding> findings;     // warnings and notes of reading

  int FindLink(std::string_view link) const;  // -1 when there is none
};

// Reads all of it. Throws kInvalid (the first fault with its line, element and attribute; hint),
// kTooLarge (the limit by name), kUnsupported. `source` names the text in places. Nothing else is
// opened; nothing is printed. Thread-safe.
Model ReadUrdf(std::string_view bytes, const std::string& source, const Limits& limits = {});

}  // namespace lares::urdf
