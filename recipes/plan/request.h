// What is asked for with a plan, before the rules see it.
#pragma once

#include <map>
#include <string>

#include "ontology/triples/view.h"
#include "reasoner/prolog/value.h"

namespace lares::recipes {

// What a written value may mean in `view`: for each name (and each part of a list, separated by
// commas) the classes and the individuals that go by it, by IRI, else by local name, else by label;
// several where they go by it equally well. The Prolog form is a list of given{name, text, classes,
// things, items} (parameters.pl).
prolog::Value ToGiven(const rdf::View& view, const std::map<std::string, std::string>& set);

}  // namespace lares::recipes
