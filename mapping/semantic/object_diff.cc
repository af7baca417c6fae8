#include "mapping/semantic/object_diff.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace lares::semantic {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

struct Motion {
  double distance_m = 0;
  double angle_rad = 0;
};

Motion Between(const MapObject& before, const MapObject& after) {
  if (!before.map_from_object && !after.map_from_object) return {};
  if (!before.map_from_object || !after.map_from_object) return {kNoNumber, kNoNumber};
  return {(after.map_from_object->translation_m - before.map_from_object->translation_m).norm(),
          before.map_from_object->rotation.angularDistance(after.map_from_object->rotation)};
}

// NaN is a move.
bool IsMove(const Motion& motion, const DiffTolerance& tolerance) {
  return !(motion.distance_m <= tolerance.distance_m) || !(motion.angle_rad <= tolerance.angle_rad);
}

void Compare(const MapObject& before, const MapObject& after, const DiffTolerance& tolerance,
             ObjectDiff& diff) {
  const Motion motion = Between(before, after);
  const bool moved = IsMove(motion, tolerance);
  const bool reclassed = before.class_iri != after.class_iri;
  if (moved) diff.moved.push_back({before, after, motion.distance_m, motion.angle_rad});
  if (reclassed) diff.reclassed.push_back({before, after});
  if (!moved && !reclassed) ++diff.same;
}

struct Pair {
  double distance_m = 0;
  std::size_t gone = 0, added = 0;
};

// Pairs the nearest of one class first; what is paired leaves both lists.
void PairRenamed(const DiffTolerance& tolerance, ObjectDiff& diff) {
  std::vector<Pair> pairs;
  for (std::size_t g = 0; g < diff.gone.size(); ++g) {
    for (std::size_t a = 0; a < diff.added.size(); ++a) {
      if (diff.gone[g].class_iri != diff.added[a].class_iri) continue;
      if (!diff.gone[g].map_from_object || !diff.added[a].map_from_object) continue;
      const double distance_m = Between(diff.gone[g], diff.added[a]).distance_m;
      if (distance_m <= tolerance.renamed_m) pairs.push_back({distance_m, g, a});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance_m, a.gone, a.added) < std::tie(b.distance_m, b.gone, b.added);
  });
  std::vector<bool> gone_used(diff.gone.size());
  std::vector<bool> added_used(diff.added.size());
  for (const Pair& pair : pairs) {
    if (gone_used[pair.gone] || added_used[pair.added]) continue;
    gone_used[pair.gone] = added_used[pair.added] = true;
    diff.renamed.push_back({diff.gone[pair.gone], diff.added[pair.added], pair.distance_m});
  }
  const auto drop = [](std::vector<MapObject>& objects, const std::vector<bool>& used) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!used[i] && kept != i) objects[kept] = std::move(objects[i]);
      kept += used[i] ? 0 : 1;
    }
    objects.resize(kept);
  };
  drop(diff.gone, gone_used);
  drop(diff.added, added_used);
}

}  // namespace

ObjectDiff DiffObjects(const std::vector<MapObject>& before, const std::vector<MapObject>& after,
                       const DiffTolerance& tolerance) {
  std::map<std::string, const MapObject*> stood;
  for (const MapObject& object : before) stood[object.iri] = &object;
  ObjectDiff diff;
  std::map<std::string, const MapObject*> stands;
  for (const MapObject& object : after) stands[object.iri] = &object;
  for (const auto& [iri, object] : stands) {
    const auto found = stood.find(iri);
    if (found == stood.end()) {
      diff.added.push_back(*object);
    } else {
      Compare(*found->second, *object, tolerance, diff);
    }
  }
  for (const auto& [iri, object] : stood) {
    if (stands.count(iri) == 0) diff.gone.push_back(*object);
  }
  PairRenamed(tolerance, diff);
  return diff;
}

}  // namespace lares::semantic
