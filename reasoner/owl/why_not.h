// Why a triple does not hold: what would have to be said for it to follow.
#pragma once

#include <cstddef>
#include <optional>
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
  // What it would rest on and holds already, schema included. Of an axiom that nothing leads to:
  // the nearest that holds, its other way round or the named classes that both are below.
  std::vector<rdf::Triple> held;
  std::vector<std::string>
      rules;             // by which it would follow, the last step first; none for an axiom
  std::size_t near = 0;  // how many of `held` speak of more than classes
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
// part of what they ask for holds). Only data may be missing: no axioms are invented. An axiom that
// is asked for (subclass, subproperty, equivalent, domain, range) is what is missing itself; of a
// subclass the superclasses that come nearest are told too. `view` must be closed, and `goal` not
// in it. Bounded, so not finding a way does not say there is none.
std::vector<Lack> WhyNot(const rdf::View& view, const rdf::Triple& goal,
                         const WhyNotOptions& options = {});

// "Cup1 a Metal", "something a Cavity", "Cup1 hasCavity something".
std::string PhraseOf(const Atom& missing, const rdf::View& view);
// The same for an axiom; nothing when `goal` is none. What WhyNot gives.
std::optional<std::vector<Lack>> WhyNoAxiom(const rdf::View& view, const rdf::Triple& goal);

// One sentence or several: "cup1 would be a Container if: …", numbered when there are several.
std::string ToText(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view);
// {"goal", "triple", "lacks": [{"missing": [{"text", "triple": [terms, "?n" for variables]}],
// "held": [texts], "rules"}]}
std::string ToJson(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view);

}  // namespace lares::owl
