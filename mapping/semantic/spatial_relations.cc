#include "mapping/semantic/spatial_relations.h"

#include <algorithm>

#include "base/error.h"

namespace lares::semantic {
namespace {

struct Box {
  const MapObject* object = nullptr;
  Eigen::AlignedBox3d bounds_in_map;
};

// Around the turned extent of an object, whose frame is in its middle.
Box BoxOf(const MapObject& object) {
  const Eigen::Matrix3d turned = object.map_from_object->rotation.toRotationMatrix().cwiseAbs();
  const Eigen::Vector3d half = turned * *object.extent_m / 2;
  const Eigen::Vector3d& middle = object.map_from_object->translation_m;
  return {&object, Eigen::AlignedBox3d(middle - half, middle + half)};
}

bool IsOn(const Box& thing, const Box& other, double touch_m) {
  const Eigen::Vector3d middle = thing.bounds_in_map.center();
  const Eigen::Vector3d& low = other.bounds_in_map.min();
  const Eigen::Vector3d& high = other.bounds_in_map.max();
  return std::abs(thing.bounds_in_map.min().z() - high.z()) <= touch_m && middle.z() > high.z() &&
         middle.x() >= low.x() && middle.x() <= high.x() && middle.y() >= low.y() &&
         middle.y() <= high.y();
}

bool IsIn(const Box& thing, const Box& other, double inside_m) {
  Eigen::AlignedBox3d room = other.bounds_in_map;
  room.min().array() -= inside_m;
  room.max().array() += inside_m;
  return room.contains(thing.bounds_in_map) &&
         thing.bounds_in_map.volume() < other.bounds_in_map.volume() &&
         !thing.bounds_in_map.contains(other.bounds_in_map);
}

// The boxes in order along x: those that overlap there are compared, no others.
std::vector<Box> BoxesAlongX(const std::vector<MapObject>& objects) {
  std::vector<Box> boxes;
  for (const MapObject& object : objects) {
    if (object.map_from_object && object.extent_m) boxes.push_back(BoxOf(object));
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return a.bounds_in_map.min().x() < b.bounds_in_map.min().x();
  });
  return boxes;
}

}  // namespace

void RelationOptions::Check() const {
  const auto refuse = [](const char* field) {
    throw Error(Code::kInvalid, std::string(field) + " must be zero or more, and finite");
  };
  if (!(touch_m >= 0 && touch_m < 1e6)) refuse("touch_m");
  if (!(inside_m >= 0 && inside_m < 1e6)) refuse("inside_m");
}

RelationsFound FindSpatialRelations(const std::vector<MapObject>& objects,
                                    const RelationOptions& options) {
  options.Check();
  RelationsFound found;
  const std::vector<Box> boxes = BoxesAlongX(objects);
  std::size_t pairs = 0;
  const auto compare = [&](const Box& thing, const Box& other) {
    if (IsOn(thing, other, options.touch_m)) {
      found.relations.push_back({SpatialRelation::Kind::kOn, thing.object->iri, other.object->iri});
    } else if (IsIn(thing, other, options.inside_m)) {
      found.relations.push_back({SpatialRelation::Kind::kIn, thing.object->iri, other.object->iri});
    }
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double end = boxes[i].bounds_in_map.max().x() + options.inside_m;
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].bounds_in_map.min().x() <= end; ++j) {
      if (++pairs > options.max_pairs || found.relations.size() > options.max_relations) {
        return {{}, false};
      }
      compare(boxes[i], boxes[j]);
      compare(boxes[j], boxes[i]);
    }
  }
  std::sort(found.relations.begin(), found.relations.end());
  return found;
}

}  // namespace lares::semantic
