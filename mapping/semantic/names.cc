#include "mapping/semantic/names.h"

namespace lares::semantic {
namespace {

rdf::TermId In(rdf::Dictionary& dictionary, std::string_view space, std::string_view local) {
  return dictionary.InternIri(std::string(space).append(local));
}

}  // namespace

Names::Names(rdf::Dictionary& dictionary) {
  const auto lares = [&](std::string_view local) { return In(dictionary, rdf::kLares, local); };
  type = In(dictionary, rdf::kRdf, "type");
  sub_class_of = In(dictionary, rdf::kRdfs, "subClassOf");
  owl_class = In(dictionary, rdf::kOwl, "Class");
  named_individual = In(dictionary, rdf::kOwl, "NamedIndividual");
  thing = In(dictionary, rdf::kOwl, "Thing");
  map = lares("Map");
  semantic_environment_map = lares("SemanticEnvironmentMap");
  rotation_matrix = lares("RotationMatrix3D");
  map_object = lares("MapObject");
  semantic_map_perception = lares("SemanticMapPerception");
  visual_perception = lares("VisualPerception");
  object_acted_on = lares("objectActedOn");
  event_occurs_at = lares("eventOccursAt");
  start_time = lares("startTime");
  described_in_map = lares("describedInMap");
  orientation = lares("orientation");
  relative_to = lares("relativeTo");
  stands_for = lares("standsFor");
  recognized_using_model = lares("recognizedUsingModel");
  label = In(dictionary, rdf::kRdfs, "label");
  place = lares("Place");
  room = lares("Room");
  storey = lares("Storey");
  building = lares("Building");
  street = lares("Street");
  city = lares("City");
  room_number = lares("roomNumber");
  floor_number = lares("floorNumber");
  street_number = lares("streetNumber");
  proper_parts = lares("properPhysicalParts");
  proper_part_of = lares("properPhysicalPartOf");
  inside_room = lares("insideRoom");
  depth = lares("depthOfObject");
  width = lares("widthOfObject");
  height = lares("heightOfObject");
  existence_probability = lares("existenceProbability");
  first_seen = lares("firstSeen");
  last_seen = lares("lastSeen");
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      matrix_entry[row][column] = lares("m" + std::to_string(row) + std::to_string(column));
    }
  }
}

}  // namespace lares::semantic
