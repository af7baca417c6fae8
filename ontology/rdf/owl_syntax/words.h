// The reserved vocabulary that OWL 2's mapping to RDF uses (OWL 2 Mapping to RDF Graphs, W3C 2012,
// and OWL 1 where the reverse mapping has to know it), as numbers.
#pragma once

#include <cstdint>
#include <string_view>

namespace lares::rdf {

enum class Word : std::uint8_t {
  kNone,  // any other term
  kRdfType,
  kRdfFirst,
  kRdfRest,
  kRdfNil,
  kRdfList,
  kRdfProperty,
  kRdfPlainLiteral,
  kRdfsSubClassOf,
  kRdfsSubPropertyOf,
  kRdfsDomain,
  kRdfsRange,
  kRdfsClass,
  kRdfsDatatype,
  kRdfsLiteral,
  kRdfsLabel,
  kRdfsComment,
  kRdfsSeeAlso,
  kRdfsIsDefinedBy,
  kOwlOntology,
  kOwlVersionIRI,
  kOwlImports,
  kOwlClass,
  kOwlObjectProperty,
  kOwlDatatypeProperty,
  kOwlAnnotationProperty,
  kOwlOntologyProperty,
  kOwlNamedIndividual,
  kOwlRestriction,
  kOwlDataRange,
  kOwlDeprecatedClass,
  kOwlDeprecatedProperty,
  kOwlThing,
  kOwlNothing,
  kOwlTopObjectProperty,
  kOwlBottomObjectProperty,
  kOwlTopDataProperty,
  kOwlBottomDataProperty,
  kOwlReal,
  kOwlRational,
  kOwlIntersectionOf,
  kOwlUnionOf,
  kOwlComplementOf,
  kOwlDatatypeComplementOf,
  kOwlOneOf,
  kOwlOnProperty,
  kOwlOnProperties,
  kOwlSomeValuesFrom,
  kOwlAllValuesFrom,
  kOwlHasValue,
  kOwlHasSelf,
  kOwlMinCardinality,
  kOwlMaxCardinality,
  kOwlCardinality,
  kOwlMinQualifiedCardinality,
  kOwlMaxQualifiedCardinality,
  kOwlQualifiedCardinality,
  kOwlOnClass,
  kOwlOnDataRange,
  kOwlOnDatatype,
  kOwlWithRestrictions,
  kOwlInverseOf,
  kOwlEquivalentClass,
  kOwlDisjointWith,
  kOwlDisjointUnionOf,
  kOwlAllDisjointClasses,
  kOwlMembers,
  kOwlPropertyChainAxiom,
  kOwlEquivalentProperty,
  kOwlPropertyDisjointWith,
  kOwlAllDisjointProperties,
  kOwlFunctionalProperty,
  kOwlInverseFunctionalProperty,
  kOwlReflexiveProperty,
  kOwlIrreflexiveProperty,
  kOwlSymmetricProperty,
  kOwlAsymmetricProperty,
  kOwlTransitiveProperty,
  kOwlHasKey,
  kOwlSameAs,
  kOwlDifferentFrom,
  kOwlAllDifferent,
  kOwlDistinctMembers,
  kOwlNegativePropertyAssertion,
  kOwlSourceIndividual,
  kOwlAssertionProperty,
  kOwlTargetIndividual,
  kOwlTargetValue,
  kOwlAxiom,
  kOwlAnnotation,
  kOwlAnnotatedSource,
  kOwlAnnotatedProperty,
  kOwlAnnotatedTarget,
  kOwlDeprecated,
  kOwlVersionInfo,
  kOwlPriorVersion,
  kOwlBackwardCompatibleWith,
  kOwlIncompatibleWith,
  kXsdNonNegativeInteger,
  kXsdBoolean,
  kXsdString,
  kCount
};

// The IRI; "" for kNone.
std::string_view IriOf(Word word);
// kNone for an IRI that is not listed.
Word WordOf(std::string_view iri);

// True for rdf:, rdfs: and owl: names, which an ontology may not use for its own terms.
bool IsReserved(std::string_view iri);
// Annotation properties that need no declaration (OWL 2 Structural Specification, table 6).
bool IsBuiltInAnnotation(Word word);
// xsd:*, rdfs:Literal, rdf:PlainLiteral, owl:real, …
bool IsBuiltInDatatype(std::string_view iri);

}  // namespace lares::rdf
