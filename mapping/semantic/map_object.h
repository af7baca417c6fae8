// The objects of a semantic map, read from its RDF.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/rigid_transform.h"
#include "base/time.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// A mapped object. Its pose is that of the latest SemanticMapPerception (or its own pose matrix).
struct MapObject {
  std::string iri;
  std::string label;
  std::string class_iri;                  // most specific class
  std::string class_as_written;
  std::optional<RigidTransform> map_from_object;
  std::optional<Eigen::Vector3d> extent_m;  // x depth, y width, z height
  std::optional<double> existence;        // probability
  std::optional<Time> first_seen, last_seen;
  std::string recognised_with;            // IRI of the object model
};

// Every object that the graphs of the view's top layer perceive or describe in a map, by IRI.
// Throws kInvalid naming object and matrix entry for a pose with NaN, without rotation, or with
// entries missing.
std::vector<MapObject> ReadMapObjects(const rdf::View& view);

}  // namespace lares::semantic
