// Versions of environments compared, taken back and brought together.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mapping/grid/grid_diff.h"
#include "mapping/semantic/object_diff.h"
#include "ontology/rdf/three_way_merge.h"
#include "server/knowledge/knowledge.h"

namespace lares::server {

struct LayerDiff {
  enum class Kind { kSame, kAdded, kRemoved, kChanged };
  std::string name;
  Kind kind = Kind::kSame;
  std::optional<store::Blob> before, after;
};

struct VersionDiff {
  store::EnvironmentVersion before, after;
  std::vector<LayerDiff> layers;  // of either version, by name
  semantic::ObjectDiff objects;
  std::optional<grid::GridDiff> grid;  // when both have a grid layer, and it changed
  std::string grid_problem;            // why there is none though both have one
};

// Throws kNotFound.
VersionDiff DiffVersions(Knowledge& knowledge, const std::string& environment, int before,
                         int after, const semantic::DiffTolerance& tolerance = {});

// Who asks for it, and why.
struct VersionBy {
  std::string author, robot, mission, note;
  std::string if_match;  // as in store::NewVersion
};

// A new head with the layers, type and label of an older version.
Knowledge::VersionAnswer RollBack(Knowledge& knowledge, const std::string& environment, int to,
                                  const VersionBy& by);

// A layer that both versions changed, other than the semantic one: whole or not at all.
struct LayerConflict {
  std::string layer;
  std::optional<store::Blob> base, ours, theirs;  // nothing: it is not there
};

struct MergeRequest {
  std::string environment;
  int ours = 0;  // 0: the head
  int theirs = 0;
  VersionBy by;
  bool dry_run = false;
  // What decides conflicts: by name of a layer or IRI of a subject, else `otherwise`.
  std::map<std::string, rdf::Side> take;
  std::optional<rdf::Side> otherwise;
};

struct MergeAnswer {
  int base = 0;  // the nearest version that both come from; 0: there is none
  int ours = 0, theirs = 0;
  std::vector<LayerConflict> layer_conflicts;
  std::vector<rdf::MergeConflict> conflicts;  // of the semantic layer
  bool up_to_date = false;  // theirs is part of ours already: nothing is to be done
  // Set when there is no conflict left and it was no dry run.
  std::optional<Knowledge::VersionAnswer> merged;
};

// The head becomes a version with two parents: what either side changed since the nearest version
// that both come from. With conflicts that nothing decides, none is made. Throws kNotFound,
// kInvalid when `ours` is not the head, and as Knowledge::PutVersion.
MergeAnswer MergeVersions(Knowledge& knowledge, const MergeRequest& request);

// The highest version that both come from, one of the two themselves included; 0: none.
int NearestCommonVersion(const std::vector<store::EnvironmentVersion>& log, int a, int b);

}  // namespace lares::server
