// What an environment can be found by, out of its semantic map.
#pragma once

#include <string>
#include <vector>

#include "mapping/semantic/map_object.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// Each list is sorted and holds everything once. Texts are as written; classes are canonical IRIs,
// those that follow included (a DrinkingBottle is a Bottle, a Container, …).
struct PlaceFacts {
  std::vector<std::string> room_numbers;   // of the places that the map describes, and their rooms
  std::vector<std::string> levels;         // floor numbers of storeys, names of those without
  std::vector<std::string> buildings;      // names and street numbers of buildings
  std::vector<std::string> streets;        // names
  std::vector<std::string> cities;         // names
  std::vector<std::string> place_classes;  // of the outermost places that the map describes
  std::vector<std::string> held_classes;   // of all that is mapped there, rooms of a flat included
  std::vector<std::string> map_classes;    // of the maps: SemanticEnvironmentMap, OctoMap, …
};

// Of the view's top layer, read against the whole view, which should be closed; `objects` are those
// of ReadMapObjects.
//
// The places that a map describes are those with describedInMap; without any, the innermost places
// of the layer. Storey, building, street and city are what these are part of, whole by whole:
// properPhysicalParts leads from the city to the room, and where a document has it the other way
// round (RoboEarth's first maps) that is understood. A place that is connected to none is taken to
// be in those that the layer names.
PlaceFacts ReadPlaceFacts(const rdf::View& view, const std::vector<MapObject>& objects);

}  // namespace lares::semantic
