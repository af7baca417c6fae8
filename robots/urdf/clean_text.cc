#include "robots/urdf/clean_text.h"

#include <array>
#include <cstdio>
#include <map>

namespace lares::urdf {
namespace {

std::string Number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

template <std::size_t N>
std::string Numbers(const std::array<double, N>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + Number(value);
  return text;
}

std::string Attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

std::string Attribute(const std::string& name, double value) {
  return Attribute(name, Number(value));
}

std::string Origin(const RawPose& pose) {
  return "<origin" + Attribute("xyz", Numbers(pose.xyz_m)) +
         Attribute("rpy", Numbers(pose.rpy_rad)) + "/>";
}

std::string Geometry(const RawShape& shape) {
  switch (shape.kind) {
    case RawShape::Kind::kBox:
      return "<box" + Attribute("size", Numbers(shape.size)) + "/>";
    case RawShape::Kind::kCylinder:
      return "<cylinder" + Attribute("radius", shape.radius_m) +
             Attribute("length", shape.length_m) + "/>";
    case RawShape::Kind::kSphere:
      return "<sphere" + Attribute("radius", shape.radius_m) + "/>";
    case RawShape::Kind::kMesh:
      return "<mesh filename=\"package://mesh\"" + Attribute("scale", Numbers(shape.size)) + "/>";
  }
  return "";
}

void AddShapes(const std::vector<RawShape>& shapes, const std::string& element, std::string& text) {
  for (const RawShape& shape : shapes) {
    text += "<" + element + ">" + Origin(shape.origin) + "<geometry>" + Geometry(shape) +
            "</geometry></" + element + ">\n";
  }
}

void AddInertial(const RawInertial& inertial, std::string& text) {
  constexpr const char* kNames[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
  const std::array<double, 6> inertia = inertial.inertia.value_or(std::array<double, 6>{});
  text += "<inertial>" + Origin(inertial.origin) + "<mass" + Attribute("value", inertial.mass_kg) +
          "/><inertia";
  for (std::size_t i = 0; i < 6; ++i) text += Attribute(kNames[i], inertia[i]);
  text += "/></inertial>\n";
}

void AddJoint(const RawJoint& joint, const std::string& name, const std::string& parent,
              const std::string& child, std::string& text) {
  text += "<joint" + Attribute("name", name) + Attribute("type", joint.type) + "><parent" +
          Attribute("link", parent) + "/><child" + Attribute("link", child) + "/>" +
          Origin(joint.origin);
  if (joint.axis) text += "<axis" + Attribute("xyz", Numbers(*joint.axis)) + "/>";
  if (joint.limit) {
    text += "<limit" + Attribute("lower", joint.limit->lower.value_or(0)) +
            Attribute("upper", joint.limit->upper.value_or(0)) +
            Attribute("effort", joint.limit->effort.value_or(0)) +
            Attribute("velocity", joint.limit->velocity.value_or(0)) + "/>";
  }
  text += "</joint>\n";
}

}  // namespace

std::string CleanText(const RawRobot& robot) {
  std::string text = "<robot name=\"robot\">\n";
  std::map<std::string, std::string> links;
  for (const RawLink& link : robot.links) {
    const std::string name = "l" + std::to_string(links.size());
    links.emplace(link.name, name);
    text += "<link" + Attribute("name", name) + ">\n";
    if (link.inertial) AddInertial(*link.inertial, text);
    AddShapes(link.visual, "visual", text);
    AddShapes(link.collision, "collision", text);
    text += "</link>\n";
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const RawJoint& joint = robot.joints[i];
    AddJoint(joint, "j" + std::to_string(i), links.at(joint.parent), links.at(joint.child), text);
  }
  return text + "</robot>\n";
}

}  // namespace lares::urdf
