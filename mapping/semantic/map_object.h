// The objects of a semantic map, read from its RDF.
#pragma once

#include <array>
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
  std::string class_iri;  // the most specific class asserted of it; empty when there is none
  std::string class_as_written;
  std::optional<RigidTransform> map_from_object;  // the object's frame is in its middle
  std::optional<Eigen::Vector3d> extent_m;        // x depth, y width, z height
  std::optional<double> existence;                // probability
  std::optional<Time> first_seen, last_seen;
  std::string recognised_with;  // IRI of the object model
  // IRIs; empty when there is none. What is part of a part of a room is in the room; what a map
  // describes, and nothing says more of, belongs to the map alone.
  std::string part_of;            // the nearest whole
  std::string room;               // the nearest room that it is in or part of
  std::vector<std::string> maps;  // that describe it, or else its nearest whole that is described
  // What was odd and how it was taken, a sentence each.
  std::vector<std::string> remarks;
};

// Every object that the graphs of the view's top layer perceive (SemanticMapPerception), describe
// in a map (describedInMap), give a pose (orientation) or enter as a MapObject, and what they make
// a part of one (properPhysicalParts) if it has a class and is no place; by IRI. What is said of
// them is read from the whole view.
//
// Matrices are 4×4, m03, m13 and m23 the position in metres; `relativeTo` chains them up to the
// map; an object whose chain ends in something without a pose has none. An extent of three zeros
// is none. A matrix that is orthogonal but mirrors (left-handed frames are found in old maps) has
// its y axis reversed, with a remark. Times are dateTimes, or TimePoints whose name ends in
// "_<Unix seconds>".
//
// Throws kInvalid naming object, matrix and entry for a pose with NaN, without rotation, with
// entries missing, doubled or no numbers, or frames relative to one another in a circle; and naming
// object and property for sizes, probabilities and times that are none.
std::vector<MapObject> ReadMapObjects(const rdf::View& view);

// The box around all objects that have a pose (min x y z, max x y z); nothing when none has.
std::optional<std::array<double, 6>> BoundsOf(const std::vector<MapObject>& objects);

}  // namespace lares::semantic
