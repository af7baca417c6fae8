// What is asked for with a plan, before the rules see it.
#pragma once

#include <map>
#include <string>

#include "ontology/triples/view.h"
#include "reasoner/prolog/value.h"

namespace lares::recipes {

// What a written value may mean in `view`: for each name (and each part of a list, separated by
// commas) the class and the individual that go by it, by IRI, local name or label. Throws
// kAmbiguous with the candidates when several classes, or several individuals, go equally well by
// one name. The Prolog form is a list of given{name, text, class, thing, items} (parameters.pl).
prolog::Value ToGiven(const rdf::View& view, const std::map<std::string, std::string>& set);

}  // namespace lares::recipes
