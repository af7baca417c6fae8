// Small URDFs for tests.
#pragma once

#include <string>

namespace lares::testing {

inline std::string Robot(const std::string& body) {
  return "<?xml version=\"1.0\"?>\n<robot name=\"test\">\n" + body + "</robot>\n";
}

inline std::string LinkText(const std::string& name, const std::string& body = "") {
  return "<link name=\"" + name + "\">" + body + "</link>\n";
}

inline std::string JointText(const std::string& name, const std::string& type,
                             const std::string& parent, const std::string& child,
                             const std::string& body = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + body + "</joint>\n";
}

inline std::string Shape(const std::string& shape, const std::string& xyz = "0 0 0") {
  return "<collision><origin xyz=\"" + xyz + "\"/><geometry>" + shape + "</geometry></collision>";
}

inline std::string Origin(const std::string& xyz, const std::string& rpy = "0 0 0") {
  return "<origin xyz=\"" + xyz + "\" rpy=\"" + rpy + "\"/>";
}

// A cart on two driven wheels with a laser and a camera on a mast.
inline std::string Cart() {
  const std::string wheel =
      "<collision><origin rpy=\"1.5708 0 0\"/><geometry><cylinder "
      "radius=\"0.1\" length=\"0.04\"/></geometry></collision>";
  return Robot(
      LinkText("base_footprint") +
      LinkText("base_link", Shape("<box size=\"0.5 0.4 0.2\"/>", "0 0 0.05")) +
      LinkText("left_wheel", wheel) + LinkText("right_wheel", wheel) + LinkText("laser") +
      LinkText("camera") + LinkText("camera_optical_frame") +
      JointText("base_joint", "fixed", "base_footprint", "base_link", Origin("0 0 0.1")) +
      JointText("left_wheel_joint", "continuous", "base_link", "left_wheel",
                Origin("0 0.22 0") + "<axis xyz=\"0 1 0\"/>") +
      JointText("right_wheel_joint", "continuous", "base_link", "right_wheel",
                Origin("0 -0.22 0") + "<axis xyz=\"0 1 0\"/>") +
      JointText("laser_joint", "fixed", "base_link", "laser", Origin("0.2 0 0.15")) +
      JointText("camera_joint", "fixed", "base_link", "camera", Origin("0.1 0 0.9", "0 0.2 0")) +
      JointText("camera_optical_joint", "fixed", "camera", "camera_optical_frame",
                Origin("0 0 0", "-1.5708 0 -1.5708")) +
      "<gazebo reference=\"laser\"><sensor name=\"scan\" type=\"gpu_ray\"><update_rate>15"
      "</update_rate><ray><scan><horizontal><samples>270</samples><min_angle>-2.3</min_angle>"
      "<max_angle>2.3</max_angle></horizontal></scan><range><min>0.1</min><max>12</max></range>"
      "<noise><type>gaussian</type><stddev>0.01</stddev></noise></ray></sensor></gazebo>\n"
      "<gazebo reference=\"camera\"><sensor name=\"rgbd\" type=\"rgbd_camera\"><camera>"
      "<horizontal_fov>1.0</horizontal_fov><image><width>640</width><height>480</height></image>"
      "<clip><near>0.3</near><far>6</far></clip></camera></sensor></gazebo>\n");
}

// A base that is turned on its footprint, wheels whose joints are turned, and a sensor turned on a
// mount that is turned: no two frames are parallel.
inline std::string TurnedRobot() {
  const auto wheel = [](const std::string& name, const std::string& xyz) {
    return LinkText(name, Shape("<cylinder radius=\"0.1\" length=\"0.04\"/>")) +
           JointText(name + "_joint", "continuous", "base_link", name,
                     Origin(xyz, "-1.5707963267948966 0 0") + "<axis xyz=\"0 0 1\"/>");
  };
  const std::string inertial =
      "<inertial><mass value=\"7\"/><inertia ixx=\"4\" ixy=\"0.1\" ixz=\"0.2\" iyy=\"5\" "
      "iyz=\"0.3\" izz=\"6\"/></inertial>";
  return Robot(LinkText("base_footprint") + LinkText("base_link", inertial) + LinkText("mount") +
               JointText("base_joint", "fixed", "base_footprint", "base_link",
                         Origin("1 2 0.1", "0 0 0.5")) +
               JointText("mount_joint", "fixed", "base_link", "mount",
                         Origin("0.1 0.2 0.3", "0.1 0.2 0.3")) +
               wheel("left_wheel", "0 0.2 0") + wheel("right_wheel", "0 -0.2 0") +
               "<gazebo reference=\"mount\"><sensor name=\"eye\" type=\"camera\">"
               "<pose>0.1 0.2 0.3 0.1 0.2 0.3</pose></sensor></gazebo>\n");
}

}  // namespace lares::testing
