// Poses as matrices in RDF, chained by relativeTo up to the map.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/rigid_transform.h"
#include "mapping/semantic/names.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// Where a matrix puts its frame.
struct FramePose {
  std::optional<RigidTransform> map_from_frame;  // nothing: relative to what has no pose
  std::vector<std::string> remarks;
};

// True for what has matrix entries or is a RotationMatrix3D.
bool IsMatrix(const rdf::View& view, const Names& names, rdf::TermId term);

// Remembers what it resolved. `view` and `names` must outlive it.
class Frames {
 public:
  // `matrices` are the pose matrices of objects: a frame may be relative to an object.
  Frames(const rdf::View& view, const Names& names, std::map<rdf::TermId, rdf::TermId> matrices);

  // Throws kInvalid as ReadMapObjects does, kTooLarge for a chain of more than 256 frames.
  const FramePose& Resolve(rdf::TermId matrix);

 private:
  FramePose Compute(rdf::TermId matrix);
  FramePose Read(rdf::TermId matrix) const;
  Eigen::Matrix4d ReadEntries(rdf::TermId matrix) const;
  std::optional<rdf::TermId> Base(rdf::TermId matrix) const;
  bool HasType(rdf::TermId term, rdf::TermId type) const;
  [[noreturn]] void FailOnCircle(rdf::TermId matrix) const;

  const rdf::View& view_;
  const Names& names_;
  std::map<rdf::TermId, rdf::TermId> matrices_;
  std::map<rdf::TermId, FramePose> resolved_;
  std::vector<rdf::TermId> path_;  // being resolved, each relative to the next
};

}  // namespace lares::semantic
