// A URDF as it is written: numbers checked, nothing interpreted.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "robots/urdf/sensor.h"

namespace lares::urdf {

// <origin>: radians about the fixed axes x, y, z.
struct RawPose {
  std::array<double, 3> xyz_m{};
  std::array<double, 3> rpy_rad{};
};

struct RawShape {
  enum class Kind { kBox, kCylinder, kSphere, kMesh };
  Kind kind = Kind::kBox;
  RawPose origin;
  std::array<double, 3> size{1, 1, 1};  // of a box in metres; a mesh's scale
  double radius_m = 0;
  double length_m = 0;
  std::string mesh;  // as written; never opened
  int line = 0;
};

struct RawInertial {
  RawPose origin;
  double mass_kg = 0;
  std::optional<std::array<double, 6>> inertia;  // ixx ixy ixz iyy iyz izz, kg m²
  int line = 0;
};

struct RawLink {
  std::string name;
  int line = 0;
  std::optional<RawInertial> inertial;
  std::vector<RawShape> collision, visual;
};

struct RawLimit {
  std::optional<double> lower, upper, effort, velocity;
  int line = 0;
};

struct RawJoint {
  std::string name;
  std::string type;  // one of URDF's six
  std::string parent, child;
  RawPose origin;
  std::optional<std::array<double, 3>> axis;
  std::optional<RawLimit> limit;
  std::string mimic;  // the joint that it follows; may be empty
  int line = 0;
};

// A sensor whose link is not looked up yet.
struct RawSensor {
  std::string link;
  Sensor sensor;
};

struct RawRobot {
  std::string name;
  std::vector<RawLink> links;
  std::vector<RawJoint> joints;
  std::vector<RawSensor> sensors;
  std::vector<Plugin> plugins;
  std::vector<std::string> actuated;  // joints that a transmission or ros2_control drives
};

}  // namespace lares::urdf
