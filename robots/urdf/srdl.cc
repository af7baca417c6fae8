#include "robots/urdf/srdl.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/text.h"
#include "robots/urdf/infer.h"
#include "robots/urdf/turtle_text.h"

namespace lares::urdf {
namespace {

using Kind = Sensor::Kind;

// The document while it is written: names of what it describes, nodes that more is added to.
struct Writing {
  const Model& model;
  const Kinematics& kinematics;
  const Body& body;
  const SrdlOptions& options;
  Names names;
  std::string robot_class, robot;
  std::vector<std::string> links, joints, poses;  // names, by index; poses by link
  std::vector<Node> link_nodes;
  std::string more;  // nodes of parts that are neither links nor joints
};

std::string Numbers(const Eigen::Vector3d& vector) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const std::string number = Double(vector[i]);
    text += (i == 0 ? "" : " ") + number.substr(1, number.find('"', 1) - 1);
  }
  return text;
}

// A local name's beginning with an upper-case letter.
std::string ClassName(std::string id) {
  id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(id[0])));
  return id;
}

std::string PoseText(const std::string& name, const std::string& relative_to,
                     const RigidTransform& pose) {
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  std::string text = name + " a owl:NamedIndividual , lares:RotationMatrix3D";
  if (!relative_to.empty()) text += " ;\n    lares:relativeTo " + relative_to;
  for (int row = 0; row < 4; ++row) {
    text += " ;\n    ";
    for (int column = 0; column < 4; ++column) {
      double value = row == column ? 1 : 0;
      if (row < 3) value = column < 3 ? rotation(row, column) : pose.translation_m[row];
      text += (column == 0 ? "" : " ; ") + std::string("lares:m") + std::to_string(row) +
              std::to_string(column) + " " + Double(value);
    }
  }
  return text + " .\n\n";
}

void TakeNames(Writing& writing) {
  const auto taken = [&](const std::string& name) { return writing.names.Take(name); };
  for (const Link& link : writing.model.links) writing.links.push_back(taken(link.name));
  for (const Joint& joint : writing.model.joints) writing.joints.push_back(taken(joint.name));
  for (const Link& link : writing.model.links) {
    writing.poses.push_back(taken("pose_of_" + link.name));
  }
  writing.robot_class = taken(ClassName(writing.options.id));
  writing.robot = taken(writing.options.id + "_robot");
}

void AddInertial(const Inertial& inertial, Node& node) {
  node.AddDouble("lares:mass_kg", inertial.mass_kg);
  node.AddText("lares:centreOfMass_m", Numbers(inertial.link_from_inertial.translation_m));
  if (!inertial.inertia_kg_m2) return;
  const Eigen::Matrix3d& i = *inertial.inertia_kg_m2;
  node.AddText("lares:inertia_kg_m2",
               Numbers({i(0, 0), i(0, 1), i(0, 2)}) + " " + Numbers({i(1, 1), i(1, 2), i(2, 2)}));
}

void BeginLinks(Writing& writing) {
  for (std::size_t i = 0; i < writing.model.links.size(); ++i) {
    const Link& link = writing.model.links[i];
    Node node(writing.links[i]);
    node.Add("a", "owl:NamedIndividual").Add("a", "lares:UrdfLink");
    node.AddText("lares:urdfName", link.name);
    if (link.inertial) AddInertial(*link.inertial, node);
    for (const int joint : link.child_joints) {
      node.Add("lares:succeedingJoint", writing.joints[At(joint)]);
    }
    writing.link_nodes.push_back(std::move(node));
  }
}

std::string JointClass(Joint::Kind kind) {
  std::string name(ToString(kind));
  return "lares:" + ClassName(name) + "UrdfJoint";
}

std::string JointText(const Writing& writing, std::size_t index) {
  const Joint& joint = writing.model.joints[index];
  Node node(writing.joints[index]);
  node.Add("a", "owl:NamedIndividual").Add("a", JointClass(joint.kind));
  node.AddText("lares:urdfName", joint.name);
  node.Add("lares:succeedingLink", writing.links[At(joint.child)]);
  node.Add("lares:orientation", writing.poses[At(joint.child)]);
  if (Moves(joint)) node.AddText("lares:jointAxis", Numbers(joint.axis));
  if (joint.lower) node.AddDouble("lares:minJointPosition", *joint.lower);
  if (joint.upper) node.AddDouble("lares:maxJointPosition", *joint.upper);
  if (joint.effort) node.AddDouble("lares:maxJointEffort", *joint.effort);
  if (joint.velocity) node.AddDouble("lares:maxJointVelocity", *joint.velocity);
  node.AddText("lares:mimickedJoint", joint.mimic);
  // Poses are relative to that of the link before; the root has none.
  const bool at_root = writing.model.links[At(joint.parent)].parent_joint < 0;
  return node.Text() + PoseText(writing.poses[At(joint.child)],
                                at_root ? "" : writing.poses[At(joint.parent)],
                                joint.parent_from_child);
}

// --- Conclusions ---

void AddBase(Writing& writing) {
  const Base& base = writing.body.base;
  Node& node = writing.link_nodes[At(base.link)];
  const char* kind = nullptr;
  if (base.kind == BaseKind::kDifferential) kind = "lares:DifferentialBase";
  if (base.kind == BaseKind::kHolonomic) kind = "lares:HolonomicBase";
  if (base.kind == BaseKind::kTracked) kind = "lares:TrackedBase";
  if (base.kind == BaseKind::kWheeled) kind = "lares:WheeledBase";
  if (base.kind == BaseKind::kFixed) kind = "lares:Base";
  if (kind == nullptr) return;
  node.Add("a", kind);
  node.Add("rdfs:comment",
           English("base, " + std::string(ToString(base.kind)) + ": " + base.reason));
}

bool IsTilted(const Writing& writing, const Sensor& sensor) {
  const std::vector<int> joints = JointsTo(writing.model, sensor.link);
  return std::any_of(joints.begin(), joints.end(), [&](int joint) {
    const double upright = std::abs(AxisInRoot(writing.model, writing.kinematics, joint).z());
    return Turns(writing.model.joints[At(joint)]) && upright < 0.3;
  });
}

std::string CameraClass(const Sensor& sensor) {
  if (sensor.monochrome) return "lares:MonochromeCamera";
  const bool has_colours =
      !sensor.type.empty() || HasWord(sensor.frame + " " + sensor.name, {"rgb", "color", "colour"});
  return has_colours ? "lares:ColorCamera" : "lares:Camera";
}

std::string SensorClass(const Writing& writing, const Sensor& sensor) {
  switch (sensor.kind) {
    case Kind::kCamera:
      return CameraClass(sensor);
    case Kind::kDepthCamera:
      return "lares:DepthCamera";
    case Kind::kRgbdCamera:
      return "lares:RGBDCamera";
    case Kind::kStereoCamera:
      return "lares:StereoCamera";
    case Kind::kLaser2d:
      return IsTilted(writing, sensor) ? "lares:Tilting2DLaserScanner"
                                       : "lares:TwoDimensionalLaserScanner";
    case Kind::kLaser3d:
      return "lares:ThreeDimensionalLaserScanner";
    case Kind::kSonar:
      return "lares:SonarSensor";
    case Kind::kBumper:
      return "lares:BumperSensor";
    case Kind::kInertial:
      return "lares:InertialSensor";
    case Kind::kForceTorque:
      return "lares:ForceTorqueSensor";
    case Kind::kOther:
      return "lares:Sensor";
  }
  return "lares:Sensor";
}

// Square pixels: the image's shape is that of the view.
std::optional<double> VerticalView(const Sensor& sensor) {
  if (!sensor.hfov_rad || !sensor.width_px || !sensor.height_px) return std::nullopt;
  if (*sensor.width_px < 1 || *sensor.hfov_rad <= 0 || *sensor.hfov_rad >= M_PI)
    return std::nullopt;
  return 2 * std::atan(std::tan(*sensor.hfov_rad / 2) * *sensor.height_px / *sensor.width_px);
}

void AddCount(const char* predicate, const std::optional<double>& value, Node& node) {
  if (!value || !(*value >= 0 && *value < 1e9)) return;
  node.Add(predicate, std::to_string(static_cast<long>(*value)));
}

void AddSensorValues(const Sensor& sensor, Node& node) {
  const auto add = [&](const char* predicate, const std::optional<double>& value) {
    if (value) node.AddDouble(predicate, *value);
  };
  std::string_view frame = sensor.frame;
  while (frame.starts_with('/')) frame.remove_prefix(1);
  node.AddText("lares:frameName", frame);
  node.AddText("lares:topicName", sensor.topic);
  add("lares:minRange_m", sensor.min_range_m);
  add("lares:maxRange_m", sensor.max_range_m);
  add("lares:nearClip_m", sensor.near_clip_m);
  add("lares:farClip_m", sensor.far_clip_m);
  add("lares:hfov_rad", sensor.hfov_rad);
  add("lares:vfov_rad", VerticalView(sensor));
  add("lares:minAngle_rad", sensor.min_angle_rad);
  add("lares:maxAngle_rad", sensor.max_angle_rad);
  AddCount("lares:beamCount", sensor.beam_count, node);
  AddCount("lares:imageWidth_px", sensor.width_px, node);
  AddCount("lares:imageHeight_px", sensor.height_px, node);
  add("lares:rate_hz", sensor.rate_hz);
  if (!IsCamera(sensor.kind)) add("lares:rangeNoise_m", sensor.noise);
}

bool SitsOnLink(const Sensor& sensor) {
  return sensor.link_from_sensor.translation_m.norm() < 1e-9 &&
         sensor.link_from_sensor.rotation.angularDistance(Eigen::Quaterniond::Identity()) < 1e-9;
}

// The link itself is the sensor, as in our own models; a second one on it, or one that sits beside
// the link's origin, gets a link of its own.
void AddSensors(Writing& writing) {
  std::vector<bool> is_sensor(writing.model.links.size());
  for (const BodySensor& placed : writing.body.sensors) {
    const Sensor& sensor = placed.sensor;
    Node* node = &writing.link_nodes[At(sensor.link)];
    Node own("");
    std::string joint_text;
    if (is_sensor[At(sensor.link)] || !SitsOnLink(sensor)) {
      const std::string name = writing.names.Take(sensor.name + "_sensor");
      const std::string joint = writing.names.Take(sensor.name + "_sensor_joint");
      const std::string pose = writing.names.Take("pose_of_" + sensor.name + "_sensor");
      node->Add("lares:succeedingJoint", joint);
      own = Node(name);
      own.Add("a", "owl:NamedIndividual").Add("a", "lares:UrdfLink");
      Node mount(joint);
      mount.Add("a", "owl:NamedIndividual").Add("a", "lares:FixedUrdfJoint");
      mount.Add("lares:succeedingLink", name).Add("lares:orientation", pose);
      const bool at_root = writing.model.links[At(sensor.link)].parent_joint < 0;
      joint_text = mount.Text() + PoseText(pose, at_root ? "" : writing.poses[At(sensor.link)],
                                           sensor.link_from_sensor);
      node = &own;
    } else {
      is_sensor[At(sensor.link)] = true;
    }
    node->Add("a", SensorClass(writing, sensor));
    node->Add("rdfs:comment", English(sensor.reason));
    AddSensorValues(sensor, *node);
    if (node == &own) writing.more += own.Text() + joint_text;
  }
}

std::string Sided(const std::string& side, const std::string& noun) {
  return side.empty() ? noun : side + " " + noun;
}

void AddGrippers(Writing& writing, Node& robot) {
  for (const Gripper& gripper : writing.body.grippers) {
    const std::string name = Sided(gripper.side, "gripper");
    Node node(writing.names.Take(gripper.side.empty() ? "gripper" : gripper.side + "_gripper"));
    const bool is_hand = gripper.fingers.size() >= 4;
    node.Add("a", "owl:NamedIndividual");
    node.Add("a", is_hand ? "lares:HandComponent" : "lares:GripperComponent");
    node.Add("a", "lares:ComponentComposition");
    node.Add("rdfs:label", English(name)).Add("rdfs:comment", English(gripper.reason));
    node.Add("lares:baseLinkOfComposition", writing.links[At(gripper.palm)]);
    for (const int finger : gripper.fingers) {
      node.Add("lares:endLinkOfComposition", writing.links[At(finger)]);
    }
    const std::string text = node.Text();
    robot.Add("lares:subComponent", text.substr(0, text.find(' ')));
    writing.more += text;
  }
}

void AddArms(Writing& writing, Node& robot) {
  for (const Arm& arm : writing.body.arms) {
    Node node(writing.names.Take(arm.side.empty() ? "arm" : arm.side + "_arm"));
    node.Add("a", "owl:NamedIndividual").Add("a", "lares:ArmComponent");
    node.Add("a", "lares:ComponentComposition");
    node.Add("rdfs:label", English(Sided(arm.side, "arm")));
    node.Add("rdfs:comment",
             English(arm.reason + "; reach: the sum of the distances between its joints"));
    node.Add("lares:baseLinkOfComposition", writing.links[At(arm.base_link)]);
    node.Add("lares:endLinkOfComposition", writing.links[At(arm.end_link)]);
    node.AddDouble("lares:reach_m", arm.reach_m);
    const std::string text = node.Text();
    robot.Add("lares:subComponent", text.substr(0, text.find(' ')));
    writing.more += text;
  }
}

void AddHeadsAndTorsos(Writing& writing) {
  for (const Head& head : writing.body.heads) {
    Node& node = writing.link_nodes[At(head.link)];
    node.Add("a", "lares:PanTiltUnit")
        .Add("rdfs:comment", English("pan-tilt unit: " + head.reason));
  }
  for (const Torso& torso : writing.body.torsos) {
    Node& node = writing.link_nodes[At(torso.link)];
    node.Add("a", "lares:Torso").Add("rdfs:comment", English("torso: " + torso.reason));
  }
}

void AddStated(Writing& writing, Node& robot) {
  for (const StatedComponent& stated : writing.options.stated) {
    Node node(writing.names.Take("stated_" + std::string(LocalName(stated.class_iri))));
    node.Add("a", "owl:NamedIndividual").Add("a", Term(stated.class_iri));
    node.Add("rdfs:label", English(stated.label));
    node.Add("rdfs:comment", English("stated by whoever put the robot here; no URDF tells of it"));
    const std::string text = node.Text();
    robot.Add("lares:subComponent", text.substr(0, text.find(' ')));
    writing.more += text;
  }
}

void AddMeasures(const Writing& writing, Node& robot) {
  const Body& body = writing.body;
  // What may be larger is not stated as the robot's size: whoever reads it would clear too little.
  if (body.footprint && body.footprint->is_lower_bound) {
    robot.AddDouble("lares:minFootprintRadius_m", body.footprint->radius_m);
    robot.Add("rdfs:comment", English("footprint: " + body.footprint->reason));
  } else if (body.footprint) {
    std::string polygon;
    for (const Eigen::Vector2d& corner : body.footprint->polygon_m) {
      const std::string numbers = Numbers({corner.x(), corner.y(), 0});
      polygon += (polygon.empty() ? "" : ", ") + numbers.substr(0, numbers.rfind(' '));
    }
    robot.AddDouble("lares:footprintLength_m", body.footprint->length_m);
    robot.AddDouble("lares:footprintWidth_m", body.footprint->width_m);
    robot.AddDouble("lares:footprintRadius_m", body.footprint->radius_m);
    robot.AddText("lares:footprintPolygon_m", polygon);
    robot.Add("rdfs:comment", English("footprint: " + body.footprint->reason));
  }
  if (body.height) {
    robot.AddDouble(body.height->is_lower_bound ? "lares:minBodyHeight_m" : "lares:bodyHeight_m",
                    body.height->height_m);
    robot.Add("rdfs:comment", English("height: " + body.height->reason));
  }
  if (body.mass_kg > 0) robot.AddDouble("lares:mass_kg", body.mass_kg);
  for (const std::string& note : body.notes) robot.Add("rdfs:comment", English(note));
}

std::string Preamble(const Writing& writing, const std::string& label) {
  const SrdlOptions& options = writing.options;
  const std::string document = "https://w3id.org/lares/robots/" + options.id;
  return "# Made from " + Quoted(options.source) + ", SHA-256 " + options.sha256 +
         ".\n@prefix : <" + document +
         "#> .\n@prefix lares: <https://w3id.org/lares#> .\n"
         "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
         "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
         "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n\n<" +
         document + "> a owl:Ontology ;\n    rdfs:label " + English(label) +
         " ;\n    rdfs:comment " +
         English("The robot " + label +
                 " as its URDF describes it: " + std::to_string(writing.model.links.size()) +
                 " links and " + std::to_string(writing.model.joints.size()) + " joints.") +
         " ;\n    owl:imports <https://w3id.org/lares/components> , "
         "<https://w3id.org/lares/capabilities> .\n\n";
}

bool IsMobile(BaseKind kind) {
  return kind == BaseKind::kDifferential || kind == BaseKind::kHolonomic ||
         kind == BaseKind::kTracked || kind == BaseKind::kWheeled;
}

}  // namespace

std::string ToSrdl(const Model& model, const Kinematics& kinematics, const Body& body,
                   const SrdlOptions& options) {
  Writing writing{model, kinematics, body, options, {}, {}, {}, {}, {}, {}, {}, {}};
  const std::string label = options.label.empty() ? model.name : options.label;
  TakeNames(writing);
  BeginLinks(writing);
  Node kind(writing.robot_class);
  kind.Add("a", "owl:Class").Add("rdfs:label", English("robots of the kind " + label));
  kind.Add("rdfs:subClassOf", IsMobile(body.base.kind) ? "lares:MobileRobot" : "lares:Robot");
  Node robot(writing.robot);
  robot.Add("a", "owl:NamedIndividual").Add("a", writing.robot_class);
  robot.Add("rdfs:label", English(label));
  AddMeasures(writing, robot);
  robot.Add("lares:succeedingLink", writing.links[At(model.root)]);
  if (body.base_frame != model.root) {
    robot.Add("lares:baseFrameLink", writing.links[At(body.base_frame)]);
  }
  AddBase(writing);
  AddHeadsAndTorsos(writing);
  AddSensors(writing);
  AddArms(writing, robot);
  AddGrippers(writing, robot);
  AddStated(writing, robot);
  std::string text = Preamble(writing, label) + "# --- The robot ---\n\n" + kind.Text() +
                     robot.Text() + "# --- Parts ---\n\n" + writing.more + "# --- Links ---\n\n";
  for (const int link : kinematics.order) text += writing.link_nodes[At(link)].Text();
  text +=
      "# --- Joints; the pose of each is that of the link it moves, seen from the link before "
      "---\n\n";
  for (const int link : kinematics.order) {
    for (const int joint : model.links[At(link)].child_joints)
      text += JointText(writing, At(joint));
  }
  return text;
}

}  // namespace lares::urdf
