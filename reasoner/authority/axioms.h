// Which triples are axioms, and about which terms: the table of docs/authority.md as code.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "ontology/triples/graph.h"

namespace lares::authority {

// What a triple adds to, by its predicate (and, for rdf:type, its object).
enum class Weight {
  kNone,         // an assertion, an annotation, or a part of an anonymous expression
  kDeclaration,  // says what kind of term its subject is: "a owl:Class"
  kSubject,      // adds to its subject: C ⊑ D, domain, a characteristic, hasKey, a chain
  kBoth,         // adds to both sides: equivalence, inverse
  kExclusion,    // lets nothing be both sides at once: disjointness
  kMembers,      // the same for each two members of a list
  kUnion,        // adds its subject and puts the members of a list below it
};

// The words of RDFS and OWL that decide. Immutable after construction; thread-safe.
class AxiomTable {
 public:
  explicit AxiomTable(rdf::Dictionary& dictionary);

  Weight WeightOf(const rdf::Triple& triple) const;
  // A term of RDF, RDFS, OWL or XML Schema: nobody's.
  bool IsBuiltIn(rdf::TermId term) const;
  // Whether a triple with this predicate makes its blank subject an expression: owl:intersectionOf,
  // owl:onProperty ….
  bool IsExpressionPart(rdf::TermId predicate) const {
    return expression_parts_.count(predicate) != 0;
  }
  // Whether a term is the object of a declaration that makes properties.
  bool MakesProperties(rdf::TermId kind) const { return property_kinds_.count(kind) != 0; }
  bool MakesClasses(rdf::TermId kind) const { return class_kinds_.count(kind) != 0; }

  rdf::TermId type, first, rest, nil, union_of, thing, sub_class_of, on_property, some_values_from,
      has_value, equivalent_class, intersection_of;

 private:
  const rdf::Dictionary& dictionary_;
  std::unordered_map<rdf::TermId, Weight> by_predicate_;
  std::unordered_set<rdf::TermId> class_kinds_, property_kinds_, characteristics_,
      expression_parts_;
};

}  // namespace lares::authority
