// Whether a view holds what a graph says, blank nodes standing for anything.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::authority {

// Simple entailment (RDF 1.1 Semantics, section 5) of single triples with the structure below their
// blank nodes: a restriction or a list that a document repeats is found again, whatever its nodes
// are called. A blank node's structure is every triple of the graph that has it as subject, and so
// on. One thread; holds references to both arguments.
class StructureMatch {
 public:
  StructureMatch(const rdf::View& view, const rdf::Graph& graph) : view_(view), graph_(graph) {}

  // Whether `view` holds `triple` under some choice of terms for the graph's blank nodes. False,
  // too, when the search takes more than `max_steps`, or all searches together too many: such
  // structures are not what people repeat.
  bool Holds(const rdf::Triple& triple, std::size_t max_steps = 100'000);

 private:
  using Choice = std::map<rdf::TermId, rdf::TermId>;  // blank node of the graph → term of the view

  bool IsBlank(rdf::TermId term) const;
  // Pushes the triples that have `node` as subject.
  void AddStructure(rdf::TermId node, std::vector<rdf::Triple>& open) const;
  bool Solve(std::vector<rdf::Triple> open, Choice& choice);

  const rdf::View& view_;
  const rdf::Graph& graph_;
  std::size_t steps_ = 0;
  std::size_t budget_ = 2'000'000;  // steps of all searches together
};

}  // namespace lares::authority
