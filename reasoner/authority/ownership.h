// Whose a term is.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ontology/rdf/aliases.h"
#include "ontology/rdf/document.h"
#include "ontology/triples/graph.h"

namespace lares::authority {

// What one document may call its own. Terms are canonical: one that an alias renames is at once a
// term of the document that has its historic name in its namespace.
struct Claim {
  std::string graph;  // name of the document's graph
  // IRIs that its terms' names begin with, as written, without the '#' or '/' at the end.
  std::vector<std::string> namespaces;
  struct Name {
    rdf::TermId term{};
    std::string space;  // of `namespaces`; empty: the name is in none of them
  };
  std::vector<Name> declared;  // classes and properties that it declares or states axioms about
  bool shares = false;         // holds its namespaces together with others that share them
};

// The namespaces are the IRIs of the document's owl:Ontology nodes and its base.
Claim MakeClaim(const rdf::Document& document, const rdf::Graph& graph,
                const rdf::AliasTable& aliases, rdf::Dictionary& dictionary);
// Of a document in canonical names that shares the one namespace `space` with others.
Claim MakeSharedClaim(const rdf::Graph& graph, const std::string& space,
                      rdf::Dictionary& dictionary);

// A namespace is held by the first document that claims it. A term belongs to every document that
// declares it under a name in a namespace that it holds; when there is none, to the first that
// declares it at all.
class Owners {
 public:
  // In order of first come.
  void Add(const Claim& claim);

  // Graph names; empty when nobody declares it.
  std::vector<std::string> OwnersOf(rdf::TermId term) const;
  bool Owns(const std::string& graph, rdf::TermId term) const;

 private:
  std::unordered_map<std::string, std::string> holders_;  // namespace → graph
  std::unordered_map<rdf::TermId, std::vector<std::string>> by_name_;
  std::unordered_map<rdf::TermId, std::string> first_;
};

}  // namespace lares::authority
