// The constructs of OWL 2 (Structural Specification, W3C 2012) and the shape in which each becomes
// triples (Mapping to RDF Graphs, table 1), in one table for both directions and both syntaxes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ontology/rdf/owl_syntax/words.h"

namespace lares::rdf {

enum class Construct : std::uint8_t {
  kClass,
  kDatatype,
  kObjectProperty,
  kDataProperty,
  kAnnotationProperty,
  kNamedIndividual,
  kAnnotation,
  kObjectInverseOf,
  kObjectPropertyChain,
  kFacetRestriction,
  kObjectProperties,
  kDataProperties,
  kObjectIntersectionOf,
  kObjectUnionOf,
  kObjectComplementOf,
  kObjectOneOf,
  kObjectSomeValuesFrom,
  kObjectAllValuesFrom,
  kObjectHasValue,
  kObjectHasSelf,
  kObjectMinCardinality,
  kObjectMaxCardinality,
  kObjectExactCardinality,
  kDataSomeValuesFrom,
  kDataAllValuesFrom,
  kDataHasValue,
  kDataMinCardinality,
  kDataMaxCardinality,
  kDataExactCardinality,
  kDataIntersectionOf,
  kDataUnionOf,
  kDataComplementOf,
  kDataOneOf,
  kDatatypeRestriction,
  kDeclaration,
  kSubClassOf,
  kEquivalentClasses,
  kDisjointClasses,
  kDisjointUnion,
  kSubObjectPropertyOf,
  kEquivalentObjectProperties,
  kDisjointObjectProperties,
  kObjectPropertyDomain,
  kObjectPropertyRange,
  kInverseObjectProperties,
  kFunctionalObjectProperty,
  kInverseFunctionalObjectProperty,
  kReflexiveObjectProperty,
  kIrreflexiveObjectProperty,
  kSymmetricObjectProperty,
  kAsymmetricObjectProperty,
  kTransitiveObjectProperty,
  kSubDataPropertyOf,
  kEquivalentDataProperties,
  kDisjointDataProperties,
  kDataPropertyDomain,
  kDataPropertyRange,
  kFunctionalDataProperty,
  kDatatypeDefinition,
  kHasKey,
  kSameIndividual,
  kDifferentIndividuals,
  kClassAssertion,
  kObjectPropertyAssertion,
  kNegativeObjectPropertyAssertion,
  kDataPropertyAssertion,
  kNegativeDataPropertyAssertion,
  kAnnotationAssertion,
  kSubAnnotationPropertyOf,
  kAnnotationPropertyDomain,
  kAnnotationPropertyRange,
  kNone  // no construct: an IRI whose kind only its position tells
};

enum class Category : std::uint8_t {
  kEntity,
  kAnnotation,
  kProperty,
  kChain,
  kFacet,
  kGroup,  // the two lists of HasKey
  kClass,
  kDataRange,
  kAxiom,
};

// How a construct becomes triples; what is none of these has code of its own.
enum class Shape : std::uint8_t {
  kSpecial,
  kTriple,       // first predicate second
  kType,         // first rdf:type type
  kPairs,        // each predicate the next one
  kPairOrAll,    // two: a triple; more: a node of the type with owl:members
  kList,         // a node of the type: predicate (list of all)
  kComplement,   // a node of the type: predicate first
  kRestriction,  // a restriction on all but the last: predicate last
  kCardinality,  // a restriction: number, property and perhaps a filler
};

struct ConstructInfo {
  Construct construct;
  std::string_view name;
  Category category;
  // One letter for each argument; "?" after one: it may be absent, "*": any number, "+": at least
  // one. At most one letter of a construct has such a mark.
  //   C class expression, P object property expression, D data property, A annotation property,
  //   R data range, I individual, L literal, n number, U IRI, S IRI or anonymous individual,
  //   V annotation value, E entity, c class, p object property, t datatype, F facet restriction,
  //   X property expression or chain, k object properties, K data properties
  std::string_view roles;
  Shape shape;
  Word predicate;
  Word type;
};

const ConstructInfo& InfoOf(Construct construct);
std::optional<Construct> ConstructNamed(std::string_view name);
// "a class expression", for messages.
std::string_view DescribeRole(char role);

// The letters of `info.roles` for `count` arguments; nothing when it cannot have so many.
std::optional<std::string> RolesFor(const ConstructInfo& info, std::size_t count);

// The construct of `shape` that has this predicate and type, and a first role of `role` (for
// kRestriction and kCardinality also telling object from data).
std::optional<Construct> FindConstruct(Shape shape, Word predicate, Word type, char role);

}  // namespace lares::rdf
