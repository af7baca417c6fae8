// Checks proofs step by step against the tables of W3C OWL 2 Profiles, section 4.3.
#pragma once

#include <string>

#include "ontology/triples/view.h"
#include "reasoner/owl/proof.h"

namespace lares::testing {

// Empty when each leaf is asserted by exactly the graphs that it names, each step is an instance of
// the rule that it names in the table that it names, and rests on earlier nodes only, each triple
// is there once and all of it serves the conclusion. Otherwise what is wrong first. The rules are
// written out here by hand and share nothing with the engine's.
std::string CheckProof(const owl::Proof& proof, const rdf::View& view);

}  // namespace lares::testing
