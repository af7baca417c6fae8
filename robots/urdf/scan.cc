#include "robots/urdf/scan.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "robots/urdf/gazebo.h"
#include "robots/urdf/reading.h"
#include "robots/urdf/structure.h"
#include "robots/urdf/units.h"
#include "robots/urdf/xml_tree.h"

namespace lares::urdf {
namespace {

constexpr const char* kJointTypes[] = {"revolute", "continuous", "prismatic",
                                       "fixed",    "floating",   "planar"};

// Text that is never opened; one that leaves its package is worth a word.
void CheckMeshPath(const std::string& path, int line, Reading& reading) {
  std::string_view rest = path;
  const std::size_t scheme = rest.find("://");
  if (scheme != std::string_view::npos) rest.remove_prefix(scheme + 3);
  for (std::size_t at = 0; at <= rest.size();) {
    const std::size_t end = std::min(rest.find_first_of("/\\", at), rest.size());
    if (rest.substr(at, end - at) == "..") {
      reading.Add(Finding::Severity::kWarning, "mesh-outside", line,
                  "the mesh path '" + path.substr(0, 80) + "' points outside with '..'",
                  "name the mesh by package://PACKAGE/PATH; Lares opens no mesh");
      return;
    }
    at = end + 1;
  }
}

// A size that must not be negative; zero is what people write for "nothing".
double Size(const Element& element, std::string_view attribute, Reading& reading) {
  if (element.Find(attribute) == nullptr) {
    reading.Fault("no-size", element.line,
                  "<" + element.name + "> has no attribute '" + std::string(attribute) + "'");
  }
  const double value = reading.Attribute(element, attribute).value_or(0);
  if (value < 0) {
    reading.Fault(
        "no-size", element.line,
        "attribute '" + std::string(attribute) + "' of <" + element.name + "> is negative");
  }
  return value;
}

bool ReadShape(const Element& shape, RawShape& raw, Reading& reading) {
  raw.line = shape.line;
  if (shape.name == "box") {
    raw.kind = RawShape::Kind::kBox;
    raw.size = reading.Vector(shape, "size").value_or(std::array<double, 3>{});
    if (*std::min_element(raw.size.begin(), raw.size.end()) < 0) {
      reading.Fault("no-size", shape.line, "attribute 'size' of <box> is negative");
    }
  } else if (shape.name == "cylinder" || shape.name == "capsule") {
    raw.kind = RawShape::Kind::kCylinder;
    raw.radius_m = Size(shape, "radius", reading);
    raw.length_m = Size(shape, "length", reading);
  } else if (shape.name == "sphere") {
    raw.kind = RawShape::Kind::kSphere;
    raw.radius_m = Size(shape, "radius", reading);
  } else if (shape.name == "mesh") {
    raw.kind = RawShape::Kind::kMesh;
    if (const std::string* path = shape.Find("filename")) {
      raw.mesh = *path;
      CheckMeshPath(*path, shape.line, reading);
    }
    if (const auto scale = reading.Vector(shape, "scale")) raw.size = *scale;
  } else {
    return false;
  }
  return true;
}

void ReadShapes(const Element& link, std::string_view kind, std::vector<RawShape>& shapes,
                Reading& reading) {
  for (const Element* element : link.Children(kind)) {
    RawShape raw;
    raw.origin = reading.Origin(*element);
    const Element* geometry = element->Child("geometry");
    bool found = false;
    for (std::size_t i = 0; geometry != nullptr && i < geometry->children.size() && !found; ++i) {
      found = ReadShape(geometry->children[i], raw, reading);
    }
    if (found) {
      shapes.push_back(std::move(raw));
    } else {
      reading.Add(Finding::Severity::kWarning, "no-geometry", element->line,
                  "<" + element->name + "> has no box, cylinder, sphere or mesh");
    }
  }
}

std::optional<RawInertial> ReadInertial(const Element& link, Reading& reading) {
  const Element* element = link.Child("inertial");
  if (element == nullptr) return std::nullopt;
  RawInertial raw;
  raw.line = element->line;
  raw.origin = reading.Origin(*element);
  if (const Element* mass = element->Child("mass")) {
    raw.mass_kg = reading.Attribute(*mass, "value").value_or(0);
  }
  if (const Element* inertia = element->Child("inertia")) {
    std::array<double, 6> values{};
    constexpr const char* kNames[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    for (std::size_t i = 0; i < 6; ++i) {
      values[i] = reading.Attribute(*inertia, kNames[i]).value_or(0);
    }
    raw.inertia = values;
  }
  return raw;
}

RawLink ReadLink(const Element& element, Reading& reading) {
  RawLink link;
  link.line = element.line;
  link.name = reading.Name(element, "name", "<link>");
  link.inertial = ReadInertial(element, reading);
  ReadShapes(element, "collision", link.collision, reading);
  ReadShapes(element, "visual", link.visual, reading);
  return link;
}

void ReadLimit(const Element& element, RawJoint& joint, Reading& reading) {
  const bool needs_limit = joint.type == "revolute" || joint.type == "prismatic";
  const Element* limit = element.Child("limit");
  if (limit == nullptr) {
    if (needs_limit) {
      reading.Fault("no-limits", element.line,
                    "the " + joint.type + " joint '" + joint.name + "' has no <limit>",
                    "add <limit lower=… upper=… effort=… velocity=…/>, or make it continuous");
    }
    return;
  }
  RawLimit raw;
  raw.line = limit->line;
  raw.lower = reading.Attribute(*limit, "lower");
  raw.upper = reading.Attribute(*limit, "upper");
  raw.effort = reading.Attribute(*limit, "effort");
  raw.velocity = reading.Attribute(*limit, "velocity");
  joint.limit = raw;
}

std::string LinkOf(const Element& joint, const std::string& name, std::string_view end,
                   Reading& reading) {
  const Element* element = joint.Child(end);
  if (element == nullptr) {
    reading.Fault("no-" + std::string(end), joint.line,
                  "the joint '" + name + "' has no <" + std::string(end) + ">",
                  "add <" + std::string(end) + " link=…/>");
    return "";
  }
  return reading.Name(*element, "link", "<" + std::string(end) + "> of the joint '" + name + "'");
}

RawJoint ReadJoint(const Element& element, Reading& reading) {
  RawJoint joint;
  joint.line = element.line;
  joint.name = reading.Name(element, "name", "<joint>");
  if (const std::string* type = element.Find("type")) joint.type = *type;
  if (std::find(std::begin(kJointTypes), std::end(kJointTypes), joint.type) ==
      std::end(kJointTypes)) {
    reading.Fault(
        "joint-type", element.line,
        "the joint '" + joint.name + "' has the unknown type '" + joint.type.substr(0, 40) + "'",
        "the types are revolute, continuous, prismatic, fixed, floating and planar");
  }
  joint.parent = LinkOf(element, joint.name, "parent", reading);
  joint.child = LinkOf(element, joint.name, "child", reading);
  joint.origin = reading.Origin(element);
  if (const Element* axis = element.Child("axis")) joint.axis = reading.Vector(*axis, "xyz");
  ReadLimit(element, joint, reading);
  if (const Element* mimic = element.Child("mimic")) {
    joint.mimic = reading.Name(*mimic, "joint", "<mimic> of the joint '" + joint.name + "'");
  }
  return joint;
}

// The joints that a transmission or a ros2_control interface drives.
void ReadActuated(const Element& root, std::vector<std::string>& actuated) {
  const auto add = [&](const Element& joint) {
    if (const std::string* name = joint.Find("name")) actuated.push_back(*name);
  };
  for (const Element& element : root.children) {
    if (element.name == "transmission") {
      for (const Element& part : element.children) {
        if (part.name == "joint" || part.name.ends_with("_joint")) add(part);
        // Wheels in pairs: <rollJoint name=…/>, <flexJoint name=…/>.
        if (part.name.ends_with("Joint")) add(part);
      }
    } else if (element.name == "ros2_control") {
      for (const Element* joint : element.Children("joint")) {
        if (joint->Child("command_interface") != nullptr) add(*joint);
      }
    }
  }
  std::sort(actuated.begin(), actuated.end());
  actuated.erase(std::unique(actuated.begin(), actuated.end()), actuated.end());
}

}  // namespace

Scanned Scan(std::string_view bytes, const std::string& source, const Limits& limits) {
  const Element root = ReadXmlTree(bytes, source, limits);
  Reading reading(source);
  Scanned scanned;
  RawRobot& robot = scanned.robot;
  robot.name = reading.Name(root, "name", "<robot>");
  for (const Element& element : root.children) {
    if (!element.prefix.empty()) continue;
    if (element.name == "link") robot.links.push_back(ReadLink(element, reading));
    if (element.name == "joint") robot.joints.push_back(ReadJoint(element, reading));
  }
  ReadSensors(root, robot, reading);
  if (robot.sensors.size() > limits.max_sensors) {
    throw Error(Code::kTooLarge,
                "there are more than " + std::to_string(limits.max_sensors) +
                    " sensors (the limit max_sensors)",
                {source, robot.sensors[limits.max_sensors].sensor.line, 0});
  }
  ReadActuated(root, robot.actuated);
  CheckStructure(robot, limits, reading);
  SuspectUnits(robot, reading);
  scanned.findings = reading.TakeFindings();
  std::stable_sort(scanned.findings.begin(), scanned.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.place.line < b.place.line; });
  return scanned;
}

}  // namespace lares::urdf
