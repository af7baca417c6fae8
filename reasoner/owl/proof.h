// A proof as data, and ways to write it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

struct ProofNode {
  rdf::Triple triple;  // empty for a contradiction
  // The rule that concludes it and its table in W3C OWL 2 Profiles, section 4.3; empty for a triple
  // that documents assert.
  std::string rule;
  int table = 0;
  std::vector<std::size_t> premises;  // earlier nodes, in the order of the rule
  std::vector<std::string> graphs;    // that assert it

  bool is_asserted() const { return rule.empty(); }
  bool is_contradiction() const { return triple == rdf::Triple{}; }
};

// A tree whose shared parts are there once: each node's premises stand before it, no triple is in
// two nodes, and the last node is what was to be proved.
struct Proof {
  std::vector<ProofNode> nodes;
  // Steps of the tree, in which what is used twice counts twice; at least steps().
  unsigned cost = 0;

  const ProofNode& conclusion() const { return nodes.back(); }
  // Nodes that a rule concludes.
  std::size_t steps() const;
};

// Numbered from the conclusion down, each step indented under what rests on it:
//   1. Cup1 is a Container — by cax-sco (table 7) from 2 and 3
//     2. …
std::string ToText(const Proof& proof, const rdf::View& view);
// {"conclusion": …, "steps": n, "nodes": [{"id", "triple", "text", "rule", "table", "premises",
// "graphs"}]}: the last node is the conclusion; "triple" holds N-Triples terms.
std::string ToJson(const Proof& proof, const rdf::View& view);
// A drawing: the conclusion on top, what it rests on below, documents' triples in green.
std::string ToSvg(const Proof& proof, const rdf::View& view);
// For Graphviz.
std::string ToDot(const Proof& proof, const rdf::View& view);

}  // namespace lares::owl
