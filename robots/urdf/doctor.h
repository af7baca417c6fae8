// What a simulator, a navigation stack or a planner would stumble over in a URDF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ontology/triples/dictionary.h"
#include "ontology/triples/graph.h"
#include "robots/urdf/finding.h"
#include "robots/urdf/limits.h"
#include "robots/urdf/model.h"

namespace lares::urdf {

// A robot's SRDL to compare with; what `graph` is made of.
struct SrdlToCompare {
  const rdf::Graph& graph;
  const rdf::Dictionary& dictionary;
  std::string name;  // for the messages
};

struct CompareOptions {
  double distance_m = 0.001;  // joints that are further off differ
  double angle_rad = 0.01;    // likewise
};

// Everything that is found, by line: what cannot be read is one finding (or a few) and the end of
// it; else frames (REP-103, REP-105), units, inertia, limits and sensors. Throws only kInternal.
std::vector<Finding> Examine(std::string_view bytes, const std::string& source,
                             const SrdlToCompare* srdl = nullptr, const Limits& limits = {});

// The steps of it.
void ExamineFrames(const Model& model, const std::string& source, std::vector<Finding>& findings);
void ExamineDynamics(const Model& model, const std::string& source, std::vector<Finding>& findings);
void ExamineSensors(const Model& model, const std::string& source, std::vector<Finding>& findings);
// Links and joints (by urdfName) that only one of the two has, joints of another kind and poses
// that differ.
void CompareWithSrdl(const Model& model, const SrdlToCompare& srdl, const CompareOptions& options,
                     const std::string& source, std::vector<Finding>& findings);

}  // namespace lares::urdf
