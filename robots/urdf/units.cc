#include "robots/urdf/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lares::urdf {
namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kFarJoint_m = 10;       // from its parent
constexpr double kLargeShape_m = 10;     // of one link
constexpr double kHeavyLink_kg = 1'000;  // of one link
constexpr double kSeveralTurns_rad = 5 * kFullTurn_rad;
constexpr const char* kDegrees = "URDF's angles are radians: divide degrees by 57.2958";
constexpr const char* kMillimetres = "URDF's lengths are metres: divide millimetres by 1000";

using Severity = Finding::Severity;

template <typename Values>
double Largest(const Values& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

void Suspect(const std::string& code, int line, const std::string& message,
             const std::string& remedy, Reading& reading) {
  reading.Add(Severity::kWarning, code, line, message, remedy);
}

void SuspectPose(const RawPose& pose, const std::string& of, int line, Reading& reading) {
  if (Largest(pose.rpy_rad) > kFullTurn_rad + 0.01) {
    Suspect("unit-degrees", line, "the rotation of " + of + " is more than a full turn: degrees?",
            kDegrees, reading);
  }
  if (Largest(pose.xyz_m) > kFarJoint_m) {
    Suspect("unit-millimetres", line, of + " sits more than 10 m away: millimetres?", kMillimetres,
            reading);
  }
}

void SuspectShapes(const std::vector<RawShape>& shapes, const std::string& of, Reading& reading) {
  for (const RawShape& shape : shapes) {
    SuspectPose(shape.origin, "a shape of " + of, shape.line, reading);
    const bool is_mesh = shape.kind == RawShape::Kind::kMesh;
    const double size =
        std::max({is_mesh ? 0 : Largest(shape.size), shape.radius_m, shape.length_m});
    if (size > kLargeShape_m) {
      Suspect("unit-millimetres", shape.line,
              "a shape of " + of + " is larger than 10 m: millimetres?", kMillimetres, reading);
    }
  }
}

void SuspectJoint(const RawJoint& joint, Reading& reading) {
  const std::string of = "the joint '" + joint.name + "'";
  SuspectPose(joint.origin, of, joint.line, reading);
  if (!joint.limit) return;
  const double end =
      std::max(std::abs(joint.limit->lower.value_or(0)), std::abs(joint.limit->upper.value_or(0)));
  if (joint.type == "revolute" && end > kSeveralTurns_rad) {
    Suspect("unit-degrees", joint.limit->line, of + " turns by more than five turns: degrees?",
            kDegrees, reading);
  }
  if (joint.type == "prismatic" && end > kFarJoint_m) {
    Suspect("unit-millimetres", joint.limit->line, of + " slides by more than 10 m: millimetres?",
            kMillimetres, reading);
  }
}

void SuspectSensor(const Sensor& sensor, Reading& reading) {
  const double angle =
      std::max({std::abs(sensor.hfov_rad.value_or(0)), std::abs(sensor.min_angle_rad.value_or(0)),
                std::abs(sensor.max_angle_rad.value_or(0))});
  const bool is_old = sensor.type.starts_with("sensor:");
  const std::string of = "the sensor '" + sensor.name + "'";
  if (!is_old && angle > kFullTurn_rad + 0.01) {
    Suspect("unit-degrees", sensor.line, of + " sees more than a full turn: degrees?", kDegrees,
            reading);
  }
  if (is_old && angle > 0 && angle < 0.07) {
    Suspect("unit-radians", sensor.line,
            of + " sees less than 4 degrees: radians? The old form is in degrees",
            "multiply radians by 57.2958, or write <sensor type=…>", reading);
  }
  if (sensor.max_range_m.value_or(0) > 1'000) {
    Suspect("unit-millimetres", sensor.line, of + " measures farther than 1 km: millimetres?",
            kMillimetres, reading);
  }
}

}  // namespace

void SuspectUnits(const RawRobot& robot, Reading& reading) {
  for (const RawLink& link : robot.links) {
    const std::string of = "the link '" + link.name + "'";
    SuspectShapes(link.collision, of, reading);
    SuspectShapes(link.visual, of, reading);
    if (link.inertial && link.inertial->mass_kg > kHeavyLink_kg) {
      Suspect("unit-grams", link.inertial->line, of + " is heavier than 1000 kg: grams?",
              "URDF's masses are kilograms: divide grams by 1000", reading);
    }
  }
  for (const RawJoint& joint : robot.joints) SuspectJoint(joint, reading);
  for (const RawSensor& sensor : robot.sensors) SuspectSensor(sensor.sensor, reading);
}

}  // namespace lares::urdf
