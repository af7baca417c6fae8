#include "robots/urdf/gazebo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"

namespace lares::urdf {
namespace {

using Kind = Sensor::Kind;
using Severity = Finding::Severity;

constexpr double kRadPerDegree = std::numbers::pi / 180;

bool Contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

RigidTransform ToTransform(const RawPose& pose) {
  const Eigen::Quaterniond rotation = Eigen::AngleAxisd(pose.rpy_rad[2], Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(pose.rpy_rad[1], Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(pose.rpy_rad[0], Eigen::Vector3d::UnitX());
  return {rotation, {pose.xyz_m[0], pose.xyz_m[1], pose.xyz_m[2]}};
}

void Take(std::optional<double>& target, std::optional<double> value) {
  if (!target) target = value;
}

bool HasText(const Element& element, std::string_view child) {
  const Element* found = element.Child(child);
  return found != nullptr && !found->text.empty();
}

// <plugin> or <controller:…> below a sensor: topics, frame, noise and what the driver delivers.
struct Driver {
  std::string file;
  bool delivers_depth = false;
};

Driver ReadDriver(const Element& element, Sensor& sensor, Reading& reading) {
  Driver driver;
  const std::string* file = element.Find(element.name == "plugin" ? "filename" : "plugin");
  driver.file = file != nullptr ? *file : element.name;
  if (sensor.plugin.empty()) sensor.plugin = driver.file;
  const auto text = [&](std::string_view child, std::string& target) {
    const Element* found = element.Child(child);
    if (target.empty() && found != nullptr) target = found->text;
  };
  text("frameName", sensor.frame);
  text("frame_name", sensor.frame);
  text("topicName", sensor.topic);
  text("imageTopicName", sensor.topic);
  Take(sensor.noise, reading.ChildNumber(element, "gaussianNoise"));
  // The driver's rate is the one at which messages come.
  const auto rate = reading.ChildNumber(element, "updateRate");
  if (rate && *rate > 0) sensor.rate_hz = rate;
  driver.delivers_depth = HasText(element, "pointCloudTopicName") ||
                          HasText(element, "depthImageTopicName") ||
                          Contains(driver.file, "openni") || Contains(driver.file, "kinect") ||
                          Contains(driver.file, "realsense");
  return driver;
}

void ReadCamera(const Element& camera, Sensor& sensor, Reading& reading) {
  Take(sensor.hfov_rad, reading.ChildNumber(camera, "horizontal_fov"));
  if (const Element* image = camera.Child("image")) {
    Take(sensor.width_px, reading.ChildNumber(*image, "width"));
    Take(sensor.height_px, reading.ChildNumber(*image, "height"));
    if (const Element* format = image->Child("format")) sensor.format = format->text;
  }
  if (const Element* clip = camera.Child("clip")) {
    Take(sensor.near_clip_m, reading.ChildNumber(*clip, "near"));
    Take(sensor.far_clip_m, reading.ChildNumber(*clip, "far"));
  }
  if (const Element* noise = camera.Child("noise")) {
    Take(sensor.noise, reading.ChildNumber(*noise, "stddev"));
  }
}

void ReadRay(const Element& ray, Sensor& sensor, Reading& reading) {
  if (const Element* scan = ray.Child("scan")) {
    if (const Element* horizontal = scan->Child("horizontal")) {
      Take(sensor.beam_count, reading.ChildNumber(*horizontal, "samples"));
      Take(sensor.min_angle_rad, reading.ChildNumber(*horizontal, "min_angle"));
      Take(sensor.max_angle_rad, reading.ChildNumber(*horizontal, "max_angle"));
    }
    if (const Element* vertical = scan->Child("vertical")) {
      Take(sensor.plane_count, reading.ChildNumber(*vertical, "samples"));
    }
  }
  if (const Element* range = ray.Child("range")) {
    Take(sensor.min_range_m, reading.ChildNumber(*range, "min"));
    Take(sensor.max_range_m, reading.ChildNumber(*range, "max"));
  }
  if (const Element* noise = ray.Child("noise")) {
    Take(sensor.noise, reading.ChildNumber(*noise, "stddev"));
  }
}

bool IsGrey(const std::string& format) {
  return format == "L8" || format == "L_INT8" || format == "L16" || format == "L_INT16" ||
         Contains(ToLower(format), "mono");
}

// What a camera delivers follows from its type, its driver's topics and its image format.
void DecideCamera(const std::string& type, const std::vector<Driver>& drivers, Sensor& sensor) {
  sensor.monochrome = IsGrey(sensor.format);
  const bool says_depth = Contains(type, "depth") || Contains(type, "rgbd");
  const bool driver_depth = std::any_of(drivers.begin(), drivers.end(),
                                        [](const Driver& driver) { return driver.delivers_depth; });
  const std::string by = "the simulator's sensor '" + sensor.name + "' of type " + type;
  if (Contains(type, "multicamera") || Contains(type, "stereo")) {
    sensor.kind = Kind::kStereoCamera;
    sensor.reason = by + " has two lenses";
  } else if (driver_depth || Contains(type, "rgbd") || (says_depth && drivers.empty())) {
    sensor.kind = sensor.monochrome ? Kind::kDepthCamera : Kind::kRgbdCamera;
    if (Contains(type, "depth_camera") && drivers.empty()) sensor.kind = Kind::kDepthCamera;
    sensor.reason = by + " delivers depth" + (driver_depth ? " through " + sensor.plugin : "") +
                    (sensor.kind == Kind::kRgbdCamera ? " and colours" : " and no colours");
  } else {
    sensor.kind = Kind::kCamera;
    sensor.reason =
        by + (says_depth ? " delivers images and neither depth nor points through " + sensor.plugin
                         : " is a camera");
  }
  if (!sensor.format.empty()) sensor.reason += " (format " + sensor.format + ")";
}

void DecideOther(const std::string& type, Sensor& sensor) {
  const bool is_laser = Contains(type, "ray") || Contains(type, "lidar");
  if (is_laser && Contains(ToLower(sensor.plugin), "range")) {
    sensor.kind = Kind::kSonar;
  } else if (is_laser) {
    sensor.kind = sensor.plane_count.value_or(1) > 1 ? Kind::kLaser3d : Kind::kLaser2d;
  } else if (Contains(type, "sonar") || Contains(type, "ultrasonic")) {
    sensor.kind = Kind::kSonar;
  } else if (type == "contact" || type == "sensor:contact" || Contains(type, "bumper")) {
    sensor.kind = Kind::kBumper;
  } else if (Contains(type, "imu")) {
    sensor.kind = Kind::kInertial;
  } else if (Contains(type, "force_torque")) {
    sensor.kind = Kind::kForceTorque;
  }
  sensor.reason = "the simulator's sensor '" + sensor.name + "' is of type " + type;
}

bool IsCameraType(const std::string& type) {
  return Contains(type, "camera") || type == "depth" || type == "multicamera" ||
         Contains(type, "rgbd") || Contains(type, "kinect");
}

void Decide(const std::vector<Driver>& drivers, Sensor& sensor) {
  const std::string type = ToLower(sensor.type);
  if (IsCameraType(type)) {
    DecideCamera(type, drivers, sensor);
  } else {
    DecideOther(type, sensor);
  }
  // What a depth camera does not show, it does not measure either.
  if (sensor.kind == Kind::kRgbdCamera || sensor.kind == Kind::kDepthCamera) {
    Take(sensor.min_range_m, sensor.near_clip_m);
    Take(sensor.max_range_m, sensor.far_clip_m);
  }
}

// <sensor type="…"> as SDF has it: angles in radians.
void ReadSdfSensor(const Element& element, const std::string& link, RawRobot& robot,
                   Reading& reading) {
  RawSensor raw;
  raw.link = link;
  Sensor& sensor = raw.sensor;
  sensor.line = element.line;
  if (const std::string* name = element.Find("name")) sensor.name = *name;
  if (const std::string* type = element.Find("type")) sensor.type = *type;
  if (sensor.name.empty()) sensor.name = link + "_" + sensor.type;
  Take(sensor.rate_hz, reading.ChildNumber(element, "update_rate"));
  if (HasText(element, "pose")) {
    sensor.link_from_sensor = ToTransform(reading.PoseText(*element.Child("pose")));
  }
  for (const char* topic : {"topic", "gz_frame_id", "ignition_frame_id", "frame_id"}) {
    const Element* found = element.Child(topic);
    if (found != nullptr)
      (std::string_view(topic) == "topic" ? sensor.topic : sensor.frame) = found->text;
  }
  std::vector<Driver> drivers;
  for (const Element& child : element.children) {
    if (child.name == "camera" || child.name == "depth_camera") ReadCamera(child, sensor, reading);
    if (child.name == "ray" || child.name == "lidar") ReadRay(child, sensor, reading);
    if (child.name == "plugin") drivers.push_back(ReadDriver(child, sensor, reading));
  }
  Decide(drivers, sensor);
  robot.sensors.push_back(std::move(raw));
}

std::optional<double> Degrees(std::optional<double> degrees) {
  return degrees ? std::optional(*degrees * kRadPerDegree) : std::nullopt;
}

// <sensor:camera>, <sensor:ray>, …: angles in degrees.
void ReadOldSensor(const Element& element, const std::string& link, RawRobot& robot,
                   Reading& reading) {
  RawSensor raw;
  raw.link = link;
  Sensor& sensor = raw.sensor;
  sensor.line = element.line;
  sensor.type = "sensor:" + element.name;
  const std::string* name = element.Find("name");
  sensor.name = name != nullptr ? *name : link + "_" + element.name;
  const auto number = [&](const char* child) { return reading.ChildNumber(element, child); };
  Take(sensor.rate_hz, number("updateRate"));
  sensor.hfov_rad = Degrees(number("hfov"));
  sensor.near_clip_m = number("nearClip");
  sensor.far_clip_m = number("farClip");
  sensor.min_range_m = number("minRange");
  sensor.max_range_m = number("maxRange");
  sensor.min_angle_rad = Degrees(number("minAngle"));
  sensor.max_angle_rad = Degrees(number("maxAngle"));
  sensor.beam_count = number("rangeCount");
  Take(sensor.beam_count, number("rayCount"));
  sensor.plane_count = number("laserCount");
  if (const Element* format = element.Child("imageFormat")) sensor.format = format->text;
  if (const Element* size = element.Child("imageSize")) {
    if (const auto both = reading.Pair(*size)) {
      sensor.width_px = (*both)[0];
      sensor.height_px = (*both)[1];
    }
  }
  std::vector<Driver> drivers;
  for (const Element& child : element.children) {
    if (child.prefix == "controller" || child.name == "plugin") {
      drivers.push_back(ReadDriver(child, sensor, reading));
    }
  }
  Decide(drivers, sensor);
  robot.sensors.push_back(std::move(raw));
}

// URDF's own <sensor name=…><parent link=…/><camera|ray>…, with values as attributes.
void ReadUrdfSensor(const Element& element, RawRobot& robot, Reading& reading) {
  const Element* parent = element.Child("parent");
  const std::string* link = parent != nullptr ? parent->Find("link") : nullptr;
  if (link == nullptr) {
    reading.Add(Severity::kWarning, "sensor-nowhere", element.line,
                "a <sensor> names no parent link; it is left out");
    return;
  }
  RawSensor raw;
  raw.link = *link;
  Sensor& sensor = raw.sensor;
  sensor.line = element.line;
  const std::string* name = element.Find("name");
  sensor.name = name != nullptr ? *name : *link + "_sensor";
  sensor.rate_hz = reading.Attribute(element, "update_rate");
  sensor.link_from_sensor = ToTransform(reading.Origin(element));
  if (const Element* camera = element.Child("camera")) {
    sensor.type = "camera";
    if (const Element* image = camera->Child("image")) {
      sensor.width_px = reading.Attribute(*image, "width");
      sensor.height_px = reading.Attribute(*image, "height");
      sensor.hfov_rad = reading.Attribute(*image, "hfov");
      sensor.near_clip_m = reading.Attribute(*image, "near");
      sensor.far_clip_m = reading.Attribute(*image, "far");
      if (const std::string* format = image->Find("format")) sensor.format = *format;
    }
  } else if (const Element* ray = element.Child("ray")) {
    sensor.type = "ray";
    if (const Element* horizontal = ray->Child("horizontal")) {
      sensor.beam_count = reading.Attribute(*horizontal, "samples");
      sensor.min_angle_rad = reading.Attribute(*horizontal, "min_angle");
      sensor.max_angle_rad = reading.Attribute(*horizontal, "max_angle");
    }
  }
  Decide({}, sensor);
  robot.sensors.push_back(std::move(raw));
}

void ReadPlugin(const Element& element, const std::string& link, RawRobot& robot) {
  const std::string* file = element.Find(element.name == "plugin" ? "filename" : "plugin");
  const std::string* name = element.Find("name");
  robot.plugins.push_back(
      {name != nullptr ? *name : "", file != nullptr ? *file : element.name, link, element.line});
}

}  // namespace

bool IsCamera(Sensor::Kind kind) {
  return kind == Kind::kCamera || kind == Kind::kDepthCamera || kind == Kind::kRgbdCamera ||
         kind == Kind::kStereoCamera;
}

bool IsLaser(Sensor::Kind kind) { return kind == Kind::kLaser2d || kind == Kind::kLaser3d; }

void ReadSensors(const Element& root, RawRobot& robot, Reading& reading) {
  for (const Element& element : root.children) {
    if (element.name == "sensor" && element.prefix.empty()) ReadUrdfSensor(element, robot, reading);
    if (element.name != "gazebo") continue;
    const std::string* reference = element.Find("reference");
    const std::string link = reference != nullptr ? *reference : "";
    for (const Element& child : element.children) {
      if (child.prefix == "sensor") {
        ReadOldSensor(child, link, robot, reading);
      } else if (child.name == "sensor") {
        ReadSdfSensor(child, link, robot, reading);
      } else if (child.name == "plugin" || child.prefix == "controller") {
        ReadPlugin(child, link, robot);
      }
    }
  }
}

}  // namespace lares::urdf
