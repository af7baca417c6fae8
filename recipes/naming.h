// How things of the knowledge are named in answers and sentences: the one place that decides it.
#pragma once

#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/value.h"
#include "recipes/resource.h"

namespace lares::recipes {

// An empty IRI gives an empty Resource.
Resource MakeResource(const rdf::View& view, const std::string& iri);
std::vector<Resource> MakeResources(const rdf::View& view, const prolog::Value& iris);

// What the rules return as a sentence: a string, or a list of strings, name(Iri) (label and IRI as
// written), label(Iri) and phrase(Iri) (the local name of a property as words).
std::string MakeSentence(const rdf::View& view, const prolog::Value& sentence);
std::vector<std::string> MakeSentences(const rdf::View& view, const prolog::Value& sentences);

// "inReachOf" → "in reach of", "inFrontOf-Generally" → "in front of".
std::string Phrase(std::string_view iri);

}  // namespace lares::recipes
