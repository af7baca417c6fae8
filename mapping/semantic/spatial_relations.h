// What stands on what and what lies in what, from poses and extents.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mapping/semantic/map_object.h"

namespace lares::semantic {

struct SpatialRelation {
  enum class Kind { kOn, kIn };
  Kind kind = Kind::kOn;
  std::string thing;  // IRI
  std::string other;

  friend auto operator<=>(const SpatialRelation&, const SpatialRelation&) = default;
};

struct RelationOptions {
  double touch_m = 0.05;   // a thing rests on another when their faces are at most so far apart
  double inside_m = 0.02;  // a thing is in another though it sticks out by so much
  std::size_t max_pairs = 5'000'000;  // pairs looked at
  std::size_t max_relations = 200'000;

  void Check() const;  // throws kInvalid naming the field
};

struct RelationsFound {
  std::vector<SpatialRelation> relations;  // sorted
  bool complete = true;                    // false: a limit was reached, and `relations` is empty
};

// Between objects that have a pose and an extent, by their boxes along the axes of the map, z up.
// `on`: the lower face is at the other's upper face and its middle over it. `in`: the whole box is
// in the other's, which is larger.
RelationsFound FindSpatialRelations(const std::vector<MapObject>& objects,
                                    const RelationOptions& options = {});

}  // namespace lares::semantic
