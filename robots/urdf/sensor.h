// Sensors and simulator plugins of a URDF's <gazebo> and <sensor> elements.
#pragma once

#include <optional>
#include <string>

#include "base/rigid_transform.h"

namespace lares::urdf {

struct Sensor {
  enum class Kind {
    kCamera,       // images without depth
    kDepthCamera,  // depth without colour
    kRgbdCamera,   // both
    kStereoCamera,
    kLaser2d,
    kLaser3d,
    kSonar,
    kBumper,
    kInertial,
    kForceTorque,
    kOther,
  };
  Kind kind = Kind::kOther;
  std::string name;
  std::string type;  // as written: "gpu_ray", "sensor:camera", …
  int link = -1;     // of Model::links
  RigidTransform link_from_sensor;
  int line = 0;
  bool monochrome = false;  // the image format has no colours
  std::optional<double> min_range_m, max_range_m;
  std::optional<double> near_clip_m, far_clip_m;
  std::optional<double> hfov_rad;
  std::optional<double> min_angle_rad, max_angle_rad;
  std::optional<double> beam_count, plane_count;
  std::optional<double> width_px, height_px;
  std::optional<double> rate_hz;
  std::optional<double> noise;  // standard deviation; metres for ranges
  std::string frame, topic, format, plugin;
  std::string reason;  // why it is of this kind
};

struct Plugin {
  std::string name;
  std::string file;
  std::string link;  // of the <gazebo reference>; may be empty
  int line = 0;
};

bool IsCamera(Sensor::Kind kind);  // one that delivers images or depth
bool IsLaser(Sensor::Kind kind);

}  // namespace lares::urdf
