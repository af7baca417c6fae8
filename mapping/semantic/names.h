// The terms that semantic maps are written in, as ids.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "ontology/rdf/vocabulary.h"
#include "ontology/triples/dictionary.h"

namespace lares::semantic {

struct Names {
  explicit Names(rdf::Dictionary& dictionary);

  rdf::TermId type, sub_class_of, owl_class, named_individual, thing;
  rdf::TermId map, semantic_environment_map, rotation_matrix, map_object;
  rdf::TermId semantic_map_perception, visual_perception;
  rdf::TermId object_acted_on, event_occurs_at, start_time, described_in_map, orientation;
  rdf::TermId relative_to, stands_for, recognized_using_model;
  rdf::TermId label, place, room, storey, building, street, city;
  rdf::TermId room_number, floor_number, street_number;
  rdf::TermId proper_parts, proper_part_of, inside_room;
  rdf::TermId depth, width, height, existence_probability, first_seen, last_seen;
  std::array<std::array<rdf::TermId, 4>, 4> matrix_entry;  // m00 … m33
};

}  // namespace lares::semantic
