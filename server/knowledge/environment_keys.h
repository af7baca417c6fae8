// What an environment is found by, out of its semantic map.
#pragma once

#include <vector>

#include "mapping/semantic/map_object.h"
#include "ontology/triples/view.h"
#include "server/store/store.h"

namespace lares::server {

// `view` is that of a semantic layer, closed; `objects` are those of ReadMapObjects.
std::vector<store::SearchKey> KeysOf(const rdf::View& view,
                                     const std::vector<semantic::MapObject>& objects);

}  // namespace lares::server
