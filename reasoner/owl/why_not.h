// Why a triple does not hold: what would have to be said for it to follow.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {

// One way in which the triple would follow.
struct Lack {
  // What is missing; variables (the same number is the same thing throughout) stand for anything.
  std::vector<Atom> missing;
  std::vector<rdf::Triple> held;   // what it would rest on and holds already, schema included
  std::vector<std::string> rules;  // by which it would follow, the last step first
  std::size_t near = 0;            // how many of `held` speak of more than classes
};

struct WhyNotOptions {
  std::size_t max_lacks = 10;
  std::size_t max_missing = 3;     // of one way
  std::size_t max_depth = 4;       // rules in a row
  std::size_t max_work = 200'000;  // ways tried; those found by then are given
  std::stop_token stop;            // kTimeout
};

// The ways with the fewest missing premises first, of these the ones with most that holds already.
// Anonymous classes are taken apart, named ones are left as premises (and taken apart too where a
// part of what they ask for holds). Only data may be missing: no axioms are invented. `view` must
// be closed, and `goal` not in it. Bounded, so not finding a way does not say there is none.
std::vector<Lack> WhyNot(const rdf::View& view, const rdf::Triple& goal,
                         const WhyNotOptions& options = {});

// "Cup1 a Metal", "something a Cavity", "Cup1 hasCavity something".
std::string PhraseOf(const Atom& missing, const rdf::View& view);
// One sentence or several: "cup1 would be a Container if: …", numbered when there are several.
std::string ToText(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view);
// {"goal", "triple", "lacks": [{"missing": [{"text", "triple": [terms, "?n" for variables]}],
// "held": [texts], "rules"}]}
std::string ToJson(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view);

}  // namespace lares::owl
