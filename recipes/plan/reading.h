// What planning takes from a recipe: the same for every robot and place.
#pragma once

#include <string>

#include "ontology/triples/view.h"
#include "reasoner/prolog/engine_pool.h"

namespace lares::recipes {

// A value that hangs on recipe and catalogue alone; it keeps no view.
struct Reading {
  prolog::RecordRef record;  // readings.pl
};

// `view` holds the catalogue and the recipe with those that it nests; it may hold robots. A recipe
// with problems has a reading too: planning tells them.
Reading ReadRecipe(prolog::EnginePool& engines, const rdf::View& view, const std::string& task_iri);

}  // namespace lares::recipes
