// A robot that was read from URDF as an SRDL document.
#pragma once

#include <string>
#include <vector>

#include "robots/urdf/body.h"
#include "robots/urdf/kinematics.h"
#include "robots/urdf/model.h"

namespace lares::urdf {

// A component that no URDF tells of, such as a program: the user says that the robot has it.
struct StatedComponent {
  std::string class_iri;
  std::string label;
};

struct SrdlOptions {
  std::string id;      // of the document; names its namespace
  std::string label;   // of the robot; empty for the URDF's own name
  std::string source;  // what the URDF was called
  std::string sha256;  // of the URDF's bytes: another URDF is another document
  std::vector<StatedComponent> stated;
};

// Turtle in the style of robots/models: a class of robots, one robot of it, its links and joints
// from the root outwards with poses and limits, and what was concluded, each conclusion with its
// reason as rdfs:comment. Equal input gives equal bytes.
std::string ToSrdl(const Model& model, const Kinematics& kinematics, const Body& body,
                   const SrdlOptions& options);

}  // namespace lares::urdf
