#include "robots/urdf/doctor.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/quote.h"
#include "robots/urdf/scan.h"

namespace lares::urdf {
namespace {

using Severity = Finding::Severity;

constexpr double kAlike_rad = 0.03;

class Notes {
 public:
  Notes(const std::string& source, std::vector<Finding>& findings)
      : source_(source), findings_(findings) {}
  void Add(Severity severity, const char* code, int line, std::string message,
           std::string remedy = "") {
    findings_.push_back(
        {severity, code, {source_, line, 0}, std::move(message), std::move(remedy)});
  }

 private:
  const std::string& source_;
  std::vector<Finding>& findings_;
};

void ExamineBaseFrames(const Model& model, Notes& notes) {
  const Link& root = model.links[At(model.root)];
  const int base = model.FindLink("base_link");
  const int footprint = model.FindLink("base_footprint");
  if (base < 0) {
    notes.Add(Severity::kWarning, "no-base-link", root.line,
              "there is no link 'base_link', which REP-105 wants",
              "name the robot's rigid base base_link");
  }
  if (footprint >= 0 && footprint != model.root) {
    notes.Add(Severity::kWarning, "footprint-not-root", model.links[At(footprint)].line,
              "'base_footprint' is not the root of the tree",
              "let base_footprint carry base_link by a fixed joint");
  }
  if (root.inertial && root.inertial->mass_kg > 0) {
    notes.Add(Severity::kNote, "root-inertia", root.line,
              "the root " + Quote(root.name) + " has an inertia, which KDL leaves out",
              "put a link without inertia above it");
  }
  if (footprint < 0 || base < 0) return;
  const int above = model.links[At(base)].parent_joint;
  if (above < 0 || model.joints[At(above)].parent != footprint) return;
  const Joint& joint = model.joints[At(above)];
  if (Moves(joint)) {
    notes.Add(Severity::kWarning, "footprint-moves", joint.line,
              "the joint " + Quote(joint.name) + " between base_footprint and base_link moves",
              "make it fixed");
  }
  const double turned =
      joint.parent_from_child.rotation.angularDistance(Eigen::Quaterniond::Identity());
  if (turned > kAlike_rad) {
    notes.Add(Severity::kWarning, "base-turned", joint.line,
              "base_link is turned against base_footprint: by REP-103 both have x forward, y left, "
              "z up",
              "take the rotation out of " + Quote(joint.name));
  }
  if (joint.parent_from_child.translation_m.z() < -1e-6) {
    notes.Add(Severity::kWarning, "base-below-floor", joint.line,
              "base_link lies below base_footprint, which is on the floor");
  }
}

// x of the optical frame to the right, y down, z forward (REP-103), seen from the body frame.
bool IsOptical(const Eigen::Quaterniond& body_from_optical) {
  Eigen::Matrix3d wanted;
  wanted << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return body_from_optical.angularDistance(Eigen::Quaterniond(wanted)) < kAlike_rad;
}

void ExamineOpticalFrames(const Model& model, Notes& notes) {
  for (const Link& link : model.links) {
    if (!HasWord(link.name, {"optical"}) || link.parent_joint < 0) continue;
    const Joint& joint = model.joints[At(link.parent_joint)];
    if (HasWord(model.links[At(joint.parent)].name, {"optical"})) continue;
    if (IsOptical(joint.parent_from_child.rotation)) continue;
    notes.Add(Severity::kWarning, "optical-frame", joint.line,
              "the optical frame " + Quote(link.name) +
                  " does not look forward out of its parent: by REP-103 z is forward, x right, "
                  "y down",
              "give " + Quote(joint.name) + " rpy=\"-1.5708 0 -1.5708\"");
  }
}

bool HasBody(const Model& model, const Link& link) {
  const bool moved = link.parent_joint >= 0 && Moves(model.joints[At(link.parent_joint)]);
  return moved || !link.collision.empty() || !link.visual.empty();
}

void ExamineTensor(const Link& link, Notes& notes) {
  const Inertial& inertial = *link.inertial;
  const std::string of = "the inertia of " + Quote(link.name);
  if (!inertial.inertia_kg_m2) {
    notes.Add(Severity::kWarning, "no-tensor", inertial.line, of + " has no <inertia>",
              "add <inertia ixx=… ixy=… ixz=… iyy=… iyz=… izz=…/>");
    return;
  }
  const Eigen::Matrix3d& tensor = *inertial.inertia_kg_m2;
  const double size = tensor.cwiseAbs().maxCoeff();
  if (size == 0) {
    notes.Add(Severity::kWarning, "zero-inertia", inertial.line, of + " is zero",
              "give the inertia of a box of its size");
    return;
  }
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor / size).eigenvalues();
  if (!(moments[0] > 1e-9)) {
    notes.Add(Severity::kError, "not-positive-definite", inertial.line,
              of + " is not positive definite: no body turns like that",
              "check the signs of the entries beside the diagonal");
  } else if (moments[0] + moments[1] < moments[2] * 0.999) {
    notes.Add(Severity::kWarning, "impossible-inertia", inertial.line,
              of + " has one principal moment larger than the other two together, which no body "
                   "has",
              "compute it anew about the centre of mass");
  }
}

void ExamineInertia(const Model& model, Notes& notes) {
  for (const Link& link : model.links) {
    if (!link.inertial) {
      if (HasBody(model, link)) {
        notes.Add(Severity::kWarning, "no-inertia", link.line,
                  "the link " + Quote(link.name) + " has no <inertial>",
                  "simulators leave such a link out: add mass and inertia");
      }
      continue;
    }
    const double mass = link.inertial->mass_kg;
    if (mass < 0) {
      notes.Add(Severity::kError, "negative-mass", link.inertial->line,
                "the mass of " + Quote(link.name) + " is negative");
    } else if (mass == 0) {
      notes.Add(Severity::kWarning, "zero-mass", link.inertial->line,
                "the mass of " + Quote(link.name) + " is zero",
                "take the <inertial> out, or give a mass");
    }
    ExamineTensor(link, notes);
  }
}

void ExamineLimits(const Model& model, Notes& notes) {
  for (const Joint& joint : model.joints) {
    const std::string of = "the joint " + Quote(joint.name);
    if (joint.lower && joint.upper && *joint.lower > *joint.upper) {
      notes.Add(Severity::kError, "limits-swapped", joint.line, of + " has lower above upper",
                "swap lower and upper");
    } else if (joint.lower && joint.upper && *joint.lower == *joint.upper) {
      notes.Add(Severity::kWarning, "limits-equal", joint.line, of + " cannot move: lower is upper",
                "make it fixed, or give its limits");
    }
    if (joint.kind != Joint::Kind::kRevolute && joint.kind != Joint::Kind::kPrismatic) continue;
    if (!joint.lower) {
      notes.Add(Severity::kWarning, "no-ends", joint.line,
                of + " states neither lower nor upper: readers take both for 0",
                "add lower=… and upper=… to its <limit>");
    }
    if (joint.effort.value_or(0) <= 0) {
      notes.Add(Severity::kWarning, "no-effort", joint.line, of + " has no effort above zero",
                "add effort=… to its <limit>");
    }
    if (joint.velocity.value_or(0) <= 0) {
      notes.Add(Severity::kWarning, "no-velocity", joint.line, of + " has no velocity above zero",
                "add velocity=… to its <limit>");
    }
  }
}

std::vector<Finding> Unreadable(const Error& error) {
  const Place place = error.place().value_or(Place{});
  return {{Severity::kError, "unreadable", place, error.what(), error.hint()}};
}

}  // namespace

void ExamineFrames(const Model& model, const std::string& source, std::vector<Finding>& findings) {
  Notes notes(source, findings);
  ExamineBaseFrames(model, notes);
  ExamineOpticalFrames(model, notes);
}

void ExamineDynamics(const Model& model, const std::string& source,
                     std::vector<Finding>& findings) {
  Notes notes(source, findings);
  ExamineInertia(model, notes);
  ExamineLimits(model, notes);
}

void ExamineSensors(const Model& model, const std::string& source, std::vector<Finding>& findings) {
  Notes notes(source, findings);
  for (const Sensor& sensor : model.sensors) {
    const std::string of = "the sensor " + Quote(sensor.name);
    if (sensor.min_range_m && sensor.max_range_m && *sensor.min_range_m >= *sensor.max_range_m) {
      notes.Add(Severity::kError, "range-swapped", sensor.line,
                of + " has a smallest range that is not below its largest");
    }
    if (sensor.min_angle_rad && sensor.max_angle_rad &&
        *sensor.min_angle_rad > *sensor.max_angle_rad) {
      notes.Add(Severity::kError, "angles-swapped", sensor.line,
                of + " begins at a larger angle than it ends");
    }
    if (sensor.hfov_rad && !(*sensor.hfov_rad > 0)) {
      notes.Add(Severity::kError, "no-view", sensor.line, of + " has a field of view of nothing");
    }
    if (IsCamera(sensor.kind) && !sensor.hfov_rad) {
      notes.Add(Severity::kWarning, "no-view", sensor.line, of + " states no field of view",
                "add <horizontal_fov>");
    }
    if (IsLaser(sensor.kind) && !sensor.max_range_m) {
      notes.Add(Severity::kWarning, "no-range", sensor.line, of + " states no range",
                "add <range><min>…</min><max>…</max></range>");
    }
  }
}

std::vector<Finding> Examine(std::string_view bytes, const std::string& source,
                             const SrdlToCompare* srdl, const Limits& limits) {
  std::vector<Finding> findings;
  try {
    findings = Scan(bytes, source, limits).findings;
    if (HasErrors(findings)) return findings;
    const Model model = ReadUrdf(bytes, source, limits);
    ExamineFrames(model, source, findings);
    ExamineDynamics(model, source, findings);
    ExamineSensors(model, source, findings);
    if (srdl != nullptr) CompareWithSrdl(model, *srdl, {}, source, findings);
  } catch (const Error& error) {
    if (error.code() == Code::kInternal) throw;
    return Unreadable(error);
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.place.line < b.place.line; });
  return findings;
}

}  // namespace lares::urdf
