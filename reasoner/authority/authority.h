// Who may say what: the axioms of a document about terms that are another's.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/authority/ownership.h"

namespace lares::authority {

struct Trespass {
  rdf::Triple axiom;
  rdf::TermId term{};               // what it adds to
  std::vector<std::string> owners;  // whose that is: names of graphs
};

struct JudgeOptions {
  // Classes that the document is there to describe: it may say by restrictions what each of their
  // instances has (some values, a value).
  std::unordered_set<rdf::TermId> described;
};

// The axioms of `graph` that add to terms which others own and that `known` neither states nor
// entails, in the order of the graph. What nobody of `owners` declares is the document's own.
std::vector<Trespass> FindTrespasses(const rdf::View& known, const rdf::Graph& graph,
                                     const Owners& owners, const JudgeOptions& options = {});

// The classes that an object model's document describes: those that it provides models for, and the
// parts that its restrictions on them name.
std::unordered_set<rdf::TermId> ModelledClasses(const rdf::Graph& graph,
                                                rdf::Dictionary& dictionary);

}  // namespace lares::authority
