#include "ontology/rdf/owl_syntax/words.h"

#include <array>
#include <unordered_map>

#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

struct Row {
  Word word;
  std::string_view iri;
};

constexpr std::array<Row, static_cast<std::size_t>(Word::kCount)> kRows = {{
    {Word::kNone, ""},
    {Word::kRdfType, "http://www.w3.org/1999/02/22-rdf-syntax-ns#type"},
    {Word::kRdfFirst, "http://www.w3.org/1999/02/22-rdf-syntax-ns#first"},
    {Word::kRdfRest, "http://www.w3.org/1999/02/22-rdf-syntax-ns#rest"},
    {Word::kRdfNil, "http://www.w3.org/1999/02/22-rdf-syntax-ns#nil"},
    {Word::kRdfList, "http://www.w3.org/1999/02/22-rdf-syntax-ns#List"},
    {Word::kRdfProperty, "http://www.w3.org/1999/02/22-rdf-syntax-ns#Property"},
    {Word::kRdfPlainLiteral, "http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral"},
    {Word::kRdfsSubClassOf, "http://www.w3.org/2000/01/rdf-schema#subClassOf"},
    {Word::kRdfsSubPropertyOf, "http://www.w3.org/2000/01/rdf-schema#subPropertyOf"},
    {Word::kRdfsDomain, "http://www.w3.org/2000/01/rdf-schema#domain"},
    {Word::kRdfsRange, "http://www.w3.org/2000/01/rdf-schema#range"},
    {Word::kRdfsClass, "http://www.w3.org/2000/01/rdf-schema#Class"},
    {Word::kRdfsDatatype, "http://www.w3.org/2000/01/rdf-schema#Datatype"},
    {Word::kRdfsLiteral, "http://www.w3.org/2000/01/rdf-schema#Literal"},
    {Word::kRdfsLabel, "http://www.w3.org/2000/01/rdf-schema#label"},
    {Word::kRdfsComment, "http://www.w3.org/2000/01/rdf-schema#comment"},
    {Word::kRdfsSeeAlso, "http://www.w3.org/2000/01/rdf-schema#seeAlso"},
    {Word::kRdfsIsDefinedBy, "http://www.w3.org/2000/01/rdf-schema#isDefinedBy"},
    {Word::kOwlOntology, "http://www.w3.org/2002/07/owl#Ontology"},
    {Word::kOwlVersionIRI, "http://www.w3.org/2002/07/owl#versionIRI"},
    {Word::kOwlImports, "http://www.w3.org/2002/07/owl#imports"},
    {Word::kOwlClass, "http://www.w3.org/2002/07/owl#Class"},
    {Word::kOwlObjectProperty, "http://www.w3.org/2002/07/owl#ObjectProperty"},
    {Word::kOwlDatatypeProperty, "http://www.w3.org/2002/07/owl#DatatypeProperty"},
    {Word::kOwlAnnotationProperty, "http://www.w3.org/2002/07/owl#AnnotationProperty"},
    {Word::kOwlOntologyProperty, "http://www.w3.org/2002/07/owl#OntologyProperty"},
    {Word::kOwlNamedIndividual, "http://www.w3.org/2002/07/owl#NamedIndividual"},
    {Word::kOwlRestriction, "http://www.w3.org/2002/07/owl#Restriction"},
    {Word::kOwlDataRange, "http://www.w3.org/2002/07/owl#DataRange"},
    {Word::kOwlDeprecatedClass, "http://www.w3.org/2002/07/owl#DeprecatedClass"},
    {Word::kOwlDeprecatedProperty, "http://www.w3.org/2002/07/owl#DeprecatedProperty"},
    {Word::kOwlThing, "http://www.w3.org/2002/07/owl#Thing"},
    {Word::kOwlNothing, "http://www.w3.org/2002/07/owl#Nothing"},
    {Word::kOwlTopObjectProperty, "http://www.w3.org/2002/07/owl#topObjectProperty"},
    {Word::kOwlBottomObjectProperty, "http://www.w3.org/2002/07/owl#bottomObjectProperty"},
    {Word::kOwlTopDataProperty, "http://www.w3.org/2002/07/owl#topDataProperty"},
    {Word::kOwlBottomDataProperty, "http://www.w3.org/2002/07/owl#bottomDataProperty"},
    {Word::kOwlReal, "http://www.w3.org/2002/07/owl#real"},
    {Word::kOwlRational, "http://www.w3.org/2002/07/owl#rational"},
    {Word::kOwlIntersectionOf, "http://www.w3.org/2002/07/owl#intersectionOf"},
    {Word::kOwlUnionOf, "http://www.w3.org/2002/07/owl#unionOf"},
    {Word::kOwlComplementOf, "http://www.w3.org/2002/07/owl#complementOf"},
    {Word::kOwlDatatypeComplementOf, "http://www.w3.org/2002/07/owl#datatypeComplementOf"},
    {Word::kOwlOneOf, "http://www.w3.org/2002/07/owl#oneOf"},
    {Word::kOwlOnProperty, "http://www.w3.org/2002/07/owl#onProperty"},
    {Word::kOwlOnProperties, "http://www.w3.org/2002/07/owl#onProperties"},
    {Word::kOwlSomeValuesFrom, "http://www.w3.org/2002/07/owl#someValuesFrom"},
    {Word::kOwlAllValuesFrom, "http://www.w3.org/2002/07/owl#allValuesFrom"},
    {Word::kOwlHasValue, "http://www.w3.org/2002/07/owl#hasValue"},
    {Word::kOwlHasSelf, "http://www.w3.org/2002/07/owl#hasSelf"},
    {Word::kOwlMinCardinality, "http://www.w3.org/2002/07/owl#minCardinality"},
    {Word::kOwlMaxCardinality, "http://www.w3.org/2002/07/owl#maxCardinality"},
    {Word::kOwlCardinality, "http://www.w3.org/2002/07/owl#cardinality"},
    {Word::kOwlMinQualifiedCardinality, "http://www.w3.org/2002/07/owl#minQualifiedCardinality"},
    {Word::kOwlMaxQualifiedCardinality, "http://www.w3.org/2002/07/owl#maxQualifiedCardinality"},
    {Word::kOwlQualifiedCardinality, "http://www.w3.org/2002/07/owl#qualifiedCardinality"},
    {Word::kOwlOnClass, "http://www.w3.org/2002/07/owl#onClass"},
    {Word::kOwlOnDataRange, "http://www.w3.org/2002/07/owl#onDataRange"},
    {Word::kOwlOnDatatype, "http://www.w3.org/2002/07/owl#onDatatype"},
    {Word::kOwlWithRestrictions, "http://www.w3.org/2002/07/owl#withRestrictions"},
    {Word::kOwlInverseOf, "http://www.w3.org/2002/07/owl#inverseOf"},
    {Word::kOwlEquivalentClass, "http://www.w3.org/2002/07/owl#equivalentClass"},
    {Word::kOwlDisjointWith, "http://www.w3.org/2002/07/owl#disjointWith"},
    {Word::kOwlDisjointUnionOf, "http://www.w3.org/2002/07/owl#disjointUnionOf"},
    {Word::kOwlAllDisjointClasses, "http://www.w3.org/2002/07/owl#AllDisjointClasses"},
    {Word::kOwlMembers, "http://www.w3.org/2002/07/owl#members"},
    {Word::kOwlPropertyChainAxiom, "http://www.w3.org/2002/07/owl#propertyChainAxiom"},
    {Word::kOwlEquivalentProperty, "http://www.w3.org/2002/07/owl#equivalentProperty"},
    {Word::kOwlPropertyDisjointWith, "http://www.w3.org/2002/07/owl#propertyDisjointWith"},
    {Word::kOwlAllDisjointProperties, "http://www.w3.org/2002/07/owl#AllDisjointProperties"},
    {Word::kOwlFunctionalProperty, "http://www.w3.org/2002/07/owl#FunctionalProperty"},
    {Word::kOwlInverseFunctionalProperty,
     "http://www.w3.org/2002/07/owl#InverseFunctionalProperty"},
    {Word::kOwlReflexiveProperty, "http://www.w3.org/2002/07/owl#ReflexiveProperty"},
    {Word::kOwlIrreflexiveProperty, "http://www.w3.org/2002/07/owl#IrreflexiveProperty"},
    {Word::kOwlSymmetricProperty, "http://www.w3.org/2002/07/owl#SymmetricProperty"},
    {Word::kOwlAsymmetricProperty, "http://www.w3.org/2002/07/owl#AsymmetricProperty"},
    {Word::kOwlTransitiveProperty, "http://www.w3.org/2002/07/owl#TransitiveProperty"},
    {Word::kOwlHasKey, "http://www.w3.org/2002/07/owl#hasKey"},
    {Word::kOwlSameAs, "http://www.w3.org/2002/07/owl#sameAs"},
    {Word::kOwlDifferentFrom, "http://www.w3.org/2002/07/owl#differentFrom"},
    {Word::kOwlAllDifferent, "http://www.w3.org/2002/07/owl#AllDifferent"},
    {Word::kOwlDistinctMembers, "http://www.w3.org/2002/07/owl#distinctMembers"},
    {Word::kOwlNegativePropertyAssertion,
     "http://www.w3.org/2002/07/owl#NegativePropertyAssertion"},
    {Word::kOwlSourceIndividual, "http://www.w3.org/2002/07/owl#sourceIndividual"},
    {Word::kOwlAssertionProperty, "http://www.w3.org/2002/07/owl#assertionProperty"},
    {Word::kOwlTargetIndividual, "http://www.w3.org/2002/07/owl#targetIndividual"},
    {Word::kOwlTargetValue, "http://www.w3.org/2002/07/owl#targetValue"},
    {Word::kOwlAxiom, "http://www.w3.org/2002/07/owl#Axiom"},
    {Word::kOwlAnnotation, "http://www.w3.org/2002/07/owl#Annotation"},
    {Word::kOwlAnnotatedSource, "http://www.w3.org/2002/07/owl#annotatedSource"},
    {Word::kOwlAnnotatedProperty, "http://www.w3.org/2002/07/owl#annotatedProperty"},
    {Word::kOwlAnnotatedTarget, "http://www.w3.org/2002/07/owl#annotatedTarget"},
    {Word::kOwlDeprecated, "http://www.w3.org/2002/07/owl#deprecated"},
    {Word::kOwlVersionInfo, "http://www.w3.org/2002/07/owl#versionInfo"},
    {Word::kOwlPriorVersion, "http://www.w3.org/2002/07/owl#priorVersion"},
    {Word::kOwlBackwardCompatibleWith, "http://www.w3.org/2002/07/owl#backwardCompatibleWith"},
    {Word::kOwlIncompatibleWith, "http://www.w3.org/2002/07/owl#incompatibleWith"},
    {Word::kXsdNonNegativeInteger, "http://www.w3.org/2001/XMLSchema#nonNegativeInteger"},
    {Word::kXsdBoolean, "http://www.w3.org/2001/XMLSchema#boolean"},
    {Word::kXsdString, "http://www.w3.org/2001/XMLSchema#string"},
}};

constexpr bool AreInOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].word != static_cast<Word>(i)) return false;
  }
  return true;
}
static_assert(AreInOrder());

}  // namespace

std::string_view IriOf(Word word) { return kRows[static_cast<std::size_t>(word)].iri; }

Word WordOf(std::string_view iri) {
  static const auto* const kWords = [] {
    auto* words = new std::unordered_map<std::string_view, Word>;
    for (const Row& row : kRows) words->emplace(row.iri, row.word);
    return words;
  }();
  if (!iri.starts_with("http://www.w3.org/")) return Word::kNone;
  const auto found = kWords->find(iri);
  return found == kWords->end() ? Word::kNone : found->second;
}

bool IsReserved(std::string_view iri) {
  return iri.starts_with(kOwl) || iri.starts_with(kRdfs) || iri.starts_with(kRdf);
}

bool IsBuiltInAnnotation(Word word) {
  switch (word) {
    case Word::kRdfsLabel:
    case Word::kRdfsComment:
    case Word::kRdfsSeeAlso:
    case Word::kRdfsIsDefinedBy:
    case Word::kOwlDeprecated:
    case Word::kOwlVersionInfo:
    case Word::kOwlPriorVersion:
    case Word::kOwlBackwardCompatibleWith:
    case Word::kOwlIncompatibleWith:
      return true;
    default:
      return false;
  }
}

bool IsBuiltInDatatype(std::string_view iri) {
  if (iri.starts_with(kXsd)) return true;
  const Word word = WordOf(iri);
  return word == Word::kRdfsLiteral || word == Word::kRdfPlainLiteral || word == Word::kOwlReal ||
         word == Word::kOwlRational || (iri.starts_with(kRdf) && iri.ends_with("#langString")) ||
         (iri.starts_with(kRdf) && iri.ends_with("#XMLLiteral"));
}

}  // namespace lares::rdf
