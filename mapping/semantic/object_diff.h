// What changed between two states of a semantic map.
#pragma once

#include <string>
#include <vector>

#include "mapping/semantic/map_object.h"

namespace lares::semantic {

struct MovedObject {
  MapObject before, after;
  double distance_m = 0;  // between the middles
  double angle_rad = 0;   // of the rotation from one to the other, 0 to π
};

// An object by its IRI. One may be both moved and re-classed.
struct ObjectDiff {
  std::vector<MapObject> added;
  std::vector<MapObject> gone;
  std::vector<MovedObject> moved;
  // Of another class.
  struct Reclassed {
    MapObject before, after;
  };
  std::vector<Reclassed> reclassed;
  // Gone and new, but of one class, and no further apart than the tolerance: likely the same thing
  // under another name.
  struct Renamed {
    MapObject before, after;
    double distance_m = 0;
  };
  std::vector<Renamed> renamed;
  std::size_t same = 0;
};

struct DiffTolerance {
  double distance_m = 0.01;   // what is less is no move
  double angle_rad = 0.0175;  // 1°
  double renamed_m = 0.3;     // how far apart one thing under two names may be
};

// By IRI in each list. An object that has a pose in one of the two only is moved by NaN.
ObjectDiff DiffObjects(const std::vector<MapObject>& before, const std::vector<MapObject>& after,
                       const DiffTolerance& tolerance = {});

}  // namespace lares::semantic
