// What a robot is made of, concluded from its URDF, each conclusion with its reason.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/urdf/kinematics.h"
#include "robots/urdf/model.h"

namespace lares::urdf {

// kWheeled: on wheels that neither drive by their difference nor go sideways, as a car's.
enum class BaseKind { kUnknown, kFixed, kDifferential, kHolonomic, kTracked, kWheeled };
std::string_view ToString(BaseKind kind);  // "differential", …

struct Base {
  BaseKind kind = BaseKind::kUnknown;
  int link = -1;            // that carries the wheels or tracks; the root where there are none
  std::vector<int> wheels;  // links
  std::string reason;
};

// On the floor, seen from the base frame.
struct Footprint {
  std::vector<Eigen::Vector2d> polygon_m;  // convex, counter-clockwise; empty when not known
  double length_m = 0;                     // front to back
  double width_m = 0;                      // left to right
  double radius_m = 0;                     // about the base frame's origin
  bool is_lower_bound = false;             // the true one holds it and may be larger
  std::string reason;
};

struct BodyHeight {
  double height_m = 0;          // above the floor
  bool is_lower_bound = false;  // the true one may be larger
  std::string reason;
};

struct Gripper {
  int palm = -1;
  std::vector<int> fingers;  // links, one for each finger joint
  std::string side;          // "left", "right" or ""
  std::string reason;
};

struct Arm {
  std::vector<int> joints;  // that move, from the shoulder outwards
  int base_link = -1;       // the first link that moves with the arm
  int end_link = -1;        // the palm, or the last link where there is no gripper
  int gripper = -1;         // of Body::grippers
  double reach_m = 0;       // sum of the distances between the joints, up to the end link
  std::string side;
  std::string reason;
};

struct Head {
  int pan = -1, tilt = -1;  // joints; -1 when there is none
  int link = -1;            // that the first of them moves
  std::string reason;
};

struct Torso {
  int joint = -1;  // slides upwards
  int link = -1;
  std::string reason;
};

struct BodySensor {
  Sensor sensor;
  RigidTransform base_from_sensor;  // joints at zero
};

struct Body {
  int base_frame = -1;  // link that poses are seen from
  double floor_m = 0;   // height of the floor in the base frame
  double mass_kg = 0;   // of all links; 0 when none has a mass
  Base base;
  std::optional<Footprint> footprint;
  std::optional<BodyHeight> height;
  std::vector<Arm> arms;
  std::vector<Gripper> grippers;
  std::vector<Head> heads;
  std::vector<Torso> torsos;
  std::vector<BodySensor> sensors;  // the simulator's, or where it has none those that names tell
  std::vector<std::string> notes;   // what could not be concluded, and why
};

// `base_frame` names the link that poses are seen from; empty for base_footprint, base_link or the
// root, whichever there is first. Throws kNotFound, with similar names, when there is no such link.
Body InferBody(const Model& model, const Kinematics& kinematics,
               const std::string& base_frame = "");

}  // namespace lares::urdf
